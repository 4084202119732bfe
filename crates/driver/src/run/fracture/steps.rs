//! From equilibrium to equilibrium.

use super::super::restart::{Restart, RestartFrom};
use super::super::{Advance, RunError, RunReport, Sink, Sizes};
use super::Event;
use super::breaking::Breaking;
use super::choice::Next;
use super::ending::Ending;
use super::problem::BreakingBody;
use peristat_assembly::system::System;

/// Work of the load over that of all loads and motions, below which it is rounding.
const ROUNDING: f64 = 1e-9;

/// Breaks the bonds of a prepared problem, and hands equilibria on.
///
/// # Errors
/// [`RunError`]: the stiffness has no factor, a result cannot be taken.
pub(in super::super) fn run<const D: usize, P: BreakingBody<D>>(
    body: &mut P,
    (system, sizes): (System<D>, Sizes),
    resume: Option<Restart>,
    sink: &mut dyn Sink,
) -> Result<RunReport, RunError> {
    let mut breaking = match resume {
        Some(Restart { recorded, from: RestartFrom::Break(restart), .. }) => {
            Breaking::resume(body, system, recorded, *restart)?
        }
        Some(_) => return Err(RunError::Misfit),
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

impl<const D: usize, P: BreakingBody<D>> Breaking<'_, D, P> {
    /// Goes to an equilibrium, tells of it, and says whether the run ends there.
    pub(super) fn reach(&mut self, next: &Next, sink: &mut dyn Sink) -> Result<Option<Ending>, RunError> {
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
            island_points: self.islands.points(),
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
        if self.events.is_empty() && self.body.load_is_force() {
            let largest = |of: &[f64]| of.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
            // Heat works where nothing moves.
            self.is_rounding = match &self.unit.free {
                Some(free) => event.load.abs() < ROUNDING * next.load_factor * largest(&free.load),
                None => event.work > 0.0 && event.load.abs() * largest(&u) < ROUNDING * event.work,
            };
        }
        self.events.push(event);
        let ending = self.ending(&event);
        let is_first = self.events.iter().filter(|e| e.broken_now > 0).count() == 1 && event.broken_now > 0;
        if is_first || ending.is_some() || event.solve.is_multiple_of(self.body.fracture().record_every) {
            self.record(next.load_factor, ending, sink)?;
        }
        let restart = || self.restart(next.load_factor);
        sink.advance(Advance::Break(&event), ending.is_none().then_some(&restart))?;
        // Until the next solve.
        self.unit.iterations = 0;
        match ending {
            None if sink.is_interrupted() => Ok(Some(Ending::Interrupted)),
            ending => Ok(ending),
        }
    }
}
