//! What points near edges lack of the stiffness of those inside.
//!
//! Missing neighbours of a point mostly are all those of a row from some column on. Sums along the rows from their ends to
//! every column, made once, make what a point lacks a matter of rows instead of cells.

use super::super::neighbourhood::Neighbourhood;
use crate::body::{Cell, SquareLattice};
use crate::bonds::Mat;
use std::ops::Range;

/// `½ Uᵀ c U` of the bonds of an inner point, by the row and the column of the neighbour.
pub(super) struct Shares<const S: usize> {
    /// Rows and columns to either side.
    reach: i32,
    of: Vec<Mat<S, S>>,
    /// Sums over the cells to the left of a cell in its row; behind a row follows its sum.
    left: Vec<Mat<S, S>>,
}

impl<const S: usize> Shares<S> {
    /// `share` is that of an offset and of its opposite.
    pub(super) fn new<const M: usize>(
        neighbourhood: &Neighbourhood<M>,
        share: impl Fn(usize) -> Mat<S, S>,
    ) -> Self {
        let reach = neighbourhood.reach();
        let side = (2 * reach + 1) as usize;
        let mut of = vec![[[0.0; S]; S]; side * side];
        for k in neighbourhood.bonded() {
            let [a, b, _] = neighbourhood.offsets[k];
            let place = |a: i32, b: i32| (b + reach) as usize * side + (a + reach) as usize;
            of[place(a, b)] = share(k);
            of[place(-a, -b)] = share(k);
        }
        let mut left = Vec::with_capacity(side * (side + 1));
        for row in of.chunks(side) {
            let mut sum = [[0.0; S]; S];
            for one in row {
                left.push(sum);
                add(&mut sum, 1.0, one);
            }
            left.push(sum);
        }
        Self { reach, of, left }
    }

    /// That of an offset.
    pub(super) fn of_offset(&self, [column, row, _]: Cell) -> &Mat<S, S> {
        &self.of[self.place(column, row)]
    }

    /// `½ Σ (a_i − f_ij) Uᵀ c U` with the part a_i of its cell and the factors `f_ij = min(a_i, a_j)` of its bonds, zero
    /// where they are missing; none where nothing is missing.
    pub(super) fn deficit(&self, lattice: &SquareLattice, cell: Cell) -> Option<Mat<S, S>> {
        let (reach, [column, row, layer]) = (self.reach, cell);
        let own = lattice.number(cell).map_or(1.0, |p| lattice.fraction(p));
        let lack = |part: f64| (own - part).max(0.0);
        let mut sum = [[0.0; S]; S];
        for b in -reach..=reach {
            let mut from = -reach;
            for run in lattice.runs_of(row + b, layer) {
                let start = (run.columns.start - column).max(from);
                let end = (run.columns.end - column).min(reach + 1);
                if start >= end {
                    continue;
                }
                self.add_row(b, from..start, own, &mut sum);
                self.add_row(b, start..end, lack(1.0), &mut sum);
                let points = run.number(start + column)..run.number(start + column) + (end - start) as usize;
                for &(point, part) in lattice.cut_cells_of(points.clone()) {
                    let a = start + (point as usize - points.start) as i32;
                    add(&mut sum, lack(part) - lack(1.0), &self.of[self.place(a, b)]);
                }
                from = end;
            }
            self.add_row(b, from..reach + 1, own, &mut sum);
        }
        (sum != [[0.0; S]; S]).then_some(sum)
    }

    /// Adds `times` the shares of columns of a row. Ends of rows are not differences of sums: what is small is not lost.
    fn add_row(&self, row: i32, columns: Range<i32>, times: f64, sum: &mut Mat<S, S>) {
        let width = 2 * self.reach as usize + 2;
        let left = |row: i32, column: i32| {
            &self.left[(row + self.reach) as usize * width + (column + self.reach) as usize]
        };
        if columns.is_empty() || times == 0.0 {
            return;
        }
        if columns.start == -self.reach {
            add(sum, times, left(row, columns.end));
        } else if columns.end == self.reach + 1 {
            // To the right of a cell is to the left of the opposite one.
            add(sum, times, left(-row, 1 - columns.start));
        } else {
            columns.for_each(|column| add(sum, times, &self.of[self.place(column, row)]));
        }
    }

    fn place(&self, column: i32, row: i32) -> usize {
        (row + self.reach) as usize * (2 * self.reach as usize + 1) + (column + self.reach) as usize
    }
}

fn add<const S: usize>(sum: &mut Mat<S, S>, times: f64, share: &Mat<S, S>) {
    (0..S).for_each(|r| (0..S).for_each(|c| sum[r][c] += times * share[r][c]));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{minus, plus};

    /// Shares that tell all cells apart, of all neighbours within some spacings.
    fn numbered(reach: i32) -> (Neighbourhood<1>, Shares<1>) {
        let offsets = super::super::super::neighbourhood::half_offsets(f64::from(reach), 1);
        let weights: Vec<[f64; 1]> = (0..offsets.len()).map(|k| [1.0 + k as f64]).collect();
        let neighbourhood = Neighbourhood::new(&offsets, &weights, &vec![1.0; offsets.len()]);
        let shares = Shares::new(&neighbourhood, |k| [neighbourhood.weights[k]]);
        (neighbourhood, shares)
    }

    #[test]
    fn a_deficit_is_the_sum_over_all_that_is_missing() {
        let hole = |[i, j]: [i32; 2]| (i - 9).pow(2) + (j - 6).pow(2) < 5 || i + j < 4 || (i, j) == (15, 3);
        let areas = [
            ([9, 9, 0], 0.5),
            ([10, 9, 0], 0.25),
            ([0, 4, 0], 0.75),
            ([19, 0, 0], 0.125),
            ([7, 0, 0], 1.5),
            ([16, 8, 0], 1.25),
        ];
        let lattice = SquareLattice::plane(1.0, [0.0; 2], 0..20, 0..12, |c| !hole(c)).with_areas(&areas);
        for reach in [2, 3, 5, 30] {
            let (neighbourhood, shares) = numbered(reach);
            for point in 0..lattice.points() {
                let (cell, own) = (lattice.cell(point), lattice.fraction(point));
                let part = |c: Cell| lattice.number(c).map_or(0.0, |p| own.min(lattice.fraction(p)));
                let lacks = |k: usize| {
                    let both = [plus(cell, neighbourhood.offsets[k]), minus(cell, neighbourhood.offsets[k])];
                    both.map(|c| neighbourhood.weights[k][0] * (own - part(c))).iter().sum::<f64>()
                };
                // Parts are sums of powers of two: nothing rounds.
                let expected: f64 = neighbourhood.bonded().map(lacks).sum();
                assert_eq!(shares.deficit(&lattice, cell).map_or(0.0, |d| d[0][0]), expected, "{cell:?}");
            }
        }
    }
}
