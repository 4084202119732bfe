//! The equilibrium at the unit load of a body that changes, found again and again: from the last one, with the last inverse.

use super::super::certificate::{self, Certificate};
use super::super::kept_inverse::KeptInverse;
use super::super::load::Load;
use super::super::solve_failure::SolveFailure;
use super::super::workspace::{StateSolution, Workspace, jump, jump_energy, norm};
use super::super::{Counters, Problem, Timing};
use super::ledger::UnitEnergy;
use super::lost::{LostParts, Parts};
use super::{BreakRestart, FreeLoad};
use peristat_assembly::system::System;
use peristat_solve::{PcgReport, PcgStatus};
use std::time::Instant;

/// Residual over the sudden jump of what is recorded, and the iterations that may take.
const POLISHED: f64 = 1e-12;
const POLISHING: usize = 60;
/// Part of an error that a cycle corrects, below which rounding is what is left.
const LEAST: f64 = 1e-3;
/// Iterations with a new inverse.
const PATIENCE: usize = 100;
/// Iterations among the unknowns of broken bonds after which a new inverse is cheaper. A plate of 11 200 points that takes 1478 bonds
/// from equilibrium to equilibrium is broken in 13.7 seconds of a processor with 12, 18.2 with 8, 17.3 with 16 and 22.5 with 40.
const REDUCED: usize = 12;
/// Displacements over those of the last equilibrium, at the same load, that are those of what moves without strain.
const FAR: f64 = 1e6;
/// Residual over the sudden jump up to which rounding may be what is left.
const ROUGH: f64 = 1e-6;

/// The unit load and the displacements under it.
pub(super) struct Unit<const D: usize> {
    pub(super) inverse: KeptInverse,
    /// What the body has lost since this was made.
    pub(super) lost_parts: LostParts<D>,
    work: Workspace<D>,
    pub(super) counters: Counters,
    /// Loads at a load factor of one.
    pub(super) loads: Vec<f64>,
    /// What strains that need no stress do beside them.
    pub(super) free: Option<FreeLoad>,
    /// The sum of both.
    all: Vec<f64>,
    /// Displacements at a load factor of one.
    pub(super) u: Vec<f64>,
    /// Forces that hold the equations.
    pub(super) multipliers: Vec<f64>,
    pub(super) energy: UnitEnergy,
    /// The largest strain energy of an equilibrium so far.
    most_stored: f64,
    pub(super) iterations: usize,
    /// Residual, 2-norm.
    pub(super) residual: f64,
    /// Largest residual, 2-norm.
    target: f64,
    /// Residual of a sudden jump, 2-norm.
    jump: f64,
}

/// How displacements were improved before they are recorded.
struct Polished {
    status: PcgStatus,
    /// Part of an error that the inverse corrects at the least.
    least_eigenvalue: f64,
    /// Whether a new inverse was made.
    renewed: bool,
}

/// How displacements were found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Outcome {
    /// They are an equilibrium.
    Found,
    /// There is none: the loads act on what moves without strain.
    Unborne,
    /// They are none, and it is not known why.
    Lost,
}

impl<const D: usize> Unit<D> {
    /// Factors the system, whose loads at a load factor of one are `all`, those of `free` among them; residuals up to `tolerance` times
    /// that of a sudden jump will do.
    ///
    /// # Errors
    /// [`SolveFailure`] if there is no factor.
    pub(super) fn new(
        problem: &dyn Problem<D>,
        system: &System<D>,
        (all, free): (Vec<f64>, Option<FreeLoad>),
        tolerance: f64,
        timing: &mut Timing,
    ) -> Result<Self, SolveFailure> {
        // Where nothing can move, heat leaves no force but on what holds the body.
        let jump = jump(system, &all).max(free.as_ref().map_or(0.0, |free| norm(&free.load)));
        let mut loads = all.clone();
        if let Some(free) = &free {
            loads.iter_mut().zip(&free.load).for_each(|(all, own)| *all -= own);
        }
        let mut counters = Counters::default();
        Ok(Self {
            inverse: KeptInverse::new(problem, system, timing, &mut counters)?,
            lost_parts: LostParts::new(system),
            work: Workspace::new(problem, system),
            counters,
            free,
            all,
            loads,
            u: vec![0.0; system.size()],
            multipliers: Vec::new(),
            energy: UnitEnergy::default(),
            most_stored: 0.0,
            iterations: 0,
            residual: f64::INFINITY,
            target: tolerance * jump,
            jump,
        })
    }

    /// Finds the displacements of the system as it is now. How, and whether a new inverse was made.
    ///
    /// # Errors
    /// [`SolveFailure`] if the stiffness has no factor.
    pub(super) fn solve(
        &mut self,
        problem: &dyn Problem<D>,
        system: &System<D>,
        timing: &mut Timing,
    ) -> Result<(Outcome, bool), SolveFailure> {
        let begin = Instant::now();
        let mut renewed = false;
        let follow = |unit: &mut Self, iterations: usize| {
            let vectors = (&unit.all[..], &mut unit.u[..]);
            let followed = unit.work.follow(system, &mut unit.inverse, vectors, unit.target, iterations);
            unit.residual = followed.residual;
            unit.iterations += followed.iterations;
            followed.reached
        };
        self.iterations = 0;
        // A mechanism leaves nothing of the displacements that are improved.
        let before = self.u.clone();
        let mut u = std::mem::take(&mut self.u);
        let corrected = self.correct(system, &mut u, self.target);
        self.u = u;
        self.iterations += corrected.map_or(0, |report| report.iterations);
        let is_spent = corrected.is_some_and(|report| report.status != PcgStatus::Converged);
        let mut reached = !is_spent && follow(self, self.inverse.patience());
        if !reached {
            self.renew(problem, system, timing)?;
            renewed = true;
            reached = follow(self, PATIENCE);
        }
        let outcome = match reached {
            true => Outcome::Found,
            false if self.residual <= ROUGH * self.jump => {
                // A new inverse does no better: more is not to be had.
                self.target = 2.0 * self.residual;
                Outcome::Found
            }
            false => self.unborne_or_lost(system, &before),
        };
        self.counters.right_hand_sides += 1;
        self.counters.pcg_iterations += self.iterations;
        self.weigh(system);
        // What moves without strain leaves a small residual, and a work that nothing stores.
        let outcome = match outcome {
            Outcome::Found if !self.energy.balances(self.most_stored) => {
                self.unborne_or_lost(system, &before)
            }
            outcome => outcome,
        };
        if outcome == Outcome::Found {
            self.most_stored = self.most_stored.max(self.energy.stored);
        }
        timing.solve += begin.elapsed().as_secs_f64();
        Ok((outcome, renewed))
    }

    /// Improves displacements where bonds went until their residual is at most `target`, if the inverse is a factor that this is possible with.
    fn correct(&mut self, system: &System<D>, u: &mut [f64], target: f64) -> Option<PcgReport> {
        let factor = self.inverse.dissected().filter(|_| self.lost_parts.suits(system))?;
        self.work.refresh_residual(system, &self.all, u);
        system.constraints().restrict(&mut self.work.residual);
        self.lost_parts.correct(system, factor, (&self.work.residual, u), target, REDUCED)
    }

    /// Why there is no equilibrium, after the last one: the loads act on what moves without strain, by what the inverse says of it or as
    /// it moves beyond all measure, or it is not known.
    fn unborne_or_lost(&mut self, system: &System<D>, before: &[f64]) -> Outcome {
        // Of the intact body there is no last one.
        let last = norm(before);
        let is_far = last > 0.0 && norm(&self.u) > FAR * last;
        match is_far || self.work.yields(system, &mut self.inverse, (&self.all, before)) {
            true => Outcome::Unborne,
            false => Outcome::Lost,
        }
    }

    /// Takes parts for gone from the system whose inverse there is.
    pub(super) fn lose(&mut self, parts: &Parts<D>) {
        if self.inverse.dissected().is_some() {
            self.lost_parts.push(parts);
        }
    }

    /// Makes the inverse that of the system as it is now.
    ///
    /// # Errors
    /// [`SolveFailure`] if the stiffness has no factor.
    pub(super) fn renew(
        &mut self,
        problem: &dyn Problem<D>,
        system: &System<D>,
        timing: &mut Timing,
    ) -> Result<(), SolveFailure> {
        self.inverse.renew(problem, system, timing, &mut self.counters)?;
        self.lost_parts = LostParts::new(system);
        Ok(())
    }

    /// Goes on with the displacements at hand after the equilibria of another run.
    pub(super) fn resume(&mut self, system: &System<D>, restart: &BreakRestart) {
        if let Some(last) = restart.events.last() {
            self.counters.factorisations = last.factorisations;
            self.residual = last.residual;
        }
        let stored = restart.events.iter().filter(|event| event.load_factor > 0.0);
        let stored = stored.map(|event| event.stored / event.load_factor.powi(2));
        self.most_stored = stored.fold(0.0, f64::max);
        self.counters.right_hand_sides = restart.right_hand_sides;
        self.counters.pcg_iterations = restart.pcg_iterations;
        self.target = restart.target;
        self.weigh(system);
    }

    /// Says what of it a restart needs, beside the displacements.
    pub(super) fn save(&self, restart: &mut BreakRestart) {
        restart.right_hand_sides = self.counters.right_hand_sides;
        restart.pcg_iterations = self.counters.pcg_iterations;
        restart.target = self.target;
    }

    /// Takes displacements, forces and energies for zero: what is left bears nothing.
    pub(super) fn rest(&mut self) {
        self.u.fill(0.0);
        self.multipliers.fill(0.0);
        self.residual = 0.0;
        self.energy = UnitEnergy::default();
    }

    /// Takes the loads as they are now, with what strains that need no stress do to what is left.
    pub(super) fn set_free(&mut self, free: Option<FreeLoad>) {
        self.all.clone_from(&self.loads);
        if let Some(free) = &free {
            self.all.iter_mut().zip(&free.load).for_each(|(all, own)| *all += own);
        }
        self.free = free;
    }

    /// Finds what follows from the displacements.
    fn weigh(&mut self, system: &System<D>) {
        let (multipliers, held_work) = self.work.hold(system, &self.all, &self.u);
        let loads_work: f64 = self.loads.iter().zip(&self.u).map(|(f, u)| f * u).sum();
        self.multipliers = multipliers;
        let of_free = |free: &FreeLoad| [free.work(&self.u), free.stored(&self.u)];
        let [heat, stored] = self.free.as_ref().map_or([0.0; 2], of_free);
        self.energy = UnitEnergy {
            work: 0.5 * (loads_work + held_work) + heat,
            stored: system.survey(&self.u).energy + stored,
        };
    }

    /// Improves displacements at the unit load to what is recorded.
    ///
    /// # Errors
    /// [`SolveFailure`] if the stiffness has no factor.
    fn polish(
        &mut self,
        problem: &dyn Problem<D>,
        system: &System<D>,
        u: &mut [f64],
        timing: &mut Timing,
    ) -> Result<Polished, SolveFailure> {
        let mut target = POLISHED * self.jump;
        let mut found = Polished { status: PcgStatus::Converged, least_eigenvalue: 1.0, renewed: false };
        loop {
            if let Some(report) = self.correct(system, u, target) {
                self.counters.pcg_iterations += report.iterations;
                found.least_eigenvalue = report.least_eigenvalue.min(found.least_eigenvalue);
            }
            let vectors = (&self.all[..], &mut *u);
            let followed = self.work.follow(system, &mut self.inverse, vectors, target, POLISHING);
            self.counters.pcg_iterations += followed.iterations;
            found.least_eigenvalue = followed.least_eigenvalue.min(found.least_eigenvalue);
            // Where a cycle corrects a small part of an error, the residual tells that much less of it.
            let least = found.least_eigenvalue.max(LEAST) * POLISHED * self.jump;
            match followed.reached {
                true if self.inverse.is_factor() || target <= least => return Ok(found),
                true => target = least,
                // A factor that is old does as well as a new one; an old cycle does not know what has nearly come off.
                false if found.renewed || self.inverse.is_factor() => {
                    found.status = PcgStatus::IterationLimit;
                    return Ok(found);
                }
                false => {
                    self.renew(problem, system, timing)?;
                    found.renewed = true;
                }
            }
        }
    }

    /// Solution and certificate at a load factor, of a body that may be slack: its forces are rounding, which has no
    /// balance. Also whether a new inverse was made.
    ///
    /// # Errors
    /// [`SolveFailure`] if the stiffness has no factor.
    pub(super) fn certified(
        &mut self,
        problem: &dyn Problem<D>,
        system: &System<D>,
        (load_factor, is_slack): (f64, bool),
        timing: &mut Timing,
    ) -> Result<(Vec<f64>, StateSolution, Certificate, bool), SolveFailure> {
        let begin = Instant::now();
        let loads: Vec<f64> = self.all.iter().map(|f| load_factor * f).collect();
        // What is recorded is better than what the next break is found with, and does not change it.
        let mut u = self.u.clone();
        let Polished { status, least_eigenvalue, renewed } = match load_factor > 0.0 {
            true => self.polish(problem, system, &mut u, timing)?,
            false => Polished { status: PcgStatus::Converged, least_eigenvalue: 1.0, renewed: false },
        };
        let mut solution = StateSolution::of(u.into_iter().map(|u| load_factor * u).collect());
        (solution.iterations, solution.least_eigenvalue, solution.status) =
            (self.iterations, least_eigenvalue, status);
        solution.by_factor = self.inverse.is_factor();
        let suddenly = load_factor * load_factor * jump_energy(system);
        solution.jump_energy = if is_slack { f64::INFINITY } else { suddenly };
        self.work.weigh(system, &mut self.inverse, (&loads, load_factor), &mut solution);
        let load = Load::new(problem.model(), &loads);
        self.work.doubt(system, &mut self.inverse, &load, &mut solution);
        if is_slack {
            // Displacements are rounding, too, and so is what would correct them.
            solution.next_correction = 0.0;
        }
        let certificate = certificate::certify(problem, system, &loads, &solution, &self.work.scales);
        timing.certify += begin.elapsed().as_secs_f64();
        Ok((loads, solution, certificate, renewed))
    }
}
