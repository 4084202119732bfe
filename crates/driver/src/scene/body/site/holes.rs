//! Holes that take too much of a body, by what messages call them.

use peristat_assembly::body::{BorderPart, Hole, Outline};

/// Places along a side that are looked at.
const PLACES: usize = 200;

/// The holes without which there would be cells along a side; none if it has some.
pub(crate) fn that_remove_side(outline: &Outline, side: usize, spacing: f64) -> Vec<String> {
    let [low, high] = outline.bounds();
    let (axis, along) = (side / 2, 1 - side / 2);
    let inward = if side.is_multiple_of(2) { 0.5 } else { -0.5 } * spacing;
    let mut places = (0..PLACES).map(|k| {
        let mut place = [if side.is_multiple_of(2) { low[axis] } else { high[axis] } + inward; 2];
        place[along] = low[along] + (k as f64 + 0.5) / PLACES as f64 * (high[along] - low[along]);
        place
    });
    let places: Vec<[f64; 2]> = places.by_ref().filter(|place| in_border(outline, *place)).collect();
    if places.iter().any(|place| outline.contains(*place)) {
        return Vec::new();
    }
    named(outline, |hole| {
        // A box with this hole alone.
        let size = [high[0] - low[0], high[1] - low[1]];
        let alone = Outline::rectangle(low, size).ok().and_then(|mut outline| {
            outline.cut(Hole { name: None, shape: hole.shape.clone() }).ok()?;
            Some(outline)
        });
        alone.is_some_and(|alone| places.iter().any(|place| !alone.contains(*place)))
    })
}

/// The holes whose border is not all in the body, of which one or several together can part it.
pub(crate) fn that_cross_borders(outline: &Outline) -> Vec<String> {
    let crosses = |(number, hole): &(usize, &Hole)| {
        let inside: f64 = outline.hole_parts(*number).iter().map(BorderPart::length).sum();
        inside < (1.0 - 1e-6) * hole.shape.perimeter()
    };
    outline.holes().iter().enumerate().filter(crosses).map(|(number, hole)| name(number, hole)).collect()
}

/// Whether a place is inside the border, holes aside.
fn in_border(outline: &Outline, place: [f64; 2]) -> bool {
    outline.border().contains(place)
}

fn named(outline: &Outline, is_meant: impl Fn(&Hole) -> bool) -> Vec<String> {
    let holes = outline.holes().iter().enumerate().filter(|(_, hole)| is_meant(hole));
    holes.map(|(number, hole)| name(number, hole)).collect()
}

fn name(number: usize, hole: &Hole) -> String {
    match &hole.name {
        Some(name) => format!("the hole `{name}`"),
        None => format!("hole {}", number + 1),
    }
}
