//! Assembly of the bonds: blocks of an offset once, then scattered point by point.

use super::chunks::Chunk;
use super::{Class, GridBonds};
use crate::bonds::{BondModel, Mat, add, block};
use crate::stiffness::BlockMatrix;
use std::array::from_fn;

impl<const D: usize, const M: usize, B: BondModel<D, M>> GridBonds<D, M, B> {
    /// Adds the blocks `BᵀCB` of all bonds.
    pub(super) fn assemble(&self, tangent: &mut BlockMatrix<D>) {
        let blocks = self.blocks();
        let mut diagonal = vec![[[0.0; D]; D]; self.lattice.points()];
        for chunk in self.chunks.all() {
            self.for_each_bond_of(chunk, &mut |index, [i, j], factors| {
                let [first, pair, second] = self.times(&blocks, (chunk, index), factors);
                tangent.add(i, j, &pair);
                add(&mut diagonal[i], &first);
                add(&mut diagonal[j], &second);
            });
        }
        diagonal.iter().enumerate().for_each(|(i, block)| tangent.add(i, i, block));
    }

    /// Blocks of the first point, of the pair, and of the second, of every class.
    fn blocks(&self) -> Vec<[Mat<D, D>; 3]> {
        self.classes.iter().map(|class| blocks_of(class, &class.modulus)).collect()
    }

    /// Those of a bond with some factors, by its chunk and the index of its offset; `blocks` are those of all classes.
    fn times(
        &self,
        blocks: &[[Mat<D, D>; 3]],
        (chunk, index): (&Chunk, usize),
        factors: [f64; M],
    ) -> [Mat<D, D>; 3] {
        let class = chunk.table() * self.offsets + index;
        let factor = factors.first().copied().unwrap_or(1.0);
        if factors.iter().any(|other| *other != factor) {
            let class = &self.classes[class];
            return blocks_of(class, &from_fn(|m| factors[m] * class.modulus[m]));
        }
        blocks[class].map(|block| block.map(|row| row.map(|v| factor * v)))
    }

    /// Adds the diagonal blocks; where a chunk has all bonds they are those of its first point.
    pub(super) fn assemble_diagonal(&self, diagonal: &mut [Mat<D, D>]) {
        let blocks = self.blocks();
        let of_inner = |own: &[[Mat<D, D>; 3]]| {
            let mut all = [[0.0; D]; D];
            for [first, _, second] in own {
                add(&mut all, first);
                add(&mut all, second);
            }
            all
        };
        let inner: Vec<Mat<D, D>> = blocks.chunks(self.offsets.max(1)).map(of_inner).collect();
        for chunk in self.chunks.all() {
            let own = chunk.first as usize;
            if chunk.is_plain() && chunk.is_inner {
                let all = inner.get(chunk.table()).copied().unwrap_or([[0.0; D]; D]);
                diagonal[own..own + chunk.width as usize].iter_mut().for_each(|block| add(block, &all));
                continue;
            }
            self.for_each_stretch(chunk, |index, side, k, points, _| {
                let factors: [_; M] = from_fn(|m| self.chunks.factors_of(chunk, (index, side), m));
                for (k, point) in (k..).zip(points) {
                    let factors = factors.map(|of| of.map_or(1.0, |of| of[k]));
                    add(&mut diagonal[point], &self.times(&blocks, (chunk, index), factors)[2 * side]);
                }
            });
        }
    }
}

/// Blocks of the first point, of the pair, and of the second, of a bond with some moduli.
fn blocks_of<const D: usize, const M: usize>(class: &Class<D, M>, moduli: &[f64; M]) -> [Mat<D, D>; 3] {
    let rows = |sign: f64| -> Mat<M, D> {
        from_fn(|m| from_fn(|c| class.half_mean[m][c] + sign * class.difference[m][c]))
    };
    let (first, second) = (rows(-1.0), rows(1.0));
    [(first, first), (first, second), (second, second)].map(|(a, b)| block(&a, moduli, &b))
}
