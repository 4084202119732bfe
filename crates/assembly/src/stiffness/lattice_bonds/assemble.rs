//! Assembly of the bonds of a lattice: rows of equal points once for all of them.

use super::super::BlockMatrix;
use super::{BondClass, CHUNK, LatticeBonds};
use crate::bonds::{BondModel, Mat, add, block};
use std::ops::Range;

impl<const D: usize, const M: usize, B: BondModel<D, M>> LatticeBonds<D, M, B> {
    /// Adds the blocks of all bonds.
    pub(super) fn assemble(&self, tangent: &mut BlockMatrix<D>) {
        let blocks = self.blocks();
        let steps: Vec<usize> = std::iter::once(0).chain(self.classes.iter().map(|c| c.step)).collect();
        let first = self.lattice.first;
        let mut point = 0;
        while point < self.lattice.count {
            let run = self.plain_run(point);
            let row = self.row(point, &blocks);
            if run.len() > 1 {
                tangent.add_repeated(first + run.start..first + run.end, &steps, &row);
                point = run.end;
            } else {
                for (index, (&step, block)) in steps.iter().zip(&row).enumerate() {
                    if index == 0 || self.weights.weight(index - 1, point) != 0.0 {
                        tangent.add(first + point, first + point + step, block);
                    }
                }
                point += 1;
            }
        }
    }

    /// Adds the diagonal blocks.
    pub(super) fn assemble_diagonal(&self, diagonal: &mut [Mat<D, D>]) {
        let (blocks, first) = (self.blocks(), self.lattice.first);
        let mut point = 0;
        while point < self.lattice.count {
            let end = self.plain_run(point).end.max(point + 1);
            let row = self.row(point, &blocks);
            diagonal[first + point..first + end].iter_mut().for_each(|block| add(block, &row[0]));
            point = end;
        }
    }

    /// Ranges of points all of whose bonds, as lower and as upper point, exist with factor one.
    fn is_plain(&self, point: usize) -> bool {
        self.classes.iter().enumerate().all(|(index, class)| {
            point >= class.step
                && self.weights.weight(index, point) == class.weight
                && self.weights.weight(index, point - class.step) == class.weight
        })
    }

    /// Points `begin..` that are all plain, tested by chunks where that is enough.
    fn plain_run(&self, begin: usize) -> Range<usize> {
        let longest = self.classes.iter().map(|c| c.step).max().unwrap_or(0);
        let mut end = begin;
        while end < self.lattice.count {
            let chunk = end / CHUNK;
            let whole = end.is_multiple_of(CHUNK)
                && end >= longest.max(CHUNK)
                && end + CHUNK + longest <= self.lattice.count
                && longest <= CHUNK
                && self.weights.is_plain(chunk)
                && self.weights.is_plain(chunk - 1);
            if whole {
                end += CHUNK;
            } else if self.is_plain(end) {
                end += 1;
            } else {
                break;
            }
        }
        begin..end
    }

    /// Blocks `B_iᵀCB_i`, `B_iᵀCB_j`, `B_jᵀCB_j` of every class.
    fn blocks(&self) -> Vec<[Mat<D, D>; 3]> {
        let of = |c: &BondClass<D, M>| {
            let (i, j) = (c.rows.first(), c.rows.second());
            [block(&i, &c.modulus, &i), block(&i, &c.modulus, &j), block(&j, &c.modulus, &j)]
        };
        self.classes.iter().map(of).collect()
    }

    /// Diagonal block of a point and the blocks to its upper neighbours, one per class.
    fn row(&self, point: usize, blocks: &[[Mat<D, D>; 3]]) -> Vec<Mat<D, D>> {
        let mut row = vec![[[0.0; D]; D]; 1 + blocks.len()];
        for (index, class) in self.classes.iter().enumerate() {
            let above = self.weights.weight(index, point) / class.weight;
            let below = match point.checked_sub(class.step) {
                Some(lower) => self.weights.weight(index, lower) / class.weight,
                None => 0.0,
            };
            for r in 0..D {
                for c in 0..D {
                    row[0][r][c] += above * blocks[index][0][r][c] + below * blocks[index][2][r][c];
                    row[1 + index][r][c] = above * blocks[index][1][r][c];
                }
            }
        }
        row
    }
}
