//! What a body has lost since its stiffness was factored.

use super::super::workspace::norm;
use peristat_assembly::stiffness::Term;
use peristat_assembly::system::System;
use peristat_solve::{DissectedCholesky, PcgOptions, PcgReport, PcgStatus, Reach, ReducedPcg};
use std::sync::Arc;

/// Parts of a body that are gone with some bonds.
pub(super) type Parts<const D: usize> = Arc<[Box<dyn Term<D>>]>;

/// Part of the largest residual that unknowns beside the lost parts may have: nothing lessens theirs.
const BESIDE: f64 = 0.5;
/// Part of it up to which those of the others are lessened.
const ENOUGH: f64 = 0.5;

/// What it has lost, and the unknowns that this acted on.
pub(super) struct LostParts<const D: usize> {
    parts: Vec<Parts<D>>,
    /// Constraints when the stiffness was factored; later ones hold what was free.
    constraints: usize,
    reach: Option<Reach>,
}

impl<const D: usize> LostParts<D> {
    /// Nothing yet of a system that was factored as it is.
    pub(super) fn new(system: &System<D>) -> Self {
        Self { parts: Vec::new(), constraints: system.constraints().rows().len(), reach: None }
    }

    /// Adds parts that are gone.
    pub(super) fn push(&mut self, parts: &Parts<D>) {
        self.parts.push(parts.clone());
        self.reach = None;
    }

    /// Whether there are such and the system has the constraints that it was factored with. Families share what they lose with all
    /// others, so that their parts are whole bodies.
    pub(super) fn suits(&self, system: &System<D>) -> bool {
        let mut all = self.parts.iter().flat_map(|parts| parts.iter());
        !self.parts.is_empty()
            && all.all(|part| !part.joins_many())
            && system.constraints().rows().len() == self.constraints
    }

    /// Lessens the residual of a system, its dependent unknowns left out, by displacements that are added to `u`, with a factor of the
    /// stiffness as it was before anything was lost; `None` if the residual is small enough, or not where parts were lost.
    pub(super) fn correct(
        &mut self,
        system: &System<D>,
        factor: &mut DissectedCholesky,
        (residual, u): (&[f64], &mut [f64]),
        target: f64,
        max_iterations: usize,
    ) -> Option<PcgReport> {
        if norm(residual) <= target {
            return None;
        }
        let parts = &self.parts;
        let reach = self.reach.get_or_insert_with(|| factor.reach(touched(parts, system)));
        let mut own: Vec<f64> = reach.unknowns().iter().map(|k| residual[*k]).collect();
        let mut beside = residual.to_vec();
        reach.unknowns().iter().for_each(|k| beside[*k] = 0.0);
        if norm(&beside) > BESIDE * target {
            return None;
        }
        let options = PcgOptions {
            max_iterations,
            residual_drop: ENOUGH * target / norm(&own),
            energy_drop: 0.0,
            stagnation_window: max_iterations,
        };
        let [mut motion, mut force, mut correction] = [0; 3].map(|_| vec![0.0; system.size()]);
        let mut lost = |p: &[f64], image: &mut [f64]| {
            reach.unknowns().iter().zip(p).for_each(|(k, p)| motion[*k] = *p);
            force.fill(0.0);
            forces(parts, system, &mut motion, &mut force);
            reach.unknowns().iter().zip(image).for_each(|(k, image)| *image = force[*k]);
        };
        let report = ReducedPcg::new(factor, reach).solve(&mut lost, &mut own, &mut correction, &options);
        if !matches!(report.status, PcgStatus::IndefiniteOperator | PcgStatus::NotFinite) {
            u.iter_mut().zip(&correction).for_each(|(u, d)| *u += d);
        }
        Some(report)
    }
}

/// Adds the forces of parts on independent unknowns, under a motion of these.
fn forces<const D: usize>(parts: &[Parts<D>], system: &System<D>, motion: &mut [f64], force: &mut [f64]) {
    system.constraints().expand(0.0, motion);
    parts.iter().flat_map(|parts| parts.iter()).for_each(|part| part.add_force(motion, force));
    system.constraints().restrict(force);
}

/// The independent unknowns that parts act on: those that have forces under a motion that no part is at rest in.
fn touched<const D: usize>(parts: &[Parts<D>], system: &System<D>) -> Vec<usize> {
    // Multiples of the golden ratio, less their integers, follow no pattern of bonds.
    let mut motion: Vec<f64> =
        (0..system.size()).map(|k| (0.618_033_988_749_895 * k as f64).fract()).collect();
    let mut force = vec![0.0; system.size()];
    forces(parts, system, &mut motion, &mut force);
    (0..force.len()).filter(|k| force[*k] != 0.0).collect()
}
