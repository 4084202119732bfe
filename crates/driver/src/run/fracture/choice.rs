//! Which bonds break next, and at which load.
//!
//! Between two breaks the body is linear in the load factor λ, so every equilibrium is known from the displacements `u₁`
//! at the unit load: a bond breaks at `λ = 1/ratio` of its strain there. `worst` goes to that of the worst bond, wherever
//! it is: the load may snap back. The others raise λ step by step and break what is overstrained until nothing is.

use super::Event;
use super::breaking::Breaking;
use super::problem::BreakingBody;
use super::unit::Outcome;
use crate::case::Strategy;
use peristat_assembly::model::Breakable;

/// How far beyond its critical load the first bond is taken, so that rounding does not keep it.
const BEYOND: f64 = 1e-7;
/// Strain energy at the unit load over that of the intact body, below which nothing is strained any more.
const NOTHING: f64 = 1e-12;
/// Rounding of a ratio times the load factor that is its inverse.
const ROUNDING: f64 = 1e-12;

/// What goes on at an equilibrium.
pub(super) struct Next {
    pub(super) load_factor: f64,
    /// Bonds that break there.
    pub(super) breaking: Vec<u64>,
}

impl<const D: usize, P: BreakingBody<D>> Breaking<'_, D, P> {
    /// Whether a bond can break.
    fn may_break(&self, bond: u64) -> bool {
        let ends = self.body.model().ends(bond);
        !ends.iter().any(|&p| self.body.fracture().exempt[p]) && !self.islands.holds(ends)
    }

    /// Calls `visit` with every bond and the ratio of its strain at the unit load to its critical one.
    fn for_each_ratio(&self, visit: &mut dyn FnMut(u64, f64)) {
        self.body.model().for_each_ratio(&self.unit.u, &self.body.fracture().critical, visit);
    }

    /// The largest of these ratios of a bond that can break.
    pub(super) fn worst(&self) -> f64 {
        let mut worst = 0.0;
        self.for_each_ratio(&mut |bond, ratio| {
            if ratio > worst && self.may_break(bond) {
                worst = ratio;
            }
        });
        worst
    }

    /// What happens at a load factor, `worst` being the largest ratio.
    pub(super) fn at(&self, load_factor: f64, worst: f64) -> Next {
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
    pub(super) fn is_slack(&self) -> bool {
        let strained = |first: &Event| first.stored / (first.load_factor * first.load_factor);
        let intact = self.events.first().map_or(0.0, strained);
        !self.broken.is_empty() && self.unit.energy.stored <= NOTHING * intact
    }

    /// The next equilibrium: at the load factor that the worst bond bears, or that of the step.
    pub(super) fn next(&mut self) -> Next {
        if self.outcome != Outcome::Found {
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
}
