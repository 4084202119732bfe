//! Assembly of the bonds: blocks of an offset once, then scattered point by point.

use super::GridBonds;
use crate::bonds::{BondModel, Mat, block};
use crate::stiffness::BlockMatrix;
use std::array::from_fn;

impl<const D: usize, const M: usize, B: BondModel<D, M>> GridBonds<D, M, B> {
    /// Adds the blocks `BᵀCB` of all bonds.
    pub(super) fn assemble(&self, tangent: &mut BlockMatrix<D>) {
        // Blocks of the first point, of the pair, and of the second.
        let blocks: Vec<[Mat<D, D>; 3]> = self
            .classes
            .iter()
            .map(|class| {
                let rows = |sign: f64| -> Mat<M, D> {
                    from_fn(|m| from_fn(|c| class.half_mean[m][c] + sign * class.difference[m][c]))
                };
                let (first, second) = (rows(-1.0), rows(1.0));
                [(first, first), (first, second), (second, second)]
                    .map(|(a, b)| block(&a, &class.modulus, &b))
            })
            .collect();
        let mut diagonal = vec![[[0.0; D]; D]; self.lattice.points()];
        self.for_each_bond(|index, [i, j], factor| {
            let [first, pair, second] = blocks[index].map(|b| b.map(|row| row.map(|v| factor * v)));
            tangent.add(i, j, &pair);
            add(&mut diagonal[i], &first);
            add(&mut diagonal[j], &second);
        });
        diagonal.iter().enumerate().for_each(|(i, block)| tangent.add(i, i, block));
    }
}

fn add<const D: usize>(sum: &mut Mat<D, D>, part: &Mat<D, D>) {
    for r in 0..D {
        for c in 0..D {
            sum[r][c] += part[r][c];
        }
    }
}
