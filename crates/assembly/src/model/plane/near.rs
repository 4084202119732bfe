//! Points near edges, found by runs: the others are never visited.

use crate::body::{Cell, SquareLattice};
use std::ops::Range;

/// Numbers of the points that lack a cell within `reach` rows and columns, in order.
pub(in super::super) fn near_points(lattice: &SquareLattice, reach: i32) -> Vec<usize> {
    let mut near = Vec::new();
    for run in lattice.runs() {
        let mut inner: Vec<Range<i32>> = vec![run.columns.clone()];
        for row in run.row - reach..=run.row + reach {
            let mut left = Vec::new();
            for other in lattice.runs_of(row) {
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
    let sign = if forwards { 1 } else { -1 };
    [cell[0] + sign * step[0], cell[1] + sign * step[1]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_points_lack_a_cell() {
        let hole = |[i, j]: Cell| (i - 14).pow(2) + (j - 9).pow(2) < 6 || i + j < 5;
        let lattice = SquareLattice::new(1.0, [0.0; 2], 0..30, 0..20, |c| !hole(c));
        for reach in 1..5 {
            let complete = |p: usize| {
                let [i, j] = lattice.cell(p);
                (-reach..=reach).all(|b| (-reach..=reach).all(|a| lattice.number([i + a, j + b]).is_some()))
            };
            let expected: Vec<usize> = (0..lattice.points()).filter(|&p| !complete(p)).collect();
            assert_eq!(near_points(&lattice, reach), expected);
        }
    }
}
