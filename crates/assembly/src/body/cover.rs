//! Parts of cells that closed curves enclose.

use super::geometry::Point;
use super::lattice::Cell;
use std::f64::consts::TAU;

/// Parts of cells nearer than this to none or all count as such: what rounding leaves of a border between two cells.
const WHOLE: f64 = 1e-6;

/// A piece of an edge within a cell.
#[derive(Clone, Copy, Debug)]
struct Piece {
    column: i32,
    /// Area between the piece and the right side of its cell, positive if it goes upwards.
    area: f64,
    /// How far it goes upwards.
    height: f64,
}

/// The cells that a simple polygon covers in part, among `0..columns` × `0..rows`, and how much of each, row by row.
///
/// Positions are in cells; cell `[i, j]` reaches from i to i + 1 and from j to j + 1. Exact but for rounding (Green's
/// theorem in every cell), and none of the parts is within [`WHOLE`] of 0 or 1.
pub(super) fn partly_covered([columns, rows]: [i32; 2], corners: &[Point]) -> Vec<(Cell, f64)> {
    let mut pieces: Vec<Vec<Piece>> = vec![Vec::new(); rows as usize];
    for (k, &b) in corners.iter().enumerate() {
        let a = corners[(k + corners.len() - 1) % corners.len()];
        let [low, high] = [a[1].min(b[1]).floor(), a[1].max(b[1]).ceil()];
        let within = |y: f64| y.clamp(0.0, f64::from(rows)) as i32;
        for row in within(low)..within(high) {
            let strip = [f64::from(row), f64::from(row + 1)];
            cut_by_columns(clipped(a, b, 1, strip), columns, &mut pieces[row as usize]);
        }
    }
    let mut found = Vec::new();
    for (row, pieces) in (0..rows).zip(&mut pieces) {
        covered_in_row(pieces, columns, &mut |column, part| found.push(([column, row], part)));
    }
    found
}

/// The part of a segment where a coordinate is between two values; of no length if there is none.
fn clipped(a: Point, b: Point, axis: usize, [low, high]: [f64; 2]) -> [Point; 2] {
    let at = |end: Point| {
        let value = end[axis].clamp(low, high);
        if value == end[axis] {
            return end;
        }
        // Both ends on one side of the strip are moved to the same position.
        let t = ((value - a[axis]) / (b[axis] - a[axis])).clamp(0.0, 1.0);
        let mut position = [0, 1].map(|k| a[k] + t * (b[k] - a[k]));
        position[axis] = value;
        position
    };
    [at(a), at(b)]
}

/// Enters a segment within one row of cells; what is left of the first column is in column −1.
fn cut_by_columns([a, b]: [Point; 2], columns: i32, pieces: &mut Vec<Piece>) {
    if a[1] == b[1] {
        return;
    }
    let column_of = |x: f64| x.floor().clamp(-1.0, f64::from(columns)) as i32;
    for column in column_of(a[0].min(b[0]))..=column_of(a[0].max(b[0])) {
        let left = if column < 0 { f64::NEG_INFINITY } else { f64::from(column) };
        let right = if column >= columns { f64::INFINITY } else { f64::from(column + 1) };
        let [p, q] = clipped(a, b, 0, [left, right]);
        let height = q[1] - p[1];
        let width = f64::from(column + 1) - 0.5 * (p[0] + q[0]);
        pieces.push(Piece { column, area: height * width, height });
    }
}

/// Visits the cells of a row that are covered in part.
fn covered_in_row(pieces: &mut [Piece], columns: i32, visit: &mut dyn FnMut(i32, f64)) {
    pieces.sort_by_key(|p| p.column);
    let mut enter = |column: i32, part: f64| {
        if (WHOLE..=1.0 - WHOLE).contains(&part) && (0..columns).contains(&column) {
            visit(column, part);
        }
    };
    // Everything to the right of an edge that goes upwards is covered once more, or once less.
    let (mut covered, mut next) = (0.0, 0);
    for part in pieces.chunk_by(|a, b| a.column == b.column) {
        let column = part[0].column;
        (next..column).for_each(|between| enter(between, f64::abs(covered)));
        enter(column, f64::abs(covered + part.iter().map(|p| p.area).sum::<f64>()));
        covered += part.iter().map(|p| p.height).sum::<f64>();
        next = (column + 1).max(0);
    }
}

/// Chords per cell that an arc passes.
const CHORDS: f64 = 16.0;

/// A polygon with the area of all positions within `radius` of a segment, all in cells: arcs are chords whose ends lie
/// beyond them by so much that a circle has its exact area, and the symmetries of the square.
pub(super) fn stadium(from: Point, to: Point, radius: f64) -> Vec<Point> {
    let half = 4.0 * (CHORDS * TAU / 8.0 * radius).ceil().max(8.0);
    let step = 0.5 * TAU / half;
    let reach = radius * (step / step.sin()).sqrt();
    let turn = if from == to { 0.0 } else { (to[1] - from[1]).atan2(to[0] - from[0]) };
    let arc = |centre: Point, start: f64| {
        (0..=half as usize).map(move |k| {
            let (sin, cos) = (start + k as f64 * step).sin_cos();
            // The sides of a slot begin at the ends of its arcs.
            let is_end = from != to && (k == 0 || k == half as usize);
            let reach = if is_end { radius } else { reach };
            [centre[0] + reach * cos, centre[1] + reach * sin]
        })
    };
    arc(to, turn - 0.25 * TAU).chain(arc(from, turn + 0.25 * TAU)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::f64::consts::PI;

    fn part(found: &[(Cell, f64)], cell: Cell) -> f64 {
        found.iter().find(|f| f.0 == cell).unwrap().1
    }

    #[test]
    fn parts_of_a_box_and_of_a_triangle() {
        // Beyond the cells on the left and below, in the middle of cells on the right and above.
        let corners = [[-3.5, -1.5], [2.25, -1.5], [2.25, 1.5], [-3.5, 1.5]];
        let found = partly_covered([4, 4], &corners);
        let expected = [([2, 0], 0.25), ([0, 1], 0.5), ([1, 1], 0.5), ([2, 1], 0.125)];
        assert_eq!(found, expected);
        // The diagonals of cells; clockwise.
        let found = partly_covered([3, 3], &[[0.0; 2], [0.0, 3.0], [3.0, 0.0]]);
        assert_eq!(found, [([2, 0], 0.5), ([1, 1], 0.5), ([0, 2], 0.5)]);
        assert!(partly_covered([2, 2], &[[0.0; 2], [2.0, 0.0], [2.0; 2], [0.0, 2.0]]).is_empty());
        assert!(partly_covered([2, 2], &[[5.0; 2], [7.0, 5.5], [6.0, 8.5]]).is_empty());
    }

    #[test]
    fn circles_and_slots_have_their_areas() {
        let area = |corners: &[Point]| {
            let found = partly_covered([60, 60], corners);
            let centres = |[i, j]: Cell| [f64::from(i) + 0.5, f64::from(j) + 0.5];
            let whole = |c: Cell| {
                let inside = corners.iter().enumerate().fold(false, |inside, (k, b)| {
                    let (a, p) = (corners[(k + corners.len() - 1) % corners.len()], centres(c));
                    let crossed = (a[1] > p[1]) != (b[1] > p[1])
                        && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
                    inside != crossed
                });
                inside && found.iter().all(|f| f.0 != c)
            };
            let all = (0..60).flat_map(|j| (0..60).map(move |i| [i, j]));
            found.iter().map(|f| f.1).sum::<f64>() + all.filter(|c| whole(*c)).count() as f64
        };
        assert!((area(&stadium([30.2, 29.1], [30.2, 29.1], 7.3)) / (PI * 7.3 * 7.3) - 1.0).abs() < 1e-7);
        let slot = stadium([20.2, 19.1], [32.2, 28.1], 4.3);
        assert!((area(&slot) / (PI * 4.3 * 4.3 + 15.0 * 8.6) - 1.0).abs() < 1e-4);
    }

    proptest! {
        #[test]
        fn parts_are_those_of_samples(x in prop::array::uniform6(-1.0..6.0f64)) {
            let corners = [[x[0], x[1]], [x[2], x[3]], [x[4], x[5]]];
            let found = partly_covered([5, 5], &corners);
            let turn = |a: Point, b: Point, p: Point| {
                (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0.0
            };
            let inside = |p: Point| {
                let sides = [0, 1, 2].map(|k| turn(corners[k], corners[(k + 1) % 3], p));
                sides == [true; 3] || sides == [false; 3]
            };
            for cell in (0..5).flat_map(|j| (0..5).map(move |i| [i, j])) {
                let at = |k: usize, s: i32| f64::from(cell[k]) + (f64::from(s) + 0.5) / 40.0;
                let hits = (0..40).flat_map(|a| (0..40).map(move |b| [a, b]));
                let count = hits.filter(|s| inside([at(0, s[0]), at(1, s[1])])).count() as f64 / 1600.0;
                match found.iter().find(|f| f.0 == cell) {
                    Some(_) => prop_assert!((part(&found, cell) - count).abs() < 0.05, "{:?}", cell),
                    None => prop_assert!(count == 0.0 || count == 1.0, "{:?} {}", cell, count),
                }
            }
        }
    }
}
