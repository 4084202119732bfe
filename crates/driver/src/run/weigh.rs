//! What a solution tells of its own errors.

use super::load::Load;
use super::measures::{STRAIN_FREE, ratio, worst};
use super::refine::DOUBTFUL;
use super::scan::largest;
use super::workspace::{StateSolution, Workspace, size};
use peristat_assembly::condition::Row;
use peristat_assembly::system::System;
use peristat_solve::Preconditioner;
use std::collections::HashMap;

/// Largest work of some forces, one of each component, on displacements that count as equally large.
pub(super) fn work(forces: &[f64], scales: &[f64]) -> f64 {
    worst(forces.iter().zip(scales).map(|(f, s)| f * s))
}

/// A multiple of the unknowns whose forces round otherwise, also those of small numbers and powers of two.
const OTHER: f64 = std::f64::consts::PI;

/// Stored energy over the work of the loads, each by itself, above which a body bears its loads by strains. Where they cancel the
/// ratio is rounding.
const BORNE: f64 = 1e-9;

impl<const D: usize> Workspace<D> {
    /// Finds what belongs to the unknowns of a solution: those that depend on others, forces of constraints, the residual,
    /// and what one more solve with the preconditioner would correct.
    pub(super) fn weigh(
        &mut self,
        system: &System<D>,
        preconditioner: &mut dyn Preconditioner,
        (load, motion_factor): (&[f64], f64),
        solution: &mut StateSolution,
    ) {
        let constraints = system.constraints();
        constraints.expand(motion_factor, &mut solution.u);
        system.force(&solution.u, &mut self.force);
        self.residual.iter_mut().zip(load).zip(&self.force).for_each(|((r, load), f)| *r = load - f);
        self.find_constraint_forces(system, solution);
        constraints.restrict(&mut self.residual);
        solution.next_correction = self.correction(preconditioner, solution);
        self.find_largest_residuals(solution);
    }

    /// Finds forces of constraints from the residual at hand, which is whole.
    pub(super) fn find_constraint_forces(&self, system: &System<D>, solution: &mut StateSolution) {
        solution.held = self.constraint_forces(system);
        solution.multipliers = system.constraints().multipliers(|unknown| -self.residual[unknown]);
    }

    /// Finds the largest residual of each component.
    pub(super) fn find_largest_residuals(&self, solution: &mut StateSolution) {
        let planes = self.residual.chunks_exact(self.residual.len() / D);
        solution.residual = planes.map(largest).collect();
    }

    /// Finds what the rounding of the unknowns does to strains, whatever soft supports make of it.
    pub(super) fn weigh_strains(
        &mut self,
        system: &System<D>,
        preconditioner: &mut dyn Preconditioner,
        load: &[f64],
        solution: &mut StateSolution,
    ) {
        solution.least_eigenvalue = 1.0;
        self.refresh_residual(system, load, &solution.u);
        system.constraints().restrict(&mut self.residual);
        let errors = vec![0.0; system.constraints().rows().len()];
        self.correct_strains(system, preconditioner, &errors, solution);
    }

    /// What one more solve would correct of the unknowns if the residual at hand were theirs, relative to them. The
    /// preconditioner alone may be stiffer than the system: by no more than its least eigenvalue says.
    fn correction(&mut self, preconditioner: &mut dyn Preconditioner, solution: &StateSolution) -> f64 {
        let correction = self.pcg.precondition(preconditioner, &self.residual);
        relative(correction, solution, &self.scales)
    }

    /// The same, and what is kept with the solution: its energy and actions, the energy and the largest action of that
    /// correction, and the error of what holds the body, which bears the correction and the `errors` of the forces on each
    /// constrained unknown.
    fn correct_strains(
        &mut self,
        system: &System<D>,
        preconditioner: &mut dyn Preconditioner,
        errors: &[f64],
        solution: &mut StateSolution,
    ) -> f64 {
        let correction = self.pcg.precondition(preconditioner, &self.residual);
        let next_correction = relative(correction, solution, &self.scales);
        let energy: f64 = correction.iter().zip(&self.residual).map(|(z, r)| z * r).sum();
        system.constraints().expand(0.0, correction);
        let [body, all] = system.surveys(&solution.u);
        solution.action = work(&body.largest_action, &self.scales);
        solution.stored = Some((all.energy, all.largest_action.to_vec()));
        solution.correction_action = match self.counts_actions {
            true => work(&system.survey_body(correction).largest_action, &self.scales),
            false => 0.0,
        };
        system.force(correction, &mut self.residual);
        let rows = system.constraints().rows();
        rows.iter().zip(errors).for_each(|(row, error)| self.residual[row.unknown] += error);
        solution.held_error = self.largest_held(system, &self.residual);
        solution.correction_energy = energy.abs();
        for seen in
            [&mut solution.correction_energy, &mut solution.correction_action, &mut solution.held_error]
        {
            *seen /= solution.least_eigenvalue;
        }
        next_correction
    }

    /// The largest of some forces on what is held, as a work.
    pub(super) fn largest_held(&self, system: &System<D>, forces: &[f64]) -> f64 {
        let of_row = |row: &Row| (forces[row.unknown] * self.scales[row.unknown / system.points()]).abs();
        worst(system.constraints().rows().iter().map(of_row))
    }

    /// Adds what the rounding of forces and loads does to a solution that was weighed: the residual that it was found with is
    /// as small as that rounding makes it seem, and where nothing rounds the loads are doubles all the same. The residual and
    /// the force at hand are those of the solution.
    pub(super) fn doubt(
        &mut self,
        system: &System<D>,
        preconditioner: &mut dyn Preconditioner,
        load: &Load<D>,
        solution: &mut StateSolution,
    ) {
        let [other, force] = self.pcg.scratch();
        other.iter_mut().zip(&solution.u).for_each(|(other, u)| *other = OTHER * u);
        system.force(other, force);
        force.iter_mut().zip(&self.force).for_each(|(f, own)| *f = *f / OTHER - own);
        load.add_rounding(force);
        self.residual.iter_mut().zip(&*force).for_each(|(r, f)| *r += f);
        let constraints = system.constraints();
        let errors: Vec<f64> = constraints.rows().iter().map(|row| force[row.unknown]).collect();
        constraints.restrict(&mut self.residual);
        let next_correction = self.correct_strains(system, preconditioner, &errors, solution);
        solution.next_correction = worst([solution.next_correction, next_correction]);
        if solution.next_correction > DOUBTFUL {
            self.weigh_cancelled(system, preconditioner, load, solution);
        }
    }

    /// Weighs a solution that may be nothing but rounding, where it and its correction store next to nothing of what the loads
    /// would store if none of them cancelled another: its error is one of the displacements that they would have then.
    fn weigh_cancelled(
        &mut self,
        system: &System<D>,
        preconditioner: &mut dyn Preconditioner,
        load: &Load<D>,
        solution: &mut StateSolution,
    ) {
        let energy = solution.stored.as_ref().map_or(f64::INFINITY, |stored| stored.0);
        // What bears its loads stores half of their work, and the loads need not be scattered.
        let borne: f64 = load.forces.iter().zip(&solution.u).map(|(f, u)| (f * u).abs()).sum();
        if energy > BORNE * borne {
            return;
        }
        load.scatter(&mut self.residual);
        system.constraints().restrict(&mut self.residual);
        let scattered = self.pcg.precondition(preconditioner, &self.residual);
        let work: f64 = scattered.iter().zip(&self.residual).map(|(z, r)| z * r).sum();
        let left = energy + 0.5 * solution.correction_energy;
        solution.cancels = left <= STRAIN_FREE * 0.5 * work;
        if solution.cancels {
            let far = size(scattered, &self.scales);
            solution.next_correction *= ratio(size(&solution.u, &self.scales), far);
        }
    }

    /// Forces of constraints from a whole residual: on every constrained unknown, and shares of it, with the opposite
    /// sign, on the unknowns that move it. So a link balances itself, whatever the rounding of the forces it joins.
    fn constraint_forces(&self, system: &System<D>) -> Vec<(usize, f64)> {
        let mut forces: HashMap<usize, f64> = HashMap::new();
        for row in system.constraints().rows() {
            let force = -self.residual[row.unknown];
            *forces.entry(row.unknown).or_default() += force;
            row.masters.iter().for_each(|&(m, c)| *forces.entry(m).or_default() -= c * force);
        }
        let mut forces: Vec<(usize, f64)> = forces.into_iter().collect();
        // In the order of the unknowns, so that sums do not depend on the hash.
        forces.sort_by_key(|f| f.0);
        forces
    }
}

/// Size of a correction relative to the unknowns, however much stiffer than the system the preconditioner is.
fn relative<const D: usize>(correction: &[f64], solution: &StateSolution, scales: &[f64; D]) -> f64 {
    let unknowns = size(&solution.u, scales).max(f64::MIN_POSITIVE);
    size(correction, scales) / unknowns / solution.least_eigenvalue
}
