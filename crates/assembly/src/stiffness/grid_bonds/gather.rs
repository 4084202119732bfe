//! The internal force, gathered: every point collects from the bonds on both of its sides.
//!
//! So every chunk writes its own points only: threads share nothing, and results do not depend on their number. What
//! vectorises: sizes and the non-zero pattern of the rows known when compiling, rows constant per offset, an inner loop
//! over one chunk of points, component planes. A bond is evaluated from both of its ends by the same operations on the
//! same numbers, so the two forces are equal to the last bit.

use super::chunk_forces::Sides;
use super::chunks::{CHUNK, Chunk};
use super::precision::Precision;
use super::shares::measure;
use super::{Class, GridBonds};
use crate::bonds::BondModel;
use crate::stiffness::TakeForces;
use crate::stiffness::planes::{planes, planes_mut, take_front};
use peristat_vector::{Real, vectorised};
use rayon::prelude::*;
use std::array::from_fn;

/// Forces on the points of a chunk.
pub(super) type Forces<const D: usize, R> = [[R; CHUNK]; D];

/// Points below which threads cost more than they bring.
const FEW: usize = 8192;

impl<const D: usize, const M: usize, B: BondModel<D, M>> GridBonds<D, M, B> {
    /// Hands the internal forces on every chunk to `take`, with the number of its first point and its part of the planes
    /// of `out`.
    pub(super) fn gather<R: Precision>(&self, u: &[R], out: &mut [R], take: TakeForces<'_, D, R>) {
        let n = self.lattice.points();
        let u = planes::<D, R>(u);
        let parts = self.own_parts(planes_mut::<D, R>(out));
        let work = |(chunks, mut own): (&[Chunk], [&mut [R]; D])| {
            let mut sides = Vec::new();
            for chunk in chunks {
                let mut forces = [[R::default(); CHUNK]; D];
                vectorised(
                    #[inline(always)]
                    || self.gather_chunk(chunk, &u, &mut sides, &mut forces),
                );
                let width = chunk.width as usize;
                take(
                    chunk.first as usize,
                    forces.each_ref().map(|f| &f[..width]),
                    take_front(&mut own, width),
                );
            }
        };
        match n < FEW {
            true => parts.into_iter().for_each(work),
            false => parts.into_par_iter().for_each(work),
        }
    }

    #[inline(always)]
    fn gather_chunk<R: Precision>(
        &self,
        chunk: &Chunk,
        u: &[&[R]; D],
        sides: &mut Vec<Sides>,
        forces: &mut Forces<D, R>,
    ) {
        if let Some(beside) = &chunk.beside
            && chunk.is_plain()
        {
            self.beside(chunk, beside, u, sides, forces);
        } else {
            self.ragged(chunk, u, forces);
        }
    }

    /// Any chunk: stretch by stretch of existing neighbours, above and below.
    #[inline(always)]
    fn ragged<R: Precision>(&self, chunk: &Chunk, u: &[&[R]; D], forces: &mut Forces<D, R>) {
        for (index, class) in R::classes_of(self, chunk).iter().enumerate() {
            for (side, step) in [(0, class.step), (1, class.step.map(|k| -k))] {
                let factors: [Option<&[f64; CHUNK]>; M] =
                    from_fn(|m| self.chunks.factors_of(chunk, (index, side), m));
                self.lattice.shifted(chunk.line, &chunk.columns(), step, |columns, other| {
                    let k = (columns.start - chunk.from) as usize;
                    let (own, width) = (chunk.first as usize + k, columns.len());
                    let own: [&[R]; D] = from_fn(|c| &u[c][own..own + width]);
                    let other: [&[R]; D] = from_fn(|c| &u[c][other..other + width]);
                    let factors = factors.map(|f| f.map(|f| &f[k..k + width]));
                    if side == 0 {
                        one_side::<D, M, B, R, false>(class, [&own, &other], factors, k, forces);
                    } else {
                        one_side::<D, M, B, R, true>(class, [&other, &own], factors, k, forces);
                    }
                });
            }
        }
    }
}

/// Forces of a stretch of bonds, given by their lower and upper points, on the lower or on the `UPPER` ones, the k-th and
/// following points of a chunk.
#[inline(always)]
pub(super) fn one_side<const D: usize, const M: usize, B: BondModel<D, M>, R: Real, const UPPER: bool>(
    class: &Class<D, M, R>,
    [lower, upper]: [&[&[R]; D]; 2],
    factors: [Option<&[f64]>; M],
    k: usize,
    forces: &mut Forces<D, R>,
) {
    for m in 0..M {
        let mut sigma = [R::default(); CHUNK];
        let sigma = &mut sigma[..lower[0].len()];
        measure::<D, M, B, R>(class, m, [lower, upper], sigma);
        sigma.iter_mut().for_each(|s| *s = *s * class.modulus[m]);
        if let Some(factors) = factors[m] {
            sigma.iter_mut().zip(factors).for_each(|(s, f)| *s = *s * R::of(*f));
        }
        push::<D, M, B, R, UPPER>(class, m, sigma, k, forces);
    }
}

/// Forces of a stretch of bonds with the action `sigma` on the measure m, on the lower or on the `UPPER` points.
#[inline(always)]
pub(super) fn push<const D: usize, const M: usize, B: BondModel<D, M>, R: Real, const UPPER: bool>(
    class: &Class<D, M, R>,
    m: usize,
    sigma: &[R],
    k: usize,
    forces: &mut Forces<D, R>,
) {
    for c in 0..D {
        let forces = &mut forces[c][k..k + sigma.len()];
        if B::DIFFERENCE[m][c] {
            let row = if UPPER { class.difference[m][c] } else { -class.difference[m][c] };
            forces.iter_mut().zip(sigma).for_each(|(f, s)| *f += row * *s);
        }
        if B::MEAN[m][c] {
            let row = class.half_mean[m][c];
            forces.iter_mut().zip(sigma).for_each(|(f, s)| *f += row * *s);
        }
    }
}
