//! From equilibrium to equilibrium.
//!
//! Between two breaks the body is linear in the load factor λ, so every equilibrium is known from the displacements `u₁`
//! at the unit load: a bond breaks at `λ = 1/ratio` of its strain there. `worst` goes to that of the worst bond, wherever
//! it is: the load may snap back. The others raise λ step by step and break what is overstrained until nothing is.

use super::super::factor::SolverReport;
use super::super::{Counters, Problem, RunError, RunReport, Sink, Sizes, SolvedState, Timing};
use super::islands::Islands;
use super::ledger::Ledger;
use super::problem::{BreakingBody, Facts};
use super::unit::Unit;
use super::{Event, Restart};
use crate::case::Strategy;
use crate::diagnostic::Faults;
use peristat_assembly::model::Breakable;
use peristat_assembly::system::System;
use std::time::Instant;

/// Residual of an equilibrium over the sudden jump: the energies of `worst` are to balance from event to event.
const FINE: f64 = 1e-12;
/// The same where only the order of strains matters.
const COARSE: f64 = 1e-8;
/// How far beyond its critical load the first bond is taken, so that rounding does not keep it.
const BEYOND: f64 = 1e-7;
/// Rounding of a ratio times the load factor that is its inverse.
const ROUNDING: f64 = 1e-12;
/// Strain energy at the unit load over that of the intact body, below which nothing is strained any more.
const NOTHING: f64 = 1e-12;

/// Why a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ending {
    /// The loads as written are borne.
    FullLoad,
    /// The load fell below a part of its peak.
    LoadGone,
    /// What carried the loads has come off.
    CameOff,
    /// As many equilibria as were asked for.
    MostSolves,
}

impl Ending {
    /// In words.
    pub(super) fn words(self) -> &'static str {
        match self {
            Self::FullLoad => "the full load is reached",
            Self::LoadGone => "the load fell below its part of the peak",
            Self::CameOff => "nothing carries the load any more",
            Self::MostSolves => "as many equilibria as allowed were found",
        }
    }
}

/// What goes on at an equilibrium.
struct Next {
    load_factor: f64,
    /// Bonds that break there.
    breaking: Vec<u64>,
}

/// A body that breaks.
struct Breaking<'a, const D: usize, P> {
    body: &'a mut P,
    system: System<D>,
    unit: Unit<D>,
    islands: Islands,
    ledger: Ledger,
    events: Vec<Event>,
    broken: Vec<u64>,
    /// Of the broken bonds, those that were broken when the factor was made.
    factored: usize,
    recorded: usize,
    step: usize,
    /// Whether what is left bears loads.
    bears: bool,
    timing: Timing,
    converged: bool,
}

/// How a body broke.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct FractureReport {
    /// Why the run ended.
    pub ending: &'static str,
    /// Equilibria.
    pub solves: usize,
    /// Bonds that broke.
    pub broken_bonds: usize,
    /// Points of parts that came off.
    pub island_points: usize,
    /// Conjugate-gradient iterations per equilibrium, on the mean.
    pub mean_iterations: f64,
    /// What checks can ask for, by name.
    pub facts: serde_json::Map<String, serde_json::Value>,
}

/// Breaks the bonds of a prepared problem, and hands equilibria on.
///
/// # Errors
/// [`RunError`]: the stiffness has no factor, a result cannot be taken, the run was interrupted.
pub(in super::super) fn run<const D: usize, P: BreakingBody<D>>(
    body: &mut P,
    (system, sizes): (System<D>, Sizes),
    resume: Option<Restart>,
    sink: &mut dyn Sink,
) -> Result<RunReport, RunError> {
    let mut breaking = match resume {
        Some(restart) => Breaking::resume(body, system, restart)?,
        None => Breaking::begin(body, system)?,
    };
    if let Some(last) = breaking.events.last() {
        // A restart is of an equilibrium at which bonds are about to break.
        let next = breaking.at(last.load_factor, breaking.worst());
        breaking.break_bonds(&next.breaking)?;
    }
    let ending = loop {
        let next = breaking.next();
        if let Some(ending) = breaking.reach(&next, sink)? {
            break ending;
        }
        breaking.break_bonds(&next.breaking)?;
    };
    Ok(breaking.report(sizes, ending))
}

impl<'a, const D: usize, P: BreakingBody<D>> Breaking<'a, D, P> {
    /// The intact body, factored.
    fn new(body: &'a mut P, system: System<D>) -> Result<Self, RunError> {
        let mut timing = Timing::default();
        let islands = Islands::new(body.problem().model());
        let mut loads = vec![0.0; system.size()];
        body.problem().add_load(0, &mut loads);
        let tolerance = if body.fracture().strategy == Strategy::Worst { FINE } else { COARSE };
        let unit = Unit::new(body.problem(), &system, loads, tolerance, &mut timing)?;
        Ok(Self {
            body,
            system,
            unit,
            islands,
            ledger: Ledger::default(),
            events: Vec::new(),
            broken: Vec::new(),
            factored: 0,
            recorded: 0,
            step: 0,
            bears: true,
            timing,
            converged: true,
        })
    }

    /// From the intact body.
    fn begin(body: &'a mut P, system: System<D>) -> Result<Self, RunError> {
        let mut all = Self::new(body, system)?;
        all.unit.solve(&all.system, &mut all.timing)?;
        Ok(all)
    }

    /// From a restart: with the factor that there was, of the matrix that was analysed, so that all goes on to the last bit
    /// as if it had not stopped.
    fn resume(body: &'a mut P, system: System<D>, restart: Restart) -> Result<Self, RunError> {
        let (factored, later) = restart.broken.split_at(restart.factored.min(restart.broken.len()));
        let mut all = Self::new(body, system)?;
        all.unit.u = restart.unit;
        if !factored.is_empty() {
            all.remove(factored);
            all.unit.refactor(&all.system, &mut all.timing)?;
        }
        all.remove(later);
        all.islands.set_frozen(restart.islands);
        all.unit.resume(&all.system, &restart.events);
        let last = restart.events.last().copied().unwrap_or_default();
        all.ledger = Ledger::resume(last.work, last.released, last.bond_energy, restart.load_factor);
        (all.events, all.broken, all.factored) = (restart.events, restart.broken, restart.factored);
        (all.recorded, all.step) = (restart.recorded, restart.step);
        Ok(all)
    }

    /// Removes bonds, and takes out what comes off with them: it bears no loads any more. Whether there is such.
    fn remove(&mut self, bonds: &[u64]) -> bool {
        self.system.change_model(self.body.model_mut(), |model| model.break_bonds(bonds));
        let load_factor = self.events.last().map_or(0.0, |e| e.load_factor);
        let u: Vec<f64> = self.unit.u.iter().map(|u| load_factor * u).collect();
        let problem = self.body.problem();
        let found = self.islands.find(problem.model(), &mut self.system, problem.equations(), &u);
        self.islands.frozen().iter().for_each(|&(unknown, _)| self.unit.loads[unknown as usize] = 0.0);
        found
    }

    /// Whether a bond can break.
    fn may_break(&self, bond: u64) -> bool {
        let ends = self.body.problem().model().ends(bond);
        !ends.iter().any(|&p| self.body.fracture().exempt[p]) && !self.islands.holds(ends)
    }

    /// Calls `visit` with every bond and the ratio of its strain at the unit load to its critical one.
    fn for_each_ratio(&self, visit: &mut dyn FnMut(u64, f64)) {
        self.body.problem().model().for_each_ratio(&self.unit.u, &self.body.fracture().critical, visit);
    }

    /// The largest of these ratios of a bond that can break.
    fn worst(&self) -> f64 {
        let mut worst = 0.0;
        self.for_each_ratio(&mut |bond, ratio| {
            if ratio > worst && self.may_break(bond) {
                worst = ratio;
            }
        });
        worst
    }

    /// What happens at a load factor, `worst` being the largest ratio.
    fn at(&self, load_factor: f64, worst: f64) -> Next {
        let fracture = self.body.fracture();
        let mut breaking = Vec::new();
        if worst * load_factor >= 1.0 - ROUNDING {
            let overstrained = if fracture.strategy == Strategy::Worst { 0.0 } else { 1.0 / load_factor };
            let limit = overstrained.max(fracture.threshold * worst);
            self.for_each_ratio(&mut |bond, ratio| {
                if ratio >= limit && self.may_break(bond) {
                    breaking.push(bond);
                }
            });
        }
        Next { load_factor, breaking }
    }

    /// Whether nothing of what is left is strained any more.
    fn is_slack(&self) -> bool {
        let strained = |first: &Event| first.stored / (first.load_factor * first.load_factor);
        let intact = self.events.first().map_or(0.0, strained);
        !self.broken.is_empty() && self.unit.energy.stored <= NOTHING * intact
    }

    /// The next equilibrium: at the load factor that the worst bond bears, or that of the step.
    fn next(&mut self) -> Next {
        if !self.bears {
            return Next { load_factor: 0.0, breaking: Vec::new() };
        }
        if let Some(last) = self.events.last().filter(|_| self.is_slack()) {
            // No load factor breaks anything more: the run ends where the last bond broke.
            return Next { load_factor: last.load_factor, breaking: Vec::new() };
        }
        let worst = self.worst();
        let bearable = 1.0 / worst;
        let fracture = self.body.fracture();
        let load_factor = match (fracture.strategy, self.events.last()) {
            (Strategy::Worst, _) => bearable,
            (_, None) => bearable * (1.0 + BEYOND),
            (_, Some(last)) if last.broken_now > 0 => last.load_factor,
            (_, Some(last)) => {
                let next = last.load_factor + fracture.increment;
                self.step += 1;
                next
            }
        };
        self.at(load_factor.min(1.0), worst)
    }

    /// Goes to an equilibrium, tells of it, and says whether the run ends there.
    fn reach(&mut self, next: &Next, sink: &mut dyn Sink) -> Result<Option<Ending>, RunError> {
        self.ledger.load(next.load_factor, self.unit.energy);
        let squared = next.load_factor * next.load_factor;
        let stored = squared * self.unit.energy.stored;
        let u: Vec<f64> = self.unit.u.iter().map(|u| next.load_factor * u).collect();
        let multipliers: Vec<f64> = self.unit.multipliers.iter().map(|m| next.load_factor * m).collect();
        let event = Event {
            step: self.step,
            solve: self.events.len(),
            load_factor: next.load_factor,
            load: self.body.load(&u, &multipliers),
            broken_now: next.breaking.len(),
            broken: self.broken.len(),
            islands: self.islands.points(),
            work: self.ledger.work,
            stored,
            released: self.ledger.released,
            bond_energy: self.ledger.bond_energy,
            unstable_release: self.ledger.released - self.ledger.bond_energy,
            balance: self.ledger.imbalance(stored),
            iterations: self.unit.iterations,
            factorisations: self.unit.counters.factorisations,
            residual: self.unit.residual,
        };
        self.events.push(event);
        let ending = self.ending(&event);
        let is_first = self.events.iter().filter(|e| e.broken_now > 0).count() == 1 && event.broken_now > 0;
        if is_first || ending.is_some() || event.solve.is_multiple_of(self.body.fracture().record_every) {
            self.record(next.load_factor, ending, sink)?;
        }
        let restart = || self.restart(next.load_factor);
        sink.advance(&event, ending.is_none().then_some(&restart))?;
        match ending {
            None if sink.is_interrupted() => Err(RunError::Interrupted),
            ending => Ok(ending),
        }
    }

    fn ending(&self, event: &Event) -> Option<Ending> {
        let fracture = self.body.fracture();
        let peak = self.events.iter().map(|e| e.load.abs()).fold(0.0, f64::max);
        if self.is_slack() {
            Some(Ending::CameOff)
        } else if event.broken > 0 && event.load.abs() < fracture.stop_below * peak {
            Some(Ending::LoadGone)
        } else if event.load_factor >= 1.0 && event.broken_now == 0 {
            Some(Ending::FullLoad)
        } else if self.events.len() >= fracture.max_solves {
            Some(Ending::MostSolves)
        } else {
            None
        }
    }

    /// Certifies the present equilibrium and hands it on.
    fn record(
        &mut self,
        load_factor: f64,
        ending: Option<Ending>,
        sink: &mut dyn Sink,
    ) -> Result<(), RunError> {
        let at = (load_factor, ending == Some(Ending::CameOff));
        let (load, solution, certificate) =
            self.unit.certified(self.body.problem(), &self.system, at, &mut self.timing);
        self.converged &= certificate.converged;
        let begin = Instant::now();
        let facts = Facts::of(&self.events, self.body.facts(&self.broken));
        let solved = SolvedState { state: self.recorded, load: &load, solution, certificate };
        let name = format!("equilibrium {}", self.events.len() - 1);
        let mut result = self.body.result(solved, name, load_factor, facts);
        // Only now: fields are those of the parts without strain.
        self.islands.place(&mut result.record_mut().u);
        sink.take(result)?;
        self.recorded += 1;
        self.timing.record += begin.elapsed().as_secs_f64();
        Ok(())
    }

    fn restart(&self, load_factor: f64) -> Restart {
        Restart {
            events: self.events.clone(),
            broken: self.broken.clone(),
            factored: self.factored,
            unit: self.unit.u.clone(),
            islands: self.islands.frozen().to_vec(),
            recorded: self.recorded,
            step: self.step,
            load_factor,
            ..Restart::default()
        }
    }

    /// Breaks bonds at the load factor of the last equilibrium, and finds the next one at the unit load.
    fn break_bonds(&mut self, bonds: &[u64]) -> Result<(), RunError> {
        if bonds.is_empty() {
            return Ok(());
        }
        let gone = self.body.problem().model().part(bonds);
        let (before, ledger, energy) = (self.unit.u.clone(), self.ledger, self.unit.energy);
        self.broken.extend(bonds);
        if self.remove(bonds) {
            let mut forces = vec![0.0; self.system.size()];
            self.system.force(&before, &mut forces);
            gone.iter().for_each(|term| term.add_force(&before, &mut forces));
            let off = self.islands.frozen().iter().map(|&(unknown, _)| unknown as usize);
            self.ledger.come_off(off.map(|k| (forces[k], before[k])));
        }
        let found = self.unit.solve(&self.system, &mut self.timing)?;
        if found.refactored {
            self.factored = self.broken.len();
        }
        self.bears = found.borne;
        if !found.borne {
            // There is no equilibrium at any load: as if all loads went before the bonds.
            self.unit.rest();
            self.ledger = ledger;
            self.ledger.load(0.0, energy);
            return Ok(());
        }
        self.ledger.lose(&gone, &self.unit.loads, [&before, &self.unit.u]);
        Ok(())
    }

    fn report(self, sizes: Sizes, ending: Ending) -> RunReport {
        let facts = Facts::of(&self.events, self.body.facts(&self.broken));
        let mut counters: Counters = self.unit.counters.clone();
        let solver = SolverReport {
            method: "sparse_cholesky".into(),
            reason: "a body that breaks keeps its factor from equilibrium to equilibrium".into(),
            factor_entries: counters.factor_bytes / size_of::<f64>(),
            iterations: Vec::new(),
        };
        counters.bond_evaluations = self.system.evaluations();
        counters.stored_bond_factors = self.system.terms().iter().map(|t| t.stored_factors()).sum();
        let iterations: usize = self.events.iter().map(|e| e.iterations).sum();
        RunReport {
            sizes,
            solver,
            counters,
            timing: self.timing,
            skipped: Vec::new(),
            warnings: Faults::default(),
            converged: self.converged,
            fracture: Some(FractureReport {
                ending: ending.words(),
                solves: self.events.len(),
                broken_bonds: self.broken.len(),
                island_points: self.islands.points(),
                mean_iterations: iterations as f64 / self.events.len().max(1) as f64,
                facts: facts.0.into_iter().map(|(name, value)| (name, value.into())).collect(),
            }),
        }
    }
}
