//! Solutions that double precision cannot resolve: found again with residuals in twice the precision.
//!
//! The factor, and conjugate gradients on the bonds with it, know a correction to a few digits where they know the solution
//! to none that another digit could be taken from. Repeated on an exact residual these digits add up.

use super::load::Load;
use super::measures::{ratio, worst};
use super::workspace::{Elementwise, StateSolution, Workspace, size};
use peristat_assembly::stiffness::Twofold;
use peristat_assembly::sum::Sum;
use peristat_assembly::system::System;
use peristat_solve::{PcgOptions, PcgStatus, Preconditioner};

/// A correction above this leaves doubt about digits that a double could hold.
pub(super) const DOUBTFUL: f64 = 1e-12;
/// Forces of constraints, such as those of joints, are small differences of large ones where members are stiff: an error above
/// this leaves doubt about digits that somebody may want.
pub(super) const DOUBTFUL_FORCES: f64 = 1e-11;
/// A correction below this changes no digit of a double, nor one of the forces of members 1e12 times as stiff as the softest.
const SETTLED: f64 = 1e-28;
/// Corrections at most.
const PASSES: usize = 12;
/// Error of a correction, in energy norm and squared, that the next one takes out again: a smaller one, below the rounding of
/// products, would have to be waited for.
const PASS: f64 = 1e-20;
/// Error of a correction of which only the size is wanted.
const SIZE: f64 = 1e-6;

fn correction_to(energy_drop: f64) -> PcgOptions {
    PcgOptions { energy_drop, ..PcgOptions::default() }
}

impl<const D: usize> Workspace<D> {
    /// Improves a solution with its load and factor on prescribed motions until no digit changes. `false`, and nothing is
    /// changed, if some term of the system has no forces in twice the precision.
    pub(super) fn refine(
        &mut self,
        system: &System<D>,
        preconditioner: &mut dyn Preconditioner,
        (load, motion_factor): (&Load<D>, f64),
        solution: &mut StateSolution,
    ) -> bool {
        let n = solution.u.len();
        let (mut high, mut low, mut step) = (solution.u.clone(), vec![0.0; n], vec![0.0; n]);
        let mut force = vec![Sum::default(); n];
        let mut before = f64::INFINITY;
        for pass in 0..=PASSES {
            system.constraints().expand_twofold(motion_factor, &mut high, &mut low);
            if !system.force_twofold(Twofold { high: &high, low: &low }, &mut force) {
                return false;
            }
            self.take_residual(system, load.forces, &mut force, solution);
            step.fill(0.0);
            let report = self.pcg.solve(
                &Elementwise(system),
                preconditioner,
                &mut self.residual,
                &mut step,
                &correction_to(PASS),
            );
            solution.iterations += report.iterations;
            // A correction that could not be found says nothing: the last one was as large as the error may be.
            let correction = match report.status {
                PcgStatus::Converged | PcgStatus::Stagnated => {
                    size(&step, &self.scales) / size(&high, &self.scales).max(f64::MIN_POSITIVE)
                }
                _ => before,
            };
            solution.next_correction = correction;
            // What does not shrink is as far as it goes; what is not a number ends here, too.
            let shrinks = correction > SETTLED && correction < 0.5 * before;
            if !shrinks || pass == PASSES {
                break;
            }
            before = correction;
            for ((high, low), step) in high.iter_mut().zip(&mut low).zip(&step) {
                let mut sum = Sum::of(*high);
                sum.add(*low);
                sum.add(*step);
                [*high, *low] = sum.parts();
            }
        }
        // Forces of constraints are of both parts of the unknowns, without the last correction, and rounded once.
        let held_error = self.error_of_constraints(system, &mut step, &solution.held);
        solution.u = high;
        solution.status = PcgStatus::Converged;
        let rounded = ratio(
            self.rounding_of_loads(system, preconditioner, load, &mut step),
            size(&solution.u, &self.scales),
        );
        solution.next_correction = worst([solution.next_correction, rounded]);
        self.weigh_strains(system, preconditioner, load.forces, solution);
        solution.held_error = if solution.next_correction.is_finite() { held_error } else { f64::INFINITY };
        true
    }

    /// The largest error of forces of constraints that a correction would take out, or that is their rounding.
    fn error_of_constraints(&mut self, system: &System<D>, step: &mut [f64], held: &[(usize, f64)]) -> f64 {
        system.constraints().expand(0.0, step);
        system.force(step, &mut self.residual);
        let scale = |unknown: usize| self.scales[unknown / system.points()];
        let rounded = held.iter().map(|&(unknown, force)| f64::EPSILON * force.abs() * scale(unknown));
        worst(rounded.chain([self.largest_held(system, &self.residual)]))
    }

    /// How far loads that are rounded otherwise would move the body: they are doubles, and where they all but balance each
    /// other a soft support feels it.
    fn rounding_of_loads(
        &mut self,
        system: &System<D>,
        preconditioner: &mut dyn Preconditioner,
        load: &Load<D>,
        step: &mut [f64],
    ) -> f64 {
        self.residual.fill(0.0);
        load.add_rounding(&mut self.residual);
        system.constraints().restrict(&mut self.residual);
        step.fill(0.0);
        let options = correction_to(SIZE);
        let report = self.pcg.solve(&Elementwise(system), preconditioner, &mut self.residual, step, &options);
        match report.status {
            PcgStatus::Converged | PcgStatus::Stagnated => size(step, &self.scales),
            _ => f64::INFINITY,
        }
    }

    /// Takes the residual of forces in twice the precision, and what constraints and certificate need of it.
    fn take_residual(
        &mut self,
        system: &System<D>,
        load: &[f64],
        force: &mut [Sum],
        solution: &mut StateSolution,
    ) {
        for (force, load) in force.iter_mut().zip(load) {
            *force = -*force;
            force.add(*load);
        }
        self.residual.iter_mut().zip(&*force).for_each(|(r, f)| *r = f.total());
        self.find_constraint_forces(system, solution);
        system.constraints().restrict_twofold(force);
        self.residual.iter_mut().zip(&*force).for_each(|(r, f)| *r = f.total());
        self.find_largest_residuals(solution);
    }
}
