//! Parts of cells that closed curves enclose.

use super::geometry::{Point, minus};
use std::f64::consts::TAU;

/// Areas within a cell: in all of it, below the diagonal that rises, and above the one that falls.
type Areas = [f64; 3];

/// A piece of an edge within a cell.
#[derive(Clone, Copy, Debug)]
struct Piece {
    column: i32,
    /// Areas between the piece and the right side of its cell, positive if it goes upwards.
    areas: Areas,
    /// Those in a cell to the right.
    beyond: Areas,
}

/// Part of a cell that is covered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Covered {
    /// Of the cell.
    pub(super) part: f64,
    /// Of its halves below the diagonal that rises and above the one that falls, per area of the half.
    pub(super) right: [f64; 2],
}

/// The cells that a simple polygon covers in part, among `0..columns` × `0..rows`, and how much of each, row by row.
///
/// Positions are in cells; cell `[i, j]` reaches from i to i + 1 and from j to j + 1. Exact but for rounding (Green's
/// theorem in every cell). TriangleParts nearer than `whole` to 0 or 1 are that: what rounding leaves of a border between two cells.
pub(super) fn partly_covered(
    [columns, rows]: [i32; 2],
    corners: &[Point],
    whole: f64,
) -> Vec<([i32; 2], Covered)> {
    let mut pieces: Vec<Vec<Piece>> = vec![Vec::new(); rows as usize];
    for (k, &b) in corners.iter().enumerate() {
        let a = corners[(k + corners.len() - 1) % corners.len()];
        let [low, high] = [a[1].min(b[1]).floor(), a[1].max(b[1]).ceil()];
        let within = |y: f64| y.clamp(0.0, f64::from(rows)) as i32;
        for row in within(low)..within(high) {
            let strip = [f64::from(row), f64::from(row + 1)];
            let ends = clipped(a, b, 1, strip).map(|[x, y]| [x, y - f64::from(row)]);
            cut_by_columns(ends, columns, &mut pieces[row as usize]);
        }
    }
    let mut found = Vec::new();
    for (row, pieces) in (0..rows).zip(&mut pieces) {
        covered_in_row(pieces, columns, &mut |column, covered| {
            if (whole..=1.0 - whole).contains(&covered.part) {
                found.push(([column, row], covered));
            }
        });
    }
    found
}

/// The part of a segment where a coordinate is between two values; of no length if there is none.
pub(super) fn clipped(a: Point, b: Point, axis: usize, [low, high]: [f64; 2]) -> [Point; 2] {
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
        let [p, q] = clipped(a, b, 0, [left, right]).map(|[x, y]| [x - f64::from(column), y]);
        let areas = [to_the_right(p, q), within_half(p, q, 0), within_half(p, q, 1)];
        let (height, middle) = (q[1] - p[1], 0.5 * (p[1] + q[1]));
        pieces.push(Piece { column, areas, beyond: [height, height * (1.0 - middle), height * middle] });
    }
}

/// Area between a segment and the right side of its cell.
fn to_the_right(p: Point, q: Point) -> f64 {
    (q[1] - p[1]) * (1.0 - 0.5 * (p[0] + q[0]))
}

/// The part of it in the half of the cell below the diagonal that rises, 0, or above the one that falls, 1.
fn within_half(p: Point, q: Point, half: usize) -> f64 {
    // How far a position is to the right of the diagonal, where all to its right belongs to the half.
    let diagonal = |y: f64| if half == 0 { y } else { 1.0 - y };
    let beyond = |at: Point| at[0] - diagonal(at[1]);
    let on_one_side = |p: Point, q: Point| match beyond(p) + beyond(q) > 0.0 {
        true => to_the_right(p, q),
        false => (q[1] - p[1]) * (1.0 - diagonal(0.5 * (p[1] + q[1]))),
    };
    let (from, to) = (beyond(p), beyond(q));
    if from * to >= 0.0 {
        return on_one_side(p, q);
    }
    let share = from / (from - to);
    let cut = [0, 1].map(|k| p[k] + share * (q[k] - p[k]));
    on_one_side(p, cut) + on_one_side(cut, q)
}

/// Visits the cells of a row that are covered in part.
fn covered_in_row(pieces: &mut [Piece], columns: i32, visit: &mut dyn FnMut(i32, Covered)) {
    pieces.sort_by_key(|p| p.column);
    let mut enter = |column: i32, areas: Areas| {
        let [part, below, above] = areas.map(f64::abs);
        if (0..columns).contains(&column) {
            visit(column, Covered { part, right: [2.0 * below, 2.0 * above] });
        }
    };
    let sum = |one: Areas, other: Areas| [0, 1, 2].map(|k| one[k] + other[k]);
    // Everything to the right of an edge that goes upwards is covered once more, or once less.
    let (mut covered, mut next) = ([0.0; 3], 0);
    for part in pieces.chunk_by(|a, b| a.column == b.column) {
        let column = part[0].column;
        (next..column).for_each(|between| enter(between, covered));
        enter(column, part.iter().map(|p| p.areas).fold(covered, sum));
        covered = part.iter().map(|p| p.beyond).fold(covered, sum);
        next = (column + 1).max(0);
    }
}

/// The part of a simple polygon on the left of all of some lines, each through two positions.
pub(super) fn left_of(corners: &[Point], lines: &[[Point; 2]]) -> Vec<Point> {
    let mut left = corners.to_vec();
    for [from, to] in lines {
        let d = minus(*to, *from);
        let height = |p: Point| d[0] * (p[1] - from[1]) - d[1] * (p[0] - from[0]);
        let sides = (0..left.len()).map(|k| (left[(k + left.len() - 1) % left.len()], left[k]));
        let clip = |(a, b): (Point, Point)| {
            let (at, to) = (height(a), height(b));
            let share = at / (at - to);
            let crossing = (at * to < 0.0).then(|| [0, 1].map(|k| a[k] + share * (b[k] - a[k])));
            crossing.into_iter().chain((to >= 0.0).then_some(b))
        };
        left = sides.flat_map(clip).collect();
    }
    left
}

/// Area of the part of a simple polygon on the left of all of some lines.
pub(super) fn area_within(corners: &[Point], lines: &[[Point; 2]]) -> f64 {
    let left = left_of(corners, lines);
    let twice = |k: usize| {
        let (a, b) = (minus(left[k], left[0]), minus(left[(k + 1) % left.len()], left[0]));
        a[0] * b[1] - a[1] * b[0]
    };
    0.5 * (0..left.len()).map(twice).sum::<f64>().abs()
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

    fn covered(found: &[([i32; 2], Covered)], cell: [i32; 2]) -> Covered {
        found.iter().find(|f| f.0 == cell).unwrap().1
    }

    fn parts(found: &[([i32; 2], Covered)]) -> Vec<([i32; 2], f64)> {
        found.iter().map(|(cell, covered)| (*cell, covered.part)).collect()
    }

    #[test]
    fn parts_of_a_box_and_of_a_triangle() {
        // Beyond the cells on the left and below, in the middle of cells on the right and above.
        let corners = [[-3.5, -1.5], [2.25, -1.5], [2.25, 1.5], [-3.5, 1.5]];
        let found = partly_covered([4, 4], &corners, 1e-6);
        let expected = [([2, 0], 0.25), ([0, 1], 0.5), ([1, 1], 0.5), ([2, 1], 0.125)];
        assert_eq!(parts(&found), expected);
        // The diagonals of cells; clockwise.
        let found = partly_covered([3, 3], &[[0.0; 2], [0.0, 3.0], [3.0, 0.0]], 1e-6);
        assert_eq!(parts(&found), [([2, 0], 0.5), ([1, 1], 0.5), ([0, 2], 0.5)]);
        assert!(found.iter().all(|f| f.1.right == [0.5, 0.0]));
        assert!(partly_covered([2, 2], &[[0.0; 2], [2.0, 0.0], [2.0; 2], [0.0, 2.0]], 1e-6).is_empty());
        assert!(partly_covered([2, 2], &[[5.0; 2], [7.0, 5.5], [6.0, 8.5]], 1e-6).is_empty());
    }

    #[test]
    fn areas_between_lines_are_clipped() {
        let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
        assert_eq!(area_within(&square, &[]), 4.0);
        // Below y = x, and right of x = 1.
        let lines = [[[3.0, 3.0], [0.0, 0.0]], [[1.0, 5.0], [1.0, 4.0]]];
        assert_eq!(area_within(&square, &lines), 1.5);
        assert_eq!(area_within(&square, &[[[9.0, 0.0], [9.0, -1.0]]]), 0.0);
    }

    #[test]
    fn circles_and_slots_have_their_areas() {
        let area = |corners: &[Point]| {
            let found = partly_covered([60, 60], corners, 1e-6);
            let centres = |[i, j]: [i32; 2]| [f64::from(i) + 0.5, f64::from(j) + 0.5];
            let whole = |c: [i32; 2]| {
                let inside = corners.iter().enumerate().fold(false, |inside, (k, b)| {
                    let (a, p) = (corners[(k + corners.len() - 1) % corners.len()], centres(c));
                    let crossed = (a[1] > p[1]) != (b[1] > p[1])
                        && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
                    inside != crossed
                });
                inside && found.iter().all(|f| f.0 != c)
            };
            let all = (0..60).flat_map(|j| (0..60).map(move |i| [i, j]));
            found.iter().map(|f| f.1.part).sum::<f64>() + all.filter(|c| whole(*c)).count() as f64
        };
        assert!((area(&stadium([30.2, 29.1], [30.2, 29.1], 7.3)) / (PI * 7.3 * 7.3) - 1.0).abs() < 1e-7);
        let slot = stadium([20.2, 19.1], [32.2, 28.1], 4.3);
        assert!((area(&slot) / (PI * 4.3 * 4.3 + 15.0 * 8.6) - 1.0).abs() < 1e-4);
    }

    proptest! {
        #[test]
        fn parts_are_those_of_samples(x in prop::array::uniform6(-1.0..6.0f64)) {
            let corners = [[x[0], x[1]], [x[2], x[3]], [x[4], x[5]]];
            let found = partly_covered([5, 5], &corners, 1e-6);
            let turn = |a: Point, b: Point, p: Point| {
                (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0.0
            };
            let inside = |p: Point| {
                let sides = [0, 1, 2].map(|k| turn(corners[k], corners[(k + 1) % 3], p));
                sides == [true; 3] || sides == [false; 3]
            };
            for cell in (0..5).flat_map(|j| (0..5).map(move |i| [i, j])) {
                let at = |k: usize, s: i32| f64::from(cell[k]) + (f64::from(s) + 0.5) / 40.0;
                let hits: Vec<[i32; 2]> = (0..40).flat_map(|a| (0..40).map(move |b| [a, b])).collect();
                let count = |within: &dyn Fn([i32; 2]) -> bool| {
                    hits.iter().filter(|s| within(**s) && inside([at(0, s[0]), at(1, s[1])])).count() as f64
                };
                let whole = count(&|_| true) / 1600.0;
                match found.iter().any(|f| f.0 == cell) {
                    true => {
                        let Covered { part, right } = covered(&found, cell);
                        prop_assert!((part - whole).abs() < 0.05, "{:?}", cell);
                        for (half, right) in right.into_iter().enumerate() {
                            let sampled = count(&|[a, b]| if half == 0 { a > b } else { a + b > 39 }) / 780.0;
                            prop_assert!((right - sampled).abs() < 0.1, "{:?} {} {}", cell, right, sampled);
                        }
                    }
                    false => prop_assert!(whole == 0.0 || whole == 1.0, "{:?} {}", cell, whole),
                }
            }
        }
    }
}
