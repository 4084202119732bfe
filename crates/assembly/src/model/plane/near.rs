//! Points near edges, found by runs: the others are never visited.

use crate::body::{Cell, SquareLattice, minus, plus};
use std::ops::Range;

/// Numbers of the points that lack a cell within `reach` rows and columns, and in a solid layers, in order.
pub(in super::super) fn near_points(lattice: &SquareLattice, reach: i32) -> Vec<usize> {
    let mut near = Vec::new();
    let layers = if lattice.is_plane() { 0 } else { reach };
    let lines: Vec<[i32; 2]> =
        (-layers..=layers).flat_map(|c| (-reach..=reach).map(move |b| [b, c])).collect();
    for run in lattice.runs() {
        let mut inner: Vec<Range<i32>> = vec![run.columns.clone()];
        for [row, layer] in &lines {
            let mut left = Vec::new();
            for other in lattice.runs_of(run.row + row, run.layer + layer) {
                let (start, end) = (other.columns.start + reach, other.columns.end - reach);
                for range in &inner {
                    let both = range.start.max(start)..range.end.min(end);
                    if !both.is_empty() {
                        left.push(both);
                    }
                }
            }
            left.sort_unstable_by_key(|r| r.start);
            inner = left;
        }
        let mut from = run.columns.start;
        for range in inner {
            near.extend((from..range.start).map(|column| run.number(column)));
            from = range.end;
        }
        near.extend((from..run.columns.end).map(|column| run.number(column)));
    }
    near
}

/// The cell at an offset, `forwards` or the opposite way.
pub(in super::super) fn at(cell: Cell, step: Cell, forwards: bool) -> Cell {
    if forwards { plus(cell, step) } else { minus(cell, step) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_points_lack_a_cell() {
        let hole = |[i, j]: [i32; 2]| (i - 14).pow(2) + (j - 9).pow(2) < 6 || i + j < 5;
        let plane = SquareLattice::plane(1.0, [0.0; 2], 0..30, 0..20, |c| !hole(c));
        let in_solid = |[i, j, k]: Cell| !hole([i, j]) || k > 6;
        let solid = SquareLattice::new(1.0, [0.0; 3], [0..30, 0..20, 0..8], in_solid);
        for (reach, (lattice, layers)) in (1..4).flat_map(|m| [(m, (&plane, 0)), (m, (&solid, m))]) {
            let steps: Vec<Cell> = (-layers..=layers)
                .flat_map(|c| (-reach..=reach).flat_map(move |b| (-reach..=reach).map(move |a| [a, b, c])))
                .collect();
            let lacks =
                |p: &usize| steps.iter().any(|s| lattice.number(plus(lattice.cell(*p), *s)).is_none());
            let expected: Vec<usize> = (0..lattice.points()).filter(lacks).collect();
            assert!(expected.len() < lattice.points());
            assert_eq!(near_points(lattice, reach), expected);
        }
    }
}
