//! Sweeps over the bonds of a lattice: measures, forces, energy.
//!
//! What vectorises: sizes and the non-zero pattern of the rows known when compiling, rows constant per offset, an inner
//! loop over one chunk of points, component planes.

use super::super::Survey;
use super::{BondClass, CHUNK, LatticeBonds};
use crate::bonds::BondModel;
use std::array::from_fn;
use std::ops::Range;

impl<const D: usize, const M: usize, B: BondModel<D, M>> LatticeBonds<D, M, B> {
    /// Measures of the bonds with the given lower points, at most one chunk of them.
    #[inline(always)]
    pub(super) fn measures(
        &self,
        class: &BondClass<D, M>,
        lower: Range<usize>,
        u: &[f64],
        s: &mut [[f64; CHUNK]; M],
    ) {
        let (n, width) = (self.lattice.points, lower.len());
        let base = self.lattice.first + lower.start;
        let lo: [&[f64]; D] = from_fn(|c| &u[c * n + base..][..width]);
        let hi: [&[f64]; D] = from_fn(|c| &u[c * n + base + class.step..][..width]);
        for m in 0..M {
            let out = &mut s[m][..width];
            out.fill(0.0);
            for c in 0..D {
                let (lo, hi) = (lo[c], hi[c]);
                if B::DIFFERENCE[m][c] {
                    let b = class.rows.difference[m][c];
                    (0..width).for_each(|k| out[k] += b * (hi[k] - lo[k]));
                }
                if B::MEAN[m][c] {
                    let b = class.rows.mean[m][c];
                    (0..width).for_each(|k| out[k] += b * (0.5 * (lo[k] + hi[k])));
                }
            }
        }
    }

    /// Measures turned into conjugate forces `σ = α factor C s`.
    #[inline(always)]
    pub(super) fn stress(class: &BondClass<D, M>, factors: Option<&[f64]>, s: &mut [[f64; CHUNK]; M]) {
        for m in 0..M {
            s[m].iter_mut().for_each(|v| *v *= class.modulus[m]);
            if let Some(factors) = factors {
                s[m].iter_mut().zip(factors).for_each(|(v, g)| *v *= g);
            }
        }
    }

    /// Visits every class of every chunk with its measures and its conjugate forces.
    #[inline(always)]
    fn sweep(
        &self,
        u: &[f64],
        mut visit: impl FnMut(&BondClass<D, M>, Range<usize>, &[[f64; CHUNK]; M], &[[f64; CHUNK]; M]),
    ) {
        let mut s = [[0.0; CHUNK]; M];
        for chunk in 0..self.weights.chunks() {
            for (index, class) in self.classes.iter().enumerate() {
                let (lower, factors) = self.weights.bonds_of(index, chunk);
                if lower.is_empty() {
                    continue;
                }
                self.measures(class, lower.clone(), u, &mut s);
                let mut sigma = s;
                Self::stress(class, factors, &mut sigma);
                visit(class, lower, &s, &sigma);
            }
        }
    }

    #[inline(always)]
    pub(super) fn add_force_plain(&self, u: &[f64], force: &mut [f64]) {
        let (n, first) = (self.lattice.points, self.lattice.first);
        self.sweep(u, |class, lower, _, sigma| {
            let (base, width) = (first + lower.start, lower.len());
            for c in 0..D {
                let mut difference = [0.0; CHUNK];
                let mut mean = [0.0; CHUNK];
                for m in 0..M {
                    if B::DIFFERENCE[m][c] {
                        let b = class.rows.difference[m][c];
                        (0..CHUNK).for_each(|k| difference[k] += b * sigma[m][k]);
                    }
                    if B::MEAN[m][c] {
                        let b = 0.5 * class.rows.mean[m][c];
                        (0..CHUNK).for_each(|k| mean[k] += b * sigma[m][k]);
                    }
                }
                let lo = &mut force[c * n + base..][..width];
                (0..width).for_each(|k| lo[k] += mean[k] - difference[k]);
                let hi = &mut force[c * n + base + class.step..][..width];
                (0..width).for_each(|k| hi[k] += mean[k] + difference[k]);
            }
        });
    }

    #[inline(always)]
    pub(super) fn survey_plain(&self, u: &[f64]) -> Survey<D> {
        let mut energy = 0.0;
        let mut largest = [[0.0; CHUNK]; D];
        self.sweep(u, |class, lower, s, sigma| {
            // Summed lane by lane and chunk by chunk: the error of a long sum grows with its number of terms.
            let mut part = [0.0; CHUNK];
            for m in 0..M {
                (0..CHUNK).for_each(|k| part[k] += s[m][k] * sigma[m][k]);
            }
            energy += 0.5 * part[..lower.len()].iter().sum::<f64>();
            for b in [class.rows.first(), class.rows.second()] {
                for (c, largest) in largest.iter_mut().enumerate() {
                    let mut action = [0.0; CHUNK];
                    for m in 0..M {
                        if B::DIFFERENCE[m][c] || B::MEAN[m][c] {
                            (0..CHUNK).for_each(|k| action[k] += b[m][c] * sigma[m][k]);
                        }
                    }
                    for k in 0..lower.len() {
                        let size = f64::abs(action[k]);
                        largest[k] = if size > largest[k] { size } else { largest[k] };
                    }
                }
            }
        });
        Survey { energy, largest_action: largest.map(|lanes| lanes.into_iter().fold(0.0, f64::max)) }
    }
}
