//! Assembly of the bonds: blocks of an offset once, then scattered point by point.

use super::{Class, GridBonds};
use crate::bonds::{BondModel, Mat, add, block};
use crate::stiffness::BlockMatrix;
use std::array::from_fn;

impl<const D: usize, const M: usize, B: BondModel<D, M>> GridBonds<D, M, B> {
    /// Adds the blocks `BᵀCB` of all bonds.
    pub(super) fn assemble(&self, tangent: &mut BlockMatrix<D>) {
        let blocks = self.blocks();
        let mut diagonal = vec![[[0.0; D]; D]; self.lattice.points()];
        self.for_each_bond(|index, [i, j], factor| {
            let [first, pair, second] = blocks[index].map(|b| b.map(|row| row.map(|v| factor * v)));
            tangent.add(i, j, &pair);
            add(&mut diagonal[i], &first);
            add(&mut diagonal[j], &second);
        });
        diagonal.iter().enumerate().for_each(|(i, block)| tangent.add(i, i, block));
    }

    /// Blocks of the first point, of the pair, and of the second, per offset.
    fn blocks(&self) -> Vec<[Mat<D, D>; 3]> {
        let of = |class: &Class<D, M>| {
            let rows = |sign: f64| -> Mat<M, D> {
                from_fn(|m| from_fn(|c| class.half_mean[m][c] + sign * class.difference[m][c]))
            };
            let (first, second) = (rows(-1.0), rows(1.0));
            [(first, first), (first, second), (second, second)].map(|(a, b)| block(&a, &class.modulus, &b))
        };
        self.classes.iter().map(of).collect()
    }

    /// Adds the diagonal blocks; where a chunk has all bonds they are those of its first point.
    pub(super) fn assemble_diagonal(&self, diagonal: &mut [Mat<D, D>]) {
        let blocks = self.blocks();
        let mut all = [[0.0; D]; D];
        for [first, _, second] in &blocks {
            add(&mut all, first);
            add(&mut all, second);
        }
        for chunk in self.chunks.all() {
            let own = chunk.first as usize;
            if chunk.is_plain() && chunk.is_inner {
                diagonal[own..own + chunk.width as usize].iter_mut().for_each(|block| add(block, &all));
                continue;
            }
            self.for_each_stretch(chunk, |index, side, k, points, _| {
                let factors = self.chunks.factors_of(chunk, index, side);
                for (step, point) in points.enumerate() {
                    let factor = factors.map_or(1.0, |f| f[k + step]);
                    add(&mut diagonal[point], &blocks[index][2 * side].map(|row| row.map(|v| factor * v)));
                }
            });
        }
    }
}
