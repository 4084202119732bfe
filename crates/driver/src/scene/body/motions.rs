//! Free motions of a body in words.

use super::scene::BodyScene;
use super::site::holes;
use crate::diagnostic::tidy;
use crate::scene::words;
use peristat_assembly::body::Outline;
use peristat_assembly::model::{Model, RigidMotion};
use peristat_assembly::system::{FreeMotion, PartMotion};

/// What nothing holds, and how it would move.
pub(crate) fn describe<const D: usize>(
    scene: &BodyScene,
    model: &dyn Model<D>,
    motion: &FreeMotion,
) -> String {
    let (parts, motions) = (model.connected(), model.rigid_motions());
    // Number and sum of the positions of the real points of every part that moves.
    let mut sums = vec![(0_usize, [0.0; 3]); motion.parts.len()];
    let moving: Vec<usize> = motion.parts.iter().map(|span| parts.of(span[0])).collect();
    for point in scene.real_points() {
        if let Some(k) = moving.iter().position(|&part| part == parts.of(point)) {
            sums[k].0 += 1;
            (0..3).for_each(|c| sums[k].1[c] += model.position(point)[c]);
        }
    }
    let mut found: Vec<(usize, String)> = Vec::new();
    for (&(count, sum), part) in sums.iter().zip(&motion.moves).filter(|(s, _)| s.0 > 0) {
        let how = how(part, motions);
        let what = match count == scene.body().points() {
            true => "the body".to_string(),
            false => format!("the part of the body {},", around(scene, count, sum)),
        };
        found.push((count, format!("{what} is free to {how}")));
    }
    // The largest part first, two at most.
    found.sort_by_key(|t| std::cmp::Reverse(t.0));
    let more = found.len().saturating_sub(2);
    let mut text = found.into_iter().take(2).map(|t| t.1).collect::<Vec<_>>().join(", and ");
    if more > 0 {
        text += &format!(", and {more} more part{} with them", if more == 1 { "" } else { "s" });
    }
    format!("{text}: no support prevents it")
}

/// A part of the body that nothing holds at all, in words: `nothing holds the part of the body around (1, 2), 30 points`; none
/// of the whole body.
pub(crate) fn describe_loose<const D: usize>(
    scene: &BodyScene,
    model: &dyn Model<D>,
    motion: &FreeMotion,
) -> Option<String> {
    let parts = model.connected();
    let [span] = motion.parts[..] else { return None };
    let (mut count, mut sum) = (0_usize, [0.0; 3]);
    for point in scene.real_points().filter(|&point| parts.of(point) == parts.of(span[0])) {
        count += 1;
        (0..3).for_each(|c| sum[c] += model.position(point)[c]);
    }
    if count == 0 || count == scene.body().points() {
        return None;
    }
    let why = scene.outline().and_then(|outline| parted(outline, scene.is_damaged())).unwrap_or_default();
    Some(format!("{why}nothing holds the part of the body {}", around(scene, count, sum)))
}

/// What parts a body, where holes reach its border; cracks may do it alone or help them.
fn parted(outline: &Outline, has_cracks: bool) -> Option<String> {
    let holes = holes::that_cross_borders(outline);
    let who = if has_cracks { holes.join(", ") + " or a crack" } else { holes.join(" and ") };
    let verb = if holes.len() == 1 || has_cracks { "parts" } else { "part" };
    (!holes.is_empty()).then(|| format!("{who} {verb} the body: "))
}

/// Where the points of a part are, by their number and the sum of their positions, and how many.
fn around(scene: &BodyScene, count: usize, sum: [f64; 3]) -> String {
    // A tenth of a cell tells which part it is.
    let grain = 0.1 * scene.spacing();
    let place = words::place(sum.map(|s| (s / count as f64 / grain).round() * grain), scene.body());
    let points = if count == 1 { "1 point".into() } else { format!("{count} points") };
    format!("around {place}, {points}")
}

/// The last of the motions that it is made of, in words: a turn about some centre is one of translations, too.
fn how(part: &PartMotion, motions: &[RigidMotion]) -> String {
    let last = part.amounts.iter().rposition(|amount| *amount != 0.0).unwrap_or(0);
    let verb = motions[last].verb;
    let verb = verb.replace("{centre}", &centre(part, last));
    verb.replace("{direction}", &direction(part))
}

/// What rounding leaves beside a size is zero.
fn clean(value: f64, size: f64) -> f64 {
    if value.abs() < 1e-9 * size { 0.0 } else { value }
}

/// What a motion, the last of whose amounts is a turn, leaves where it is: a place of the plane, or an axis in space.
fn centre(part: &PartMotion, turn: usize) -> String {
    match *part.amounts.as_slice() {
        [a, b, c, x, y, z] => axis([a, b, c], [x, y, z], part.centre),
        [x, y, ..] => {
            let amount = part.amounts[turn];
            let centre = [part.centre[0] - y / amount, part.centre[1] + x / amount];
            let size = centre[0].abs().max(centre[1].abs());
            let [a, b] = centre.map(|c| tidy(clean(c, size)));
            format!("({a}, {b})")
        }
        _ => String::new(),
    }
}

/// The axis of a screw by its translation and its turn about a centre.
fn axis(moved: [f64; 3], turn: [f64; 3], centre: [f64; 3]) -> String {
    let squared: f64 = turn.iter().map(|t| t * t).sum();
    let cross = |k: usize| {
        let [next, last] = [(k + 1) % 3, (k + 2) % 3];
        turn[next] * moved[last] - turn[last] * moved[next]
    };
    let at = [0, 1, 2].map(|k| centre[k] + cross(k) / squared);
    let size = at.iter().fold(0.0, |a: f64, x| a.max(x.abs()));
    let [x, y, z] = at.map(|x| tidy(clean(x, size)));
    format!("the axis along {} through ({x}, {y}, {z})", along(&turn))
}

/// The direction of translations together.
fn direction(part: &PartMotion) -> String {
    match *part.amounts.as_slice() {
        // Of a body of revolution the one along the axis is left.
        [along_axis] => along(&[0.0, along_axis]),
        [x, y, z, ..] if part.amounts.len() == 6 => along(&[x, y, z]),
        [x, y, ..] => along(&[x, y]),
        [] => String::new(),
    }
}

/// A direction by the name of its axis, or by its components.
fn along(vector: &[f64]) -> String {
    let size = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
    let clean: Vec<f64> = vector.iter().map(|x| clean(*x, size)).collect();
    let parts: Vec<usize> = (0..clean.len()).filter(|&k| clean[k] != 0.0).collect();
    if let [axis] = parts[..] {
        return ["x", "y", "z"][axis].into();
    }
    let round = |v: &f64| format!("{}", (v / size * 1e6).round() / 1e6);
    format!("({})", clean.iter().map(round).collect::<Vec<_>>().join(", "))
}
