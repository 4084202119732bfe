//! Energy and largest end action of the bonds.

use super::chunks::{CHUNK, Chunk};
use super::precision::Precision;
use super::{Class, GridBonds};
use crate::bonds::BondModel;
use crate::stiffness::Survey;
use crate::stiffness::planes::planes;
use peristat_vector::vectorised;
use rayon::prelude::*;
use std::array::from_fn;

impl<const D: usize, const M: usize, B: BondModel<D, M>> GridBonds<D, M, B> {
    pub(super) fn survey_chunks(&self, u: &[f64]) -> Survey<D> {
        let u = planes::<D, _>(u);
        let part = |chunks: &[Chunk]| {
            vectorised(
                #[inline(always)]
                || chunks.iter().map(|chunk| self.survey_chunk(chunk, &u)).fold(Survey::EMPTY, Survey::join),
            )
        };
        let parts: Vec<Survey<D>> =
            self.chunks.parts().collect::<Vec<_>>().into_par_iter().map(part).collect();
        parts.into_iter().fold(Survey::EMPTY, Survey::join)
    }

    #[inline(always)]
    fn survey_chunk(&self, chunk: &Chunk, u: &[&[f64]; D]) -> Survey<D> {
        let mut survey = Survey::EMPTY;
        for (index, class) in f64::classes_of(self, chunk).iter().enumerate() {
            let factors: [Option<&[f64; CHUNK]>; M] =
                from_fn(|m| self.chunks.factors_of(chunk, (index, 0), m));
            self.lattice.shifted(chunk.line, &chunk.columns(), class.step, |columns, other| {
                let k = (columns.start - chunk.from) as usize;
                let (own, width) = (chunk.first as usize + k, columns.len());
                let lower: [&[f64]; D] = from_fn(|c| &u[c][own..own + width]);
                let upper: [&[f64]; D] = from_fn(|c| &u[c][other..other + width]);
                let factors = factors.map(|f| f.map(|f| &f[k..k + width]));
                survey = survey.join(stretch::<D, M, B>(class, [&lower, &upper], factors));
            });
        }
        survey
    }
}

/// Of a stretch of bonds of one offset.
#[inline(always)]
fn stretch<const D: usize, const M: usize, B: BondModel<D, M>>(
    class: &Class<D, M>,
    [lower, upper]: [&[&[f64]; D]; 2],
    factors: [Option<&[f64]>; M],
) -> Survey<D> {
    let width = lower[0].len();
    let mut energy = [0.0; CHUNK];
    // End actions, on the lower and on the upper point.
    let mut actions = [[[0.0; CHUNK]; D]; 2];
    for m in 0..M {
        let (mut s, mut sigma) = ([0.0; CHUNK], [0.0; CHUNK]);
        for k in 0..width {
            for c in 0..D {
                if B::DIFFERENCE[m][c] {
                    s[k] += class.difference[m][c] * (upper[c][k] - lower[c][k]);
                }
                if B::MEAN[m][c] {
                    s[k] += class.half_mean[m][c] * (upper[c][k] + lower[c][k]);
                }
            }
            sigma[k] = class.modulus[m] * s[k];
        }
        if let Some(factors) = factors[m] {
            sigma.iter_mut().zip(factors).for_each(|(s, f)| *s *= f);
        }
        for k in 0..width {
            energy[k] += s[k] * sigma[k];
            for c in 0..D {
                actions[0][c][k] += (class.half_mean[m][c] - class.difference[m][c]) * sigma[k];
                actions[1][c][k] += (class.half_mean[m][c] + class.difference[m][c]) * sigma[k];
            }
        }
    }
    let largest = |c: usize| {
        let ends = actions[0][c][..width].iter().chain(&actions[1][c][..width]);
        ends.fold(0.0, |largest: f64, action| if action.abs() > largest { action.abs() } else { largest })
    };
    Survey { energy: 0.5 * energy[..width].iter().sum::<f64>(), largest_action: from_fn(largest) }
}
