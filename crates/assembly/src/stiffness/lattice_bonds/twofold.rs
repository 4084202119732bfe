//! Forces of the bonds of a lattice in twice the precision, by chunks of one class as the sweeps in doubles take them.

use super::super::Twofold;
use super::{BondClass, CHUNK, LatticeBonds};
use crate::bonds::BondModel;
use crate::sum::Sum;
use std::array::from_fn;
use std::ops::Range;

/// Forces of one component on the points of a chunk, in two parts.
type Lanes = [[f64; CHUNK]; 2];

impl<const D: usize, const M: usize, B: BondModel<D, M>> LatticeBonds<D, M, B> {
    /// Adds the forces of all bonds.
    #[inline(always)]
    pub(super) fn add_twofold(&self, u: Twofold<'_>, force: &mut [Sum]) {
        for chunk in 0..self.weights.chunks() {
            for (index, class) in self.classes.iter().enumerate() {
                let (lower, factors) = self.weights.bonds_of(index, chunk);
                if !lower.is_empty() {
                    let mut sigma = self.measures_twofold(class, lower.clone(), u);
                    Self::stress(class, factors, &mut sigma);
                    self.push_twofold(class, lower, &sigma, force);
                }
            }
        }
    }

    /// Measures of the bonds with the given lower points, rounded once.
    #[inline(always)]
    fn measures_twofold(
        &self,
        class: &BondClass<D, M>,
        lower: Range<usize>,
        u: Twofold<'_>,
    ) -> [[f64; CHUNK]; M] {
        let (n, width) = (self.lattice.points, lower.len());
        let base = self.lattice.first + lower.start;
        let ends = |of: usize, c: usize| {
            let plane = c * n + base + of;
            [&u.high[plane..][..width], &u.low[plane..][..width]]
        };
        let mut s = [[0.0; CHUNK]; M];
        for m in 0..M {
            let mut sums: Lanes = [[0.0; CHUNK]; 2];
            for c in 0..D {
                let ([i, i_low], [j, j_low]) = (ends(0, c), ends(class.step, c));
                let [high, low] = &mut sums;
                let mut add = |factor: f64, sign: f64| {
                    for k in 0..width {
                        let mut between = Sum::of_parts(j[k], j_low[k]);
                        between.join(Sum::of_parts(sign * i[k], sign * i_low[k]));
                        let mut sum = Sum::of_parts(high[k], low[k]);
                        sum.add_multiple(factor, between);
                        [high[k], low[k]] = sum.unrounded();
                    }
                };
                if B::DIFFERENCE[m][c] {
                    add(class.rows.difference[m][c], -1.0);
                }
                if B::MEAN[m][c] {
                    add(0.5 * class.rows.mean[m][c], 1.0);
                }
            }
            let [high, low] = &sums;
            (0..width).for_each(|k| s[m][k] = high[k] + low[k]);
        }
        s
    }

    /// Adds the forces that conjugate forces make.
    #[inline(always)]
    fn push_twofold(
        &self,
        class: &BondClass<D, M>,
        lower: Range<usize>,
        sigma: &[[f64; CHUNK]; M],
        force: &mut [Sum],
    ) {
        let (base, width) = (self.lattice.first + lower.start, lower.len());
        for c in 0..D {
            let [mut difference, mut mean]: [Lanes; 2] = from_fn(|_| [[0.0; CHUNK]; 2]);
            for m in 0..M {
                if B::DIFFERENCE[m][c] {
                    add_products(&mut difference, class.rows.difference[m][c], &sigma[m]);
                }
                if B::MEAN[m][c] {
                    add_products(&mut mean, 0.5 * class.rows.mean[m][c], &sigma[m]);
                }
            }
            for (step, sign) in [(0, -1.0), (class.step, 1.0)] {
                let from = c * self.lattice.points + base + step;
                for (k, force) in force[from..][..width].iter_mut().enumerate() {
                    force.join(Sum::of_parts(sign * difference[0][k], sign * difference[1][k]));
                    force.join(Sum::of_parts(mean[0][k], mean[1][k]));
                }
            }
        }
    }
}

/// Adds the exact products of a factor and some values.
#[inline(always)]
fn add_products([high, low]: &mut Lanes, factor: f64, values: &[f64; CHUNK]) {
    for k in 0..CHUNK {
        let mut sum = Sum::of_parts(high[k], low[k]);
        sum.add_product(factor, values[k]);
        [high[k], low[k]] = sum.unrounded();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bonds::{BondGeometry, Rows};
    use crate::stiffness::lattice_bonds::{Lattice, Override, Weights};
    use crate::stiffness::{Term, twofold};

    /// γ = (w_j − w_i) − ξ (φ_i + φ_j)/2 and φ_j − φ_i.
    struct Beam;

    impl BondModel<2, 2> for Beam {
        const DIFFERENCE: [[bool; 2]; 2] = [[true, false], [false, true]];
        const MEAN: [[bool; 2]; 2] = [[false, true], [false, false]];

        fn rows(&self, bond: &BondGeometry) -> Rows<2, 2> {
            Rows { difference: [[1.0, 0.0], [0.0, 1.0]], mean: [[0.0, -bond.length()], [0.0, 0.0]] }
        }

        fn moduli(&self, bond: &BondGeometry) -> [f64; 2] {
            [7.3 / bond.length(), 3.1 / bond.length()]
        }
    }

    /// Chunks that are whole, cut off and with exceptions do as their bonds do one by one.
    #[test]
    fn chunks_have_the_forces_of_their_bonds() {
        let (lattice, geometry) = (
            Lattice { points: 150, first: 3, count: 140 },
            [0.1, 0.2].map(|x| BondGeometry { xi: [x, 0.0, 0.0] }),
        );
        let gone =
            [Override { class: 1, lower: 70, factor: 0.0 }, Override { class: 0, lower: 0, factor: 2.0 }];
        let weights = Weights::new(140, vec![(1, 0.4), (2, 0.3)], &gone);
        let bonds = LatticeBonds::new(lattice, &Beam, &geometry, weights.clone());
        let high: Vec<f64> = (0..300).map(|k| f64::from(k).sin()).collect();
        let low: Vec<f64> = (0..300).map(|k| 1e-17 * f64::from(k).cos()).collect();
        let u = Twofold { high: &high, low: &low };
        let [mut found, mut expected] = [vec![Sum::default(); 300], vec![Sum::default(); 300]];
        assert!(bonds.add_force_twofold(u, &mut found));
        for (index, class) in bonds.classes.iter().enumerate() {
            let rows = [&class.rows.difference, &class.rows.half_mean()];
            for lower in 0..140 - class.step {
                let moduli = class.modulus.map(|c| weights.factor(index, lower) * c);
                let ends = [3 + lower, 3 + lower + class.step];
                twofold::add_bond((rows, &moduli), 150, ends, u, &mut expected);
            }
        }
        let mut largest = 0.0_f64;
        for (found, expected) in found.iter_mut().zip(expected) {
            largest = largest.max(expected.total().abs());
            found.join(-expected);
        }
        // Twice the precision of doubles has 32 digits; the conjugate forces are doubles and the same to the last bit.
        assert!(found.iter().all(|sum| sum.total().abs() < 1e-30 * largest), "{largest}");
    }
}
