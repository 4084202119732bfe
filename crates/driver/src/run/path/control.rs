//! What drives a body along its path.

use super::super::RunError;
use super::body::State;
use super::course::Course;
use super::kept::Memory;
use super::point::Cost;
pub(super) use crate::scene::path::Goal;

/// What a step has come to.
pub(super) enum Step<const D: usize> {
    /// A state in equilibrium, what it took, and whether it is at the goal.
    To(State<D>, Cost, bool),
    /// There is no way on.
    Stuck,
}

/// Value of the load in a state.
pub(super) type Load<'a, const D: usize> = &'a dyn Fn(&Course<D>, &State<D>) -> f64;

/// A way to get from one state in equilibrium to the next.
pub(super) trait Control<const D: usize> {
    /// A next state towards a goal; nothing is committed.
    ///
    /// # Errors
    /// A matrix is not finite, or there is no memory.
    fn step(&mut self, course: &mut Course<D>, goal: Goal, load: Load<D>) -> Result<Step<D>, RunError>;

    /// The state of the last step was committed, or the path turns.
    fn committed(&mut self, _course: &mut Course<D>, _turns: bool) {}

    /// What it remembers between two steps.
    fn memory(&self, course: &Course<D>) -> Memory;

    /// Remembers what another of its kind did.
    ///
    /// # Errors
    /// The memory is of another kind, or a matrix has no factor.
    fn recall(&mut self, course: &mut Course<D>, memory: Memory) -> Result<(), RunError>;
}
