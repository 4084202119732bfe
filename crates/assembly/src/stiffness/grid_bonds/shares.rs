//! What points get from their bonds besides forces: stresses and energies, and the load that a stress does work with.

use super::chunks::{CHUNK, Chunk};
use super::gather::push;
use super::precision::Precision;
use super::{Class, GridBonds};
use crate::bonds::{BondModel, Mat};
use crate::stiffness::planes::{planes, planes_mut, take_front};
use peristat_vector::{Real, vectorised};
use rayon::prelude::*;
use std::array::from_fn;
use std::ops::Range;

impl<const D: usize, const M: usize, B: BondModel<D, M>> GridBonds<D, M, B> {
    /// `Q` sums per point over its bonds, `Σ shares[offset]·σ` with the forces σ conjugate to the measures, and half of the
    /// energy of its bonds: `Q + 1` planes.
    pub fn sums<const Q: usize>(&self, u: &[f64], shares: &[Mat<Q, M>]) -> Vec<f64> {
        let n = self.lattice.points();
        let u = planes::<D, _>(u);
        let mut sums = vec![0.0; (Q + 1) * n];
        let (shared, energy) = sums.split_at_mut(Q * n);
        let parts = self.own_parts::<Q, _>(planes_mut(shared)).into_iter();
        let energies = self.own_parts::<1, _>([energy]);
        let parts: Vec<_> = parts.zip(energies).collect();
        parts.into_par_iter().for_each(|((chunks, mut own), (_, [energy]))| {
            vectorised(
                #[inline(always)]
                || {
                    let mut done = 0;
                    for chunk in chunks {
                        let width = chunk.width as usize;
                        let (sums, half) = self.sums_of(chunk, &u, shares);
                        for q in 0..Q {
                            own[q][done..done + width].copy_from_slice(&sums[q][..width]);
                        }
                        energy[done..done + width].copy_from_slice(&half[..width]);
                        done += width;
                    }
                },
            );
        });
        sums
    }

    #[inline(always)]
    fn sums_of<const Q: usize>(
        &self,
        chunk: &Chunk,
        u: &[&[f64]; D],
        shares: &[Mat<Q, M>],
    ) -> ([[f64; CHUNK]; Q], [f64; CHUNK]) {
        let (mut sums, mut energy) = ([[0.0; CHUNK]; Q], [0.0; CHUNK]);
        self.for_each_stretch(chunk, |index, side, k, own, other| {
            let (class, width) = (&f64::classes_of(self, chunk)[index], own.len());
            let own: [&[f64]; D] = from_fn(|c| &u[c][own.clone()]);
            let other: [&[f64]; D] = from_fn(|c| &u[c][other.clone()]);
            let [lower, upper] = if side == 0 { [&own, &other] } else { [&other, &own] };
            for m in 0..M {
                let (mut s, mut sigma) = ([0.0; CHUNK], [0.0; CHUNK]);
                measure::<D, M, B, f64>(class, m, [lower, upper], &mut s[..width]);
                for l in 0..width {
                    sigma[l] = class.modulus[m] * s[l];
                }
                if let Some(factors) = self.chunks.factors_of(chunk, (index, side), m) {
                    let factors = &factors[k..k + width];
                    sigma.iter_mut().zip(factors).for_each(|(s, f)| *s *= f);
                }
                for l in 0..width {
                    energy[k + l] += 0.25 * s[l] * sigma[l];
                }
                for q in 0..Q {
                    let share = shares[index][q][m];
                    sums[q][k..k + width].iter_mut().zip(&sigma).for_each(|(sum, s)| *sum += share * s);
                }
            }
        });
        (sums, energy)
    }

    /// The adjoint of [`sums`](Self::sums): adds the forces that do the work `Σ_points t·sums` for the `Q` planes `t`.
    ///
    /// `spans` tells, for every row of every layer, which columns can have t other than zero.
    pub fn add_work<const Q: usize>(
        &self,
        t: &[f64],
        spans: &[Range<i32>],
        shares: &[Mat<Q, M>],
        force: &mut [f64],
    ) {
        let t = planes::<Q, _>(t);
        let parts = self.own_parts::<D, _>(planes_mut(force));
        parts.into_par_iter().for_each(|(chunks, mut own)| {
            vectorised(
                #[inline(always)]
                || {
                    let mut done = 0;
                    for chunk in chunks {
                        let width = chunk.width as usize;
                        if self.is_near(chunk, spans) {
                            let forces = self.work_of(chunk, &t, shares);
                            for c in 0..D {
                                let own = &mut own[c][done..done + width];
                                own.iter_mut().zip(&forces[c]).for_each(|(f, part)| *f += part);
                            }
                        }
                        done += width;
                    }
                },
            );
        });
    }

    #[inline(always)]
    fn work_of<const Q: usize>(
        &self,
        chunk: &Chunk,
        t: &[&[f64]; Q],
        shares: &[Mat<Q, M>],
    ) -> [[f64; CHUNK]; D] {
        let mut forces = [[0.0; CHUNK]; D];
        self.for_each_stretch(chunk, |index, side, k, own, other| {
            let (class, width) = (&f64::classes_of(self, chunk)[index], own.len());
            for m in 0..M {
                let mut sigma = [0.0; CHUNK];
                let sigma = &mut sigma[..width];
                for q in 0..Q {
                    let share = shares[index][q][m] * class.modulus[m];
                    let ends = t[q][own.clone()].iter().zip(&t[q][other.clone()]);
                    sigma.iter_mut().zip(ends).for_each(|(s, (a, b))| *s += share * (a + b));
                }
                if let Some(factors) = self.chunks.factors_of(chunk, (index, side), m) {
                    let factors = &factors[k..k + width];
                    sigma.iter_mut().zip(factors).for_each(|(s, f)| *s *= f);
                }
                match side {
                    0 => push::<D, M, B, f64, false>(class, m, sigma, k, &mut forces),
                    _ => push::<D, M, B, f64, true>(class, m, sigma, k, &mut forces),
                }
            }
        });
        forces
    }

    /// Whether a point with a neighbour in the chunk, or in it, lies in the spans.
    fn is_near(&self, chunk: &Chunk, spans: &[Range<i32>]) -> bool {
        let (reach, columns) = (self.chunks.reach(), chunk.columns());
        self.chunks.lines().any(|[_, row, layer]| {
            let line = self.lattice.line([chunk.line[0] + row, chunk.line[1] + layer]);
            line.and_then(|line| spans.get(line))
                .is_some_and(|s| s.start < columns.end + reach && columns.start - reach < s.end)
        })
    }

    /// Stretches of bonds of the points of a chunk: index of the offset, upwards (0) or downwards (1), place in the chunk,
    /// own points and others.
    #[inline(always)]
    pub(super) fn for_each_stretch(
        &self,
        chunk: &Chunk,
        mut visit: impl FnMut(usize, usize, usize, Range<usize>, Range<usize>),
    ) {
        for (index, class) in self.offsets().iter().enumerate() {
            for (side, step) in [(0, class.step), (1, class.step.map(|k| -k))] {
                self.lattice.shifted(chunk.line, &chunk.columns(), step, |columns, other| {
                    let (k, width) = ((columns.start - chunk.from) as usize, columns.len());
                    let own = chunk.first as usize + k;
                    visit(index, side, k, own..own + width, other..other + width);
                });
            }
        }
    }

    /// Parts of the chunks with their own points of every plane.
    pub(super) fn own_parts<'a, const Q: usize, R>(
        &self,
        mut rest: [&'a mut [R]; Q],
    ) -> Vec<(&[Chunk], [&'a mut [R]; Q])> {
        let take = |chunks| {
            let chunks: &[Chunk] = chunks;
            let points = chunks.iter().map(|c| c.width as usize).sum();
            (chunks, take_front(&mut rest, points))
        };
        self.chunks.parts().map(take).collect()
    }
}

/// The measure m of a stretch of bonds.
#[inline(always)]
pub(super) fn measure<const D: usize, const M: usize, B: BondModel<D, M>, R: Real>(
    class: &Class<D, M, R>,
    m: usize,
    [lower, upper]: [&[&[R]; D]; 2],
    s: &mut [R],
) {
    for c in 0..D {
        let (lower, upper) = (lower[c], upper[c]);
        if B::DIFFERENCE[m][c] {
            let row = class.difference[m][c];
            let pairs = s.iter_mut().zip(lower.iter().zip(upper));
            pairs.for_each(|(s, (lower, upper))| *s += row * (*upper - *lower));
        }
        if B::MEAN[m][c] {
            let row = class.half_mean[m][c];
            let pairs = s.iter_mut().zip(lower.iter().zip(upper));
            pairs.for_each(|(s, (lower, upper))| *s += row * (*lower + *upper));
        }
    }
}
