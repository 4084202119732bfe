//! A body that breaks: what of it is left, what has gone, and where it is.

use super::super::restart::{Restart, RestartFrom};
use super::super::{RunError, Sink, SolvedState, Timing};
use super::ending::Ending;
use super::islands::Islands;
use super::ledger::Ledger;
use super::lost::Parts;
use super::problem::{BreakingBody, Facts};
use super::unit::{Outcome, Unit};
use super::{BreakRestart, Event, FreeLoad};
use crate::case::Strategy;
use peristat_assembly::model::Breakable;
use peristat_assembly::system::System;
use std::ops::Range;
use std::time::Instant;

/// Residual of an equilibrium over the sudden jump: the energies of `worst` are to balance from event to event.
const FINE: f64 = 1e-12;
/// The same where only the order of strains matters.
const COARSE: f64 = 1e-8;

/// A body that breaks.
pub(super) struct Breaking<'a, const D: usize, P> {
    pub(super) body: &'a mut P,
    pub(super) system: System<D>,
    pub(super) unit: Unit<D>,
    pub(super) islands: Islands,
    pub(super) ledger: Ledger,
    pub(super) events: Vec<Event>,
    pub(super) broken: Vec<u64>,
    /// Of the broken bonds, those that were broken when the inverse was made.
    pub(super) factored: usize,
    pub(super) recorded: usize,
    pub(super) step: usize,
    /// Whether the load is zero but for rounding.
    pub(super) is_rounding: bool,
    /// Whether loads acted on what has come off.
    pub(super) loads_gone: bool,
    /// How the displacements at hand were found.
    pub(super) outcome: Outcome,
    pub(super) timing: Timing,
    pub(super) converged: bool,
}

/// What went with bonds.
struct Removed<const D: usize> {
    gone: Parts<D>,
    /// Whether anything came off.
    came_off: bool,
    /// What strains that need no stress did to all that the bonds leave.
    left: Option<FreeLoad>,
}

impl<'a, const D: usize, P: BreakingBody<D>> Breaking<'a, D, P> {
    /// The intact body, factored.
    pub(super) fn new(body: &'a mut P, system: System<D>) -> Result<Self, RunError> {
        let mut timing = Timing::default();
        let islands = Islands::new(body.problem().model());
        let mut loads = vec![0.0; system.size()];
        body.problem().add_load(0, &mut loads);
        let free = body.free_load();
        let tolerance = if body.fracture().strategy == Strategy::Worst { FINE } else { COARSE };
        let unit = Unit::new(body.problem(), &system, (loads, free), tolerance, &mut timing)?;
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
            is_rounding: false,
            loads_gone: false,
            outcome: Outcome::Found,
            timing,
            converged: true,
        })
    }

    /// From the intact body.
    pub(super) fn begin(body: &'a mut P, system: System<D>) -> Result<Self, RunError> {
        let mut all = Self::new(body, system)?;
        (all.outcome, _) = all.unit.solve(all.body.problem(), &all.system, &mut all.timing)?;
        if all.outcome != Outcome::Found {
            all.unit.rest();
        }
        Ok(all)
    }

    /// From a restart: with the inverse that there was, so that all goes on to the last bit
    /// as if it had not stopped.
    pub(super) fn resume(
        body: &'a mut P,
        system: System<D>,
        recorded: usize,
        restart: BreakRestart,
    ) -> Result<Self, RunError> {
        restart.fits(system.size(), body.model().bond_numbers())?;
        let mut all = Self::new(body, system)?;
        all.unit.u.clone_from(&restart.unit);
        if restart.factored > 0 {
            all.remove_again(&restart, 0..restart.factored);
            all.unit.renew(all.body.problem(), &all.system, &mut all.timing)?;
        }
        all.remove_again(&restart, restart.factored..restart.broken.len());
        all.islands.set_frozen(restart.frozen.clone());
        all.unit.resume(&all.system, &restart);
        let last = restart.events.last().copied().unwrap_or_default();
        all.ledger = Ledger::resume(last.work, last.released, last.bond_energy, restart.load_factor);
        (all.events, all.broken, all.factored) = (restart.events, restart.broken, restart.factored);
        (all.recorded, all.step) = (recorded, restart.step);
        Ok(all)
    }

    /// Removes some bonds of a restart as they went, equilibrium by equilibrium: sums of what is left depend on the order to the last bit.
    fn remove_again(&mut self, restart: &BreakRestart, range: Range<usize>) {
        let ends = restart.events.iter().map(|event| event.broken).filter(|end| range.contains(end));
        let mut begin = range.start;
        for end in ends.chain([range.end]).collect::<Vec<_>>() {
            if begin < end {
                self.remove(&restart.broken[begin..end]);
                begin = end;
            }
        }
    }

    /// Removes bonds, and takes out what comes off with them: it bears no loads any more.
    fn remove(&mut self, bonds: &[u64]) -> Removed<D> {
        let gone: Parts<D> = self.body.model().part(bonds).into();
        self.unit.lose(&gone);
        self.system.change_model(self.body.model_mut(), |model| model.break_bonds(bonds));
        let load_factor = self.events.last().map_or(0.0, |e| e.load_factor);
        let u: Vec<f64> = self.unit.u.iter().map(|u| load_factor * u).collect();
        let problem = self.body.problem();
        let state = [&u[..], &self.unit.loads];
        let found = self.islands.find(problem.model(), &mut self.system, problem.equations(), state);
        for &(unknown, _) in self.islands.frozen() {
            self.loads_gone |= std::mem::take(&mut self.unit.loads[unknown as usize]) != 0.0;
        }
        let left = self.body.free_load();
        if found {
            self.body.come_off(self.islands.off());
        }
        let free = if found { self.body.free_load() } else { left.clone() };
        self.unit.set_free(free);
        Removed { gone, came_off: found, left }
    }

    /// Breaks bonds at the load factor of the last equilibrium, and finds the next one at the unit load.
    pub(super) fn break_bonds(&mut self, bonds: &[u64]) -> Result<(), RunError> {
        if bonds.is_empty() {
            return Ok(());
        }
        let (before, ledger, energy) = (self.unit.u.clone(), self.ledger, self.unit.energy);
        let whole = self.unit.free.clone();
        self.broken.extend(bonds);
        let Removed { gone, came_off, left } = self.remove(bonds);
        if came_off {
            let mut forces = vec![0.0; self.system.size()];
            self.system.force(&before, &mut forces);
            gone.iter().for_each(|term| term.add_force(&before, &mut forces));
            if let Some(whole) = &whole {
                forces.iter_mut().zip(&whole.load).for_each(|(all, own)| *all -= own);
            }
            let off = self.islands.frozen().iter().map(|&(unknown, _)| unknown as usize);
            self.ledger.come_off(off.map(|k| (forces[k], before[k])));
        }
        let renewed;
        (self.outcome, renewed) = self.unit.solve(self.body.problem(), &self.system, &mut self.timing)?;
        if renewed {
            self.factored = self.broken.len();
        }
        if self.outcome != Outcome::Found {
            // There is no equilibrium at any load: as if all loads went before the bonds.
            self.unit.rest();
            self.ledger = ledger;
            self.ledger.load(0.0, energy);
            return Ok(());
        }
        let free =
            || Some([whole.as_ref()?.less(left.as_ref()?), whole.as_ref()?.less(self.unit.free.as_ref()?)]);
        self.ledger.lose(&gone, &self.unit.loads, [&before, &self.unit.u], free().as_ref());
        Ok(())
    }

    pub(super) fn restart(&self, load_factor: f64) -> Restart {
        let mut restart = BreakRestart {
            events: self.events.clone(),
            broken: self.broken.clone(),
            factored: self.factored,
            unit: self.unit.u.clone(),
            frozen: self.islands.frozen().to_vec(),
            step: self.step,
            load_factor,
            ..BreakRestart::default()
        };
        self.unit.save(&mut restart);
        Restart::new(self.recorded, RestartFrom::Break(Box::new(restart)))
    }

    /// Certifies the present equilibrium and hands it on.
    pub(super) fn record(
        &mut self,
        load_factor: f64,
        ending: Option<Ending>,
        sink: &mut dyn Sink,
    ) -> Result<(), RunError> {
        let at = (load_factor, ending == Some(Ending::CameOff));
        self.converged &= self.outcome != Outcome::Lost;
        let (load, solution, certificate, renewed) =
            self.unit.certified(self.body.problem(), &self.system, at, &mut self.timing)?;
        if renewed {
            self.factored = self.broken.len();
        }
        self.converged &= certificate.converged;
        let begin = Instant::now();
        let facts = Facts::of(&self.events, self.body.facts(&self.broken));
        let solved = SolvedState { state: self.recorded, load: &load, solution, certificate };
        let name = format!("equilibrium {}", self.events.len() - 1);
        let mut result = self.body.result(solved, name, load_factor, facts, &self.broken);
        // Only now: fields are those of the parts without strain.
        self.islands.place(&mut result.record_mut().u);
        sink.take(result)?;
        self.recorded += 1;
        self.timing.record += begin.elapsed().as_secs_f64();
        Ok(())
    }
}
