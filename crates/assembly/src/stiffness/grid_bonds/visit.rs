//! The bonds of a lattice one by one.

use super::GridBonds;
use super::chunks::Chunk;
use super::precision::Precision;
use crate::bonds::BondModel;
use std::array::from_fn;

impl<const D: usize, const M: usize, B: BondModel<D, M>> GridBonds<D, M, B> {
    /// Calls `visit` with every bond: index of its offset, its points, the factors of its measures, of which one is not zero.
    pub fn for_each_bond(&self, mut visit: impl FnMut(usize, [usize; 2], [f64; M])) {
        for chunk in self.chunks.all() {
            self.for_each_bond_of(chunk, &mut visit);
        }
    }

    /// Calls `visit` with every bond: index of its offset, its points, its moduli.
    pub fn for_each_with_moduli(&self, mut visit: impl FnMut(usize, [usize; 2], [f64; M])) {
        for chunk in self.chunks.all() {
            let classes = f64::classes_of(self, chunk);
            self.for_each_bond_of(chunk, &mut |index, ends, factors| {
                visit(index, ends, from_fn(|m| factors[m] * classes[index].modulus[m]));
            });
        }
    }

    /// The bonds whose lower points are those of a chunk.
    pub(super) fn for_each_bond_of(
        &self,
        chunk: &Chunk,
        visit: &mut impl FnMut(usize, [usize; 2], [f64; M]),
    ) {
        for (index, class) in f64::classes_of(self, chunk).iter().enumerate() {
            if class.modulus == [0.0; M] {
                continue;
            }
            let all: [_; M] = from_fn(|m| self.chunks.factors_of(chunk, (index, 0), m));
            self.lattice.shifted(chunk.line, &chunk.columns(), class.step, |columns, other| {
                let k = (columns.start - chunk.from) as usize;
                for (k, other) in (k..k + columns.len()).zip(other..) {
                    let factors: [f64; M] = all.map(|of| of.map_or(1.0, |of| of[k]));
                    if factors != [0.0; M] {
                        visit(index, [chunk.first as usize + k, other], factors);
                    }
                }
            });
        }
    }

    pub(super) fn count(&self) -> usize {
        let mut count = 0;
        for chunk in self.chunks.all() {
            for (index, class) in f64::classes_of(self, chunk).iter().enumerate() {
                self.lattice.shifted(chunk.line, &chunk.columns(), class.step, |columns, _| {
                    let k = (columns.start - chunk.from) as usize;
                    count += match chunk.is_plain() {
                        true if class.modulus == [0.0; M] => 0,
                        true => columns.len(),
                        false => (k..k + columns.len()).filter(|k| self.has(chunk, index, *k)).count(),
                    };
                });
            }
        }
        count
    }

    /// Moduli of the bond of an offset whose lower point is the k-th of a chunk.
    pub(super) fn moduli_of(&self, chunk: &Chunk, offset: usize, k: usize) -> [f64; M] {
        let own = &f64::classes_of(self, chunk)[offset].modulus;
        from_fn(|m| own[m] * self.chunks.factor(chunk, (offset, m), k))
    }

    /// Whether there is the bond of an offset whose lower point is the k-th of a chunk, if there is its other one.
    pub(super) fn has(&self, chunk: &Chunk, offset: usize, k: usize) -> bool {
        self.moduli_of(chunk, offset, k) != [0.0; M]
    }
}
