//! What a run needs of a body that breaks, whatever its model.

use super::super::{Problem, SolvedState, StateResult};
use super::{Event, FreeLoad};
use crate::case::FRACTURE_FACTS;
use crate::scene::fracture::FractureScene;
use peristat_assembly::model::Breakable;

/// A body that breaks.
pub(in super::super) trait BreakingBody<const D: usize> {
    /// Its model.
    type Model: Breakable<D> + ?Sized;

    /// The model.
    fn model(&self) -> &Self::Model;

    /// The problem. Its one state has the loads and motions at a load factor of one.
    fn problem(&self) -> &dyn Problem<D>;

    /// How it breaks.
    fn fracture(&self) -> &FractureScene<<Self::Model as Breakable<D>>::Critical>;

    /// The model, to break its bonds.
    fn model_mut(&mut self) -> &mut Self::Model;

    /// What strains that need no stress do to the body as it is, at the unit load; none where there are none.
    fn free_load(&self) -> Option<FreeLoad> {
        None
    }

    /// Points have come off, by their numbers: nothing strains them any more.
    fn come_off(&mut self, _off: &[bool]) {}

    /// The load, from unknowns and from the forces that hold the equations.
    fn load(&self, u: &[f64], multipliers: &[f64]) -> f64;

    /// Whether the load is a force, not a displacement.
    fn load_is_force(&self) -> bool;

    /// What is reported of the broken bonds beside their number, by name.
    fn facts(&self, broken: &[u64]) -> Vec<(String, f64)>;

    /// Doubts about these, in words.
    fn doubts(&self, _broken: &[u64]) -> Vec<String> {
        Vec::new()
    }

    /// The result of an equilibrium at a load factor, with the bonds that have broken before.
    fn result(
        &mut self,
        solved: SolvedState,
        name: String,
        load_factor: f64,
        facts: Facts,
        broken: &[u64],
    ) -> StateResult;
}

/// What is known of a body that breaks at one of its equilibria, by name: what checks can ask for.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Facts(pub Vec<(String, f64)>);

impl Facts {
    /// Those of the equilibria so far, the last of which is the one at hand.
    pub(super) fn of(events: &[Event], more: Vec<(String, f64)>) -> Self {
        let place = |event: &Event| [event.load_factor, event.load];
        let first = events.iter().find(|e| e.broken_now > 0).map(place);
        let peak = events.iter().max_by(|a, b| a.load.abs().total_cmp(&b.load.abs())).map(place);
        let last = events.last().copied().unwrap_or_default();
        let values = [
            first.map(|f| f[0]),
            first.map(|f| f[1]),
            peak.map(|p| p[0]),
            peak.map(|p| p[1]),
            Some(last.load_factor),
            Some(last.broken as f64),
            Some(last.island_points as f64),
        ];
        // Where nothing breaks there is no first break.
        let named =
            FRACTURE_FACTS.iter().zip(values).filter_map(|(name, value)| Some((name.to_string(), value?)));
        Self(named.chain(more).collect())
    }

    /// Value of a fact.
    pub fn value(&self, name: &str) -> Option<f64> {
        self.0.iter().find(|f| f.0 == name).map(|f| f.1)
    }
}
