//! Bonds that are measured one by one, and broken.

use super::precision::Precision;
use super::shares::measure;
use super::{CHUNK, GridBonds};
use crate::body::plus;
use crate::bonds::{BondModel, Mat, Rows};
use crate::stiffness::Bond;
use crate::stiffness::planes::planes;
use std::array::from_fn;

impl<const D: usize, const M: usize, B: BondModel<D, M>> GridBonds<D, M, B> {
    /// Calls `visit` with every bond: index of its offset, its points, the lower one first, and its measures.
    pub fn for_each_measured(&self, u: &[f64], mut visit: impl FnMut(usize, [usize; 2], [f64; M])) {
        let u = planes::<D, _>(u);
        for chunk in self.chunks.all() {
            for (index, class) in f64::classes_of(self, chunk).iter().enumerate() {
                self.lattice.shifted(chunk.line, &chunk.columns(), class.step, |columns, other| {
                    let (k, width) = ((columns.start - chunk.from) as usize, columns.len());
                    let own = chunk.first as usize + k;
                    let lower: [&[f64]; D] = from_fn(|c| &u[c][own..own + width]);
                    let upper: [&[f64]; D] = from_fn(|c| &u[c][other..other + width]);
                    let mut s = [[0.0; CHUNK]; M];
                    for m in 0..M {
                        measure::<D, M, B, f64>(class, m, [&lower, &upper], &mut s[m][..width]);
                    }
                    for l in 0..width {
                        if self.has(chunk, index, k + l) {
                            visit(index, [own + l, other + l], from_fn(|m| s[m][l]));
                        }
                    }
                });
            }
        }
    }

    /// One bond, by index of its offset and lower point; none where there is no such bond.
    pub fn bond(&self, offset: usize, lower: usize) -> Option<Bond<D, M>> {
        let (chunk, k) = self.chunks.of(lower);
        let class = &f64::classes_of(self, chunk)[offset];
        let upper = self.lattice.number(plus(self.lattice.cell(lower), class.step))?;
        let mean: Mat<M, D> = class.half_mean.map(|row| row.map(|v| 2.0 * v));
        let bond = Bond {
            points: [lower as u32, upper as u32],
            rows: Rows { difference: class.difference, mean },
            moduli: self.moduli_of(chunk, offset, k),
        };
        self.has(chunk, offset, k).then_some(bond)
    }

    /// Removes bonds, by index of their offset and lower point; those that are not there are ignored.
    pub fn break_bonds(&mut self, bonds: impl IntoIterator<Item = (usize, usize)>) {
        for (offset, lower) in bonds {
            let Some(bond) = self.bond(offset, lower) else { continue };
            self.chunks.multiply(2 * offset, lower, 0.0);
            self.chunks.multiply(2 * offset + 1, bond.points[1] as usize, 0.0);
            self.bonds -= 1;
        }
    }
}
