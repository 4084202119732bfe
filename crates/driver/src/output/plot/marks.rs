//! What lies over the cells of a map: isolines with their values, and arrows.

use super::map::text;
use std::fmt::Write;

/// Where a field has one value.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Isoline {
    /// The value.
    pub value: f64,
    /// Pieces of the line, in any order.
    pub segments: Vec<[[f64; 2]; 2]>,
}

/// From coordinates to tenths of pixels.
type Place<'a> = &'a dyn Fn([f64; 2]) -> [i64; 2];

/// Lengths in tenths of pixels: the head of an arrow, the shortest arrow, the room of a number.
const HEAD: f64 = 50.0;
const SHORTEST: f64 = 20.0;
const ROOM: [i64; 2] = [420, 160];

/// Draws isolines, and on each its value, where that lies on no other one.
pub(super) fn isolines(svg: &mut String, lines: &[Isoline], place: Place, label: &dyn Fn(f64) -> String) {
    let mut labels: Vec<([i64; 2], String)> = Vec::new();
    for line in lines {
        let mut path = String::new();
        for [from, to] in line.segments.iter().map(|ends| ends.map(place)) {
            let _ = write!(path, "M{} {}L{} {}", from[0], from[1], to[0], to[1]);
        }
        let _ = writeln!(
            svg,
            "<path d=\"{path}\" fill=\"none\" stroke=\"#333A44\" stroke-width=\"8\" stroke-linecap=\"round\"/>"
        );
        let middle = line.segments.len() / 2;
        let places =
            line.segments[middle..].iter().chain(&line.segments[..middle]).map(|ends| place(ends[0]));
        let is_free = |at: &[i64; 2]| {
            labels.iter().all(|(other, _)| (0..2).any(|k| (at[k] - other[k]).abs() > ROOM[k]))
        };
        if let Some(at) = places.into_iter().find(is_free) {
            labels.push((at, label(line.value)));
        }
    }
    // White around the digits keeps them apart from the line below.
    let halo = " paint-order=\"stroke\" stroke=\"#fff\" stroke-width=\"40\" stroke-linejoin=\"round\"";
    for (at, words) in labels {
        let [x, y] = at.map(|v| v as f64 / 10.0);
        text(svg, [x, y + 4.0], 11, "middle", halo, &words);
    }
}

/// Draws arrows, each from its first place to its second.
pub(super) fn arrows(svg: &mut String, arrows: &[[[f64; 2]; 2]], place: Place) {
    let mut path = String::new();
    for [from, to] in arrows.iter().map(|ends| ends.map(place)) {
        let along = [to[0] - from[0], to[1] - from[1]].map(|v| v as f64);
        let length = along[0].hypot(along[1]);
        if length < SHORTEST {
            continue;
        }
        let head = HEAD.min(0.5 * length) / length;
        let side = |sign: f64| {
            let [dx, dy] = [along[0] - sign * 0.5 * along[1], along[1] + sign * 0.5 * along[0]];
            [to[0] - (head * dx).round() as i64, to[1] - (head * dy).round() as i64]
        };
        let [a, b] = [side(1.0), side(-1.0)];
        let _ = write!(
            path,
            "M{} {}L{} {}M{} {}L{} {}L{} {}",
            from[0], from[1], to[0], to[1], a[0], a[1], to[0], to[1], b[0], b[1]
        );
    }
    if !path.is_empty() {
        // Dark on white is seen on every colour.
        for (color, width) in [("#fff", 22), ("#111418", 10)] {
            let _ = writeln!(
                svg,
                "<path d=\"{path}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\" stroke-linejoin=\"round\"/>"
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrows_end_in_heads_and_short_ones_are_left_out() {
        let place = |at: [f64; 2]| at.map(|v| (1000.0 * v) as i64);
        let mut svg = String::new();
        arrows(&mut svg, &[[[0.0, 0.0], [1.0, 0.0]], [[0.0, 0.0], [0.01, 0.0]]], &place);
        // The head is 50 long and as wide.
        assert_eq!(svg.matches("M0 0L1000 0M950 -25L1000 0L950 25\"").count(), 2, "{svg}");
        let mut none = String::new();
        arrows(&mut none, &[[[0.0, 0.0], [0.01, 0.0]]], &place);
        assert!(none.is_empty());
    }

    #[test]
    fn every_isoline_has_its_value_once_and_none_lies_on_another() {
        let place = |at: [f64; 2]| at.map(|v| v as i64);
        let line = |value: f64, y: f64| Isoline { value, segments: vec![[[0.0, y], [900.0, y]]] };
        let mut svg = String::new();
        isolines(&mut svg, &[line(1.0, 0.0), line(2.0, 50.0), line(3.0, 300.0)], &place, &|v| {
            format!("v{v}")
        });
        assert_eq!([1, 2, 3].map(|k| svg.matches(&format!(">v{k}<")).count()), [1, 0, 1], "{svg}");
        assert_eq!(svg.matches("<path").count(), 3);
    }
}
