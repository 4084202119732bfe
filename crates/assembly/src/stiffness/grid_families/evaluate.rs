//! Measures of all families and the forces of what is conjugate to them.
//!
//! Measures are written point by point. Forces are pushed from families to their members, by bands of rows: first every
//! other one, then the rest, so that threads share nothing and sums do not depend on their number.

use super::{Band, GridFamilies, Stretch};
use crate::body::Cell;
use crate::stiffness::Survey;
use crate::stiffness::planes::{planes, planes_mut, take_front};
use crate::sum::Sum;
use peristat_vector::vectorised;
use rayon::prelude::*;
use std::array::from_fn;

/// Points below which threads cost more than they bring.
const FEW: usize = 8192;

impl<const D: usize> GridFamilies<D> {
    /// ϑ and h of all points; h is empty where no family has one.
    pub(super) fn measures(&self, u: &[f64]) -> [Vec<f64>; 2] {
        let n = self.lattice.points();
        let u = planes::<D, _>(u);
        let mut theta = vec![0.0; n];
        let mut rest = theta.as_mut_slice();
        let bands: Vec<(&Band, &mut [f64])> = self
            .bands
            .iter()
            .map(|band| (band, rest.split_off_mut(..band.points.len()).unwrap_or_default()))
            .collect();
        let work = |(band, theta): (&Band, &mut [f64])| {
            vectorised(
                #[inline(always)]
                || {
                    for stretch in &self.stretches[band.stretches.clone()] {
                        let first = stretch.first - band.points.start;
                        let own = &mut theta[first..first + stretch.columns.len()];
                        self.dilatation(stretch, &u, own);
                    }
                },
            );
        };
        match n < FEW {
            true => bands.into_iter().for_each(work),
            false => bands.into_par_iter().for_each(work),
        }
        [theta, self.family.own.iter().zip(u[0]).map(|(a, x)| a * x).collect()]
    }

    /// Numbers of the points at a step from a stretch and at the opposite one, if all are there.
    #[inline(always)]
    fn opposite(&self, stretch: &Stretch, step: Cell) -> Option<[usize; 2]> {
        let at = |step: Cell| {
            let mut first = None;
            self.lattice.shifted(stretch.line, &stretch.columns, step, |columns, other| {
                first = (columns == stretch.columns).then_some(other);
            });
            first
        };
        Some([at(step)?, at(step.map(|k| -k))?])
    }

    /// ϑ where rows at opposite steps are opposite: from differences of points on both sides, without the point itself. `false`
    /// if some of them are not there.
    #[inline(always)]
    fn odd_dilatation(&self, stretch: &Stretch, u: &[&[f64]; D], theta: &mut [f64]) -> bool {
        let set = &self.family.sets[stretch.set as usize];
        let width = stretch.columns.len();
        for (&step, row) in self.family.steps.iter().zip(&set[..set.len() / 2]).filter(|of| *of.1 != [0.0; D])
        {
            let Some([ahead, behind]) = self.opposite(stretch, step) else {
                theta.fill(0.0);
                return false;
            };
            let far: [[&[f64]; 2]; D] = from_fn(|c| [ahead, behind].map(|first| &u[c][first..first + width]));
            for i in 0..width {
                let part = |c: usize| row[c] * (far[c][0][i] - far[c][1][i]);
                theta[i] += (1..D).fold(part(0), |sum, c| sum + part(c));
            }
        }
        true
    }

    #[inline(always)]
    fn dilatation(&self, stretch: &Stretch, u: &[&[f64]; D], theta: &mut [f64]) {
        if self.odd[stretch.set as usize] && self.odd_dilatation(stretch, u, theta) {
            return;
        }
        let set = &self.family.sets[stretch.set as usize];
        for (&step, row) in self.family.steps.iter().zip(set) {
            if *row == [0.0; D] {
                continue;
            }
            self.lattice.shifted(stretch.line, &stretch.columns, step, |columns, other| {
                let (k, width) = ((columns.start - stretch.columns.start) as usize, columns.len());
                let own = stretch.first + k;
                let near: [&[f64]; D] = from_fn(|c| &u[c][own..own + width]);
                let far: [&[f64]; D] = from_fn(|c| &u[c][other..other + width]);
                let theta = &mut theta[k..k + width];
                for i in 0..width {
                    let part = |c: usize| row[c] * (far[c][i] - near[c][i]);
                    theta[i] += (1..D).fold(part(0), |sum, c| sum + part(c));
                }
            });
        }
    }

    /// What is conjugate to the measures, times the volume of the points.
    pub(super) fn stresses(&self, theta: &[f64], hoop: &[f64]) -> [Vec<f64>; 2] {
        let [[a, b], [_, c]] = self.family.modulus;
        let volume = &self.family.volume;
        let h = |k: usize| hoop.get(k).copied().unwrap_or(0.0);
        let mut sigma: Vec<f64> = (0..theta.len()).map(|k| volume[k] * (a * theta[k] + b * h(k))).collect();
        let mut across: Vec<f64> =
            (0..hoop.len()).map(|k| volume[k] * (b * theta[k] + c * hoop[k])).collect();
        if let Some(blocks) = &self.blocks {
            blocks.for_each_mean(
                volume,
                |k| theta[k] + h(k),
                |k, mean| {
                    let stress = self.family.mean_modulus * volume[k] * mean;
                    sigma[k] += stress;
                    if let Some(across) = across.get_mut(k) {
                        *across += stress;
                    }
                },
            );
        }
        [sigma, across]
    }

    /// Adds the forces that do the work of these stresses, times volumes, with the measures.
    pub(super) fn push(&self, [sigma, across]: &[Vec<f64>; 2], force: &mut [f64]) {
        for part in [0, 1] {
            let mut planes = planes_mut::<D, _>(force);
            let mut behind = 0;
            let mut bands = Vec::new();
            for band in self.bands.iter().skip(part).step_by(2) {
                take_front(&mut planes, band.reached.start - behind);
                let own = take_front(&mut planes, band.reached.len());
                bands.push((band, own));
                behind = band.reached.end;
            }
            let work = |(band, mut own): (&Band, [&mut [f64]; D])| {
                vectorised(
                    #[inline(always)]
                    || {
                        for stretch in &self.stretches[band.stretches.clone()] {
                            self.push_stretch(stretch, sigma, band.reached.start, &mut own);
                        }
                    },
                );
            };
            match self.lattice.points() < FEW {
                true => bands.into_iter().for_each(work),
                false => bands.into_par_iter().for_each(work),
            }
        }
        for (k, (stress, a)) in across.iter().zip(&self.family.own).enumerate() {
            force[k] += a * stress;
        }
    }

    #[inline(always)]
    fn push_stretch(&self, stretch: &Stretch, sigma: &[f64], base: usize, planes: &mut [&mut [f64]; D]) {
        let set = &self.family.sets[stretch.set as usize];
        // Many steps of a solid take as much from the points themselves as others bring.
        let mut taken = [0.0; D];
        for (&step, row) in self.family.steps.iter().zip(set) {
            if *row == [0.0; D] {
                continue;
            }
            self.lattice.shifted(stretch.line, &stretch.columns, step, |columns, other| {
                let (k, width) = ((columns.start - stretch.columns.start) as usize, columns.len());
                let own = stretch.first + k;
                let sigma = &sigma[own..own + width];
                let takes_later = D > 2 && columns == stretch.columns;
                for (c, (plane, row)) in planes.iter_mut().zip(row).enumerate() {
                    let to = &mut plane[other - base..][..width];
                    to.iter_mut().zip(sigma).for_each(|(f, s)| *f += row * s);
                    if takes_later {
                        taken[c] += row;
                    } else {
                        let from = &mut plane[own - base..][..width];
                        from.iter_mut().zip(sigma).for_each(|(f, s)| *f -= row * s);
                    }
                }
            });
        }
        if taken == [0.0; D] {
            return;
        }
        let (own, width) = (stretch.first, stretch.columns.len());
        for (plane, row) in planes.iter_mut().zip(taken) {
            let from = &mut plane[own - base..][..width];
            from.iter_mut().zip(&sigma[own..own + width]).for_each(|(f, s)| *f -= row * s);
        }
    }

    pub(super) fn survey_families(&self, u: &[f64]) -> Survey<D> {
        let [theta, hoop] = self.measures(u);
        let [sigma, across] = self.stresses(&theta, &hoop);
        let mut energy = Sum::default();
        theta.iter().zip(&sigma).for_each(|(s, stress)| energy.add(0.5 * s * stress));
        hoop.iter().zip(&across).for_each(|(s, stress)| energy.add(0.5 * s * stress));
        let largest = |values: &[f64]| values.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
        let mut largest_action = [0.0_f64; D];
        for stretch in &self.stretches {
            let most = largest(&sigma[stretch.first..stretch.first + stretch.columns.len()]);
            for row in &self.family.sets[stretch.set as usize] {
                (0..D).for_each(|c| largest_action[c] = largest_action[c].max(row[c].abs() * most));
            }
        }
        let own = across.iter().zip(&self.family.own).map(|(s, a)| (s * a).abs());
        largest_action[0] = own.fold(largest_action[0], f64::max);
        Survey { energy: energy.total(), largest_action }
    }
}
