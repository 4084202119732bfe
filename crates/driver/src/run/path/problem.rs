//! What a run needs of a body that softens, whatever its model.

use super::super::fracture::Facts;
use super::super::{Problem, SolvedState, StateResult};
use super::body::SofteningBonds;
use super::point::PathPoint;
use crate::scene::path::PathScene;
use peristat_assembly::stiffness::BondAnswers;

/// A body of bonds with memory.
pub(in super::super) trait SofteningBody<const D: usize> {
    /// The problem. Its one state has the loads and motions at a load factor of one.
    fn problem(&self) -> &dyn Problem<D>;

    /// How its path is followed.
    fn path(&self) -> &PathScene;

    /// Its bonds, virgin.
    fn bonds(&self) -> SofteningBonds<D>;

    /// Values of all probes that are known from unknowns and forces that hold the equations, in their order; others are NaN.
    fn probes(&self, u: &[f64], multipliers: &[f64]) -> Vec<f64>;

    /// Tells load and work of the elastic body at a load factor of one.
    fn set_elastic(&mut self, load: f64, work: f64);

    /// Fills in what follows from the load, the work and the damage: the length of the crack, and its measures.
    fn measure(&self, bonds: &SofteningBonds<D>, point: &mut PathPoint);

    /// The result of a state in equilibrium.
    fn result(
        &mut self,
        solved: SolvedState,
        name: String,
        load_factor: f64,
        facts: Facts,
        bonds: (&SofteningBonds<D>, &BondAnswers<D>),
    ) -> StateResult;
}
