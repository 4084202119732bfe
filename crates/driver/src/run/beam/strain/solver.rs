//! Reactions, displacements and their evidence, state by state.

use super::StrainProblem;
use super::evidence::Evidence;
use super::off;
use super::passes::Passes;
use super::reactions::Reactions;
use crate::run::workspace::StateSolution;
use crate::run::{SolveFailure, Timing};
use peristat_assembly::condition::Constraints;
use peristat_assembly::model::timoshenko_beam::{BeamLoads, ForceMethod, PHI, StrainSupport, TimoshenkoBeam};
use peristat_assembly::stiffness::Spring;
use peristat_solve::PcgStatus;
use std::time::Instant;

/// Passes at most: the loads alone, the reactions, twice their rounding.
const PASSES: usize = 4;
/// Displacements at supports that are off by less, relative to the largest, are only rounded.
const SETTLED: f64 = 4.0 * f64::EPSILON;

/// A factored strain form with its supports: any number of right-hand sides.
pub(super) struct StrainSolver<'a> {
    beam: &'a TimoshenkoBeam,
    constraints: &'a Constraints,
    passes: Passes<'a>,
    method: ForceMethod,
    /// Motions of the rigid supports, which come first, for a factor of one.
    motions: Vec<f64>,
    /// A lower bound of the eigenvalues of the scaled stiffness.
    least_eigenvalue: f64,
    /// Planes that the first state need not allocate.
    spare: Option<Vec<f64>>,
}

impl<'a> StrainSolver<'a> {
    /// Factors the stiffness and solves for unit reactions.
    ///
    /// # Errors
    /// [`SolveFailure`] if the stiffness has no factor.
    pub(super) fn new(
        problem: &StrainProblem<'a>,
        constraints: &'a Constraints,
        springs: &[Spring],
        timing: &mut Timing,
    ) -> Result<Self, SolveFailure> {
        let begin = Instant::now();
        let (beam, form) = (problem.beam, problem.form.clone());
        let points = beam.points();
        let rigid = constraints.rows().iter().map(|row| StrainSupport {
            point: row.unknown % points,
            component: row.unknown / points,
            compliance: 0.0,
        });
        let sprung = springs.iter().filter_map(|s| {
            let (component, stiffness) = s.single()?;
            Some(StrainSupport { point: s.point, component, compliance: 1.0 / stiffness })
        });
        let method = ForceMethod::new(&form, rigid.chain(sprung).collect());
        let motions = constraints.rows().iter().map(|row| row.value).collect();
        timing.assemble += begin.elapsed().as_secs_f64();
        let begin = Instant::now();
        let passes = Passes::new(form)?;
        let least_eigenvalue = problem.least_eigenvalue;
        let mut solver = Self { beam, constraints, passes, method, motions, least_eigenvalue, spare: None };
        timing.factor += begin.elapsed().as_secs_f64();
        let begin = Instant::now();
        solver.solve_units();
        timing.solve += begin.elapsed().as_secs_f64();
        Ok(solver)
    }

    /// Number of displacements that are held.
    pub(super) fn supports(&self) -> usize {
        self.method.supports().len()
    }

    /// Memory of the factor, bytes.
    pub(super) fn bytes(&self) -> usize {
        self.passes.bytes()
    }

    /// Displacements at the supports under unit reactions.
    fn solve_units(&mut self) {
        let units = self.method.units();
        if !units.is_empty() {
            let mut u = vec![0.0; 2 * self.beam.points()];
            for (support, unit) in units {
                self.passes.leftwards(None, &[unit], &mut u);
                self.passes.rightwards(None, &[unit], [0.0; 2], &mut u);
                self.method.set_flexibility(support, self.at_supports(&u));
            }
            self.spare = Some(u);
        }
    }

    fn at_supports(&self, u: &[f64]) -> Vec<f64> {
        let points = self.beam.points();
        self.method.supports().iter().map(|s| u[s.component * points + s.point]).collect()
    }

    /// Unknowns under loads and `motion_factor` times the prescribed motions.
    ///
    /// The first pass gives the displacements without reactions beyond the first point, and with them the reactions; the
    /// second those with reactions. A cantilever that is held at its first point needs only one. Redundant reactions are
    /// known to the rounding of much larger displacements at first: what this leaves at the supports is taken out.
    ///
    /// # Errors
    /// [`SolveFailure::Supports`] if the supports do not determine the reactions.
    pub(super) fn solve(
        &mut self,
        loads: &BeamLoads,
        motion_factor: f64,
    ) -> Result<(StateSolution, Evidence), SolveFailure> {
        let beam = self.beam;
        let on_chain = loads.on_chain(beam, 0);
        let mut u = self.spare.take().unwrap_or_else(|| vec![0.0; 2 * beam.points()]);
        let mut reactions = Reactions::first(self.method.supports(), self.motions.len(), &on_chain);
        let mut start = self.start(motion_factor);
        let mut evidence =
            Evidence { next_correction: f64::INFINITY, loaded: !on_chain.is_empty(), ..Default::default() };
        for pass in 0..PASSES {
            let actions = reactions.actions(self.method.supports());
            let resultant = self.passes.leftwards(Some(&on_chain), &actions, &mut u);
            let left_over = reactions.balance(self.method.supports(), resultant);
            let actions = reactions.actions(self.method.supports());
            evidence.checks = self.passes.rightwards(Some(&on_chain), &actions, start, &mut u);
            evidence.sizes = reactions.sizes(self.method.supports(), resultant);
            let gaps = self.gaps(&u, &reactions, motion_factor);
            let more = self.method.solve(&gaps, left_over).ok_or(SolveFailure::Supports)?;
            let off = off::supports(&self.method, &gaps, evidence.checks.largest)
                .max(off::forces(left_over, evidence.sizes));
            let stalled = pass > 1 && off >= 0.5 * evidence.next_correction;
            if pass == 2 {
                evidence.first_correction = evidence.next_correction;
            }
            evidence.next_correction = off;
            if off <= SETTLED || stalled || !off.is_finite() || pass + 1 == PASSES {
                break;
            }
            (0..2).for_each(|k| start[k] += more.start[k]);
            reactions.add(&more.reactions);
        }
        (evidence.length, evidence.cells) = (self.method.length(), self.passes.form().cells());
        evidence.least_eigenvalue = self.least_eigenvalue;
        evidence.rounding = self.passes.form().most_action(reactions.rounding(self.method.supports()));
        Ok((self.finish(u, &reactions, motion_factor, &mut evidence), evidence))
    }

    /// Displacements (w, φ) of the first point where they are prescribed.
    fn start(&self, motion_factor: f64) -> [f64; 2] {
        let mut start = [0.0; 2];
        for (support, motion) in
            self.method.supports().iter().zip(&self.motions).filter(|(s, _)| s.point == 0)
        {
            start[support.component] = motion * motion_factor;
        }
        start
    }

    /// What the displacements at the supports lack.
    fn gaps(&self, u: &[f64], reactions: &Reactions, motion_factor: f64) -> Vec<f64> {
        let motions = self.motions.iter().map(|motion| motion * motion_factor).chain(std::iter::repeat(0.0));
        let supports = self.method.supports().iter().zip(reactions.values());
        let lack = |((motion, (s, r)), u): ((f64, (&StrainSupport, f64)), f64)| motion - u - s.compliance * r;
        motions.zip(supports).zip(self.at_supports(u)).map(lack).collect()
    }

    /// The record of the state; supports are where they must be to the last bit.
    fn finish(
        &self,
        mut u: Vec<f64>,
        reactions: &Reactions,
        motion_factor: f64,
        evidence: &mut Evidence,
    ) -> StateSolution {
        let (points, rigid) = (self.beam.points(), self.motions.len());
        let number = |s: &StrainSupport| s.component * points + s.point;
        for (s, r) in self.method.supports().iter().zip(reactions.values()).skip(rigid) {
            u[number(s)] = -s.compliance * r;
            evidence.spring_energy += 0.5 * s.compliance * r * r;
        }
        let flexibility = self.method.largest_flexibility();
        for (s, motion) in self.method.supports().iter().zip(&self.motions) {
            u[number(s)] = motion * motion_factor;
            let moved = motion * motion_factor * if s.component == PHI { evidence.length } else { 1.0 };
            evidence.jump_energy += if flexibility > 0.0 { moved * moved / flexibility } else { 0.0 };
        }
        let held: Vec<(usize, f64)> = self.method.supports()[..rigid]
            .iter()
            .zip(reactions.values())
            .map(|(s, r)| (number(s), r))
            .collect();
        let force = |unknown: usize| held.iter().find(|h| h.0 == unknown).map_or(0.0, |h| h.1);
        StateSolution {
            u,
            jump_energy: evidence.jump_energy,
            cancels: false,
            multipliers: self.constraints.multipliers(force),
            held,
            residual: Vec::new(),
            next_correction: evidence.next_correction,
            correction_energy: 0.0,
            correction_action: 0.0,
            held_error: 0.0,
            action: 0.0,
            stored: None,
            by_factor: true,
            least_eigenvalue: 1.0,
            first_correction: evidence.first_correction,
            iterations: 0,
            status: PcgStatus::Converged,
            corrections: None,
        }
    }
}
