//! Control of the load factor: prescribed motions and loads grow step by step.

use super::super::RunError;
use super::body::State;
use super::control::{Control, Goal, Load, Step};
use super::course::Course;
use super::kept::{Memory, Steps};
use super::newton::Effort;
use super::point::Cost;

/// The smallest step over the largest one.
const LEAST: f64 = 1.0 / 64.0;
/// How near to a load a path has to come to turn there, over the largest load.
const AT_LOAD: f64 = 1e-9;
/// Tries to meet a load.
const MOST_TRIES: usize = 30;

/// Steps of the load factor, halved where there is no equilibrium to be found and doubled again after.
pub(super) struct Displacement<const D: usize> {
    /// Largest step.
    increment: f64,
    step: f64,
    /// Unknowns per load factor along the last step.
    last: Option<Vec<f64>>,
    /// Unknowns and load factor of the last committed state.
    before: Option<(Vec<f64>, f64)>,
}

impl<const D: usize> Displacement<D> {
    pub(super) fn new(increment: f64) -> Self {
        Self { increment, step: increment, last: None, before: None }
    }

    /// What it remembers.
    pub(super) fn steps(&self) -> Steps {
        Steps { step: self.step, last: self.last.clone(), before: self.before.clone() }
    }

    /// Remembers what another one did.
    pub(super) fn recall_steps(&mut self, steps: Steps) {
        Steps { step: self.step, last: self.last, before: self.before } = steps;
    }

    /// Makes the next step half as long; whether that is one.
    pub(super) fn shorten(&mut self) -> bool {
        let shorter = 0.5 * self.step;
        let is_one = shorter >= LEAST * self.increment;
        self.step = if is_one { shorter } else { self.increment };
        is_one
    }

    /// Unknowns per load factor along the last step.
    pub(super) fn direction(&self, course: &Course<D>) -> Vec<f64> {
        self.last.as_ref().unwrap_or(&course.elastic).clone()
    }

    /// The state at a load factor, and whether it is in equilibrium.
    fn try_at(
        &self,
        course: &mut Course<D>,
        load_factor: f64,
        effort: &mut Effort,
    ) -> Result<Option<State<D>>, RunError> {
        let grown = load_factor - course.state.load_factor;
        let direction = self.last.as_ref().unwrap_or(&course.elastic);
        let mut state = course.state.clone();
        state.u.iter_mut().zip(direction).for_each(|(u, d)| *u += grown * d);
        course.hold_islands(&mut state.u);
        state.load_factor = load_factor;
        let found = course.body.equilibrate(&mut state, course.reference, effort)?;
        Ok(found.then_some(state))
    }

    /// The state between the committed one and another at which the load has a value that lies between those of both.
    fn meet(
        &self,
        course: &mut Course<D>,
        (target, load): (f64, Load<D>),
        beyond: State<D>,
        effort: &mut Effort,
    ) -> Result<Option<State<D>>, RunError> {
        let near = AT_LOAD * course.points.iter().map(|p| p.load.abs()).fold(target.abs(), f64::max);
        let mut ends = [
            (course.state.load_factor, load(course, &course.state) - target),
            (beyond.load_factor, load(course, &beyond) - target),
        ];
        let mut found = beyond;
        for _ in 0..MOST_TRIES {
            if (load(course, &found) - target).abs() <= near {
                return Ok(Some(found));
            }
            let [(a, at_a), (b, at_b)] = ends;
            let between = a + (b - a) * (at_a / (at_a - at_b)).clamp(0.01, 0.99);
            let Some(next) = self.try_at(course, between, effort)? else { return Ok(None) };
            let lack = load(course, &next) - target;
            ends[usize::from((lack < 0.0) == (at_b < 0.0))] = (between, lack);
            found = next;
        }
        Ok(Some(found))
    }
}

impl<const D: usize> Control<D> for Displacement<D> {
    fn step(&mut self, course: &mut Course<D>, goal: Goal, load: Load<D>) -> Result<Step<D>, RunError> {
        let from = course.state.load_factor;
        let (end, target) = match goal {
            Goal::LoadFactor(end) => (end, None),
            Goal::Load(target) => (course.farthest_back(), Some(target)),
        };
        let mut cost = Cost::default();
        loop {
            let left = end - from;
            // A last step that is next to nothing is part of the one before.
            let is_last = left.abs() <= self.step * (1.0 + 1e-9);
            let to = if is_last { end } else { from + self.step * left.signum() };
            if let Some(state) = self.try_at(course, to, &mut cost.effort)? {
                let Some(target) = target else { return Ok(Step::To(state, cost, is_last)) };
                let signs = [load(course, &course.state), load(course, &state)].map(|p| p > target);
                if signs[0] == signs[1] {
                    return Ok(if is_last { Step::Stuck } else { Step::To(state, cost, false) });
                }
                if let Some(state) = self.meet(course, (target, load), state, &mut cost.effort)? {
                    return Ok(Step::To(state, cost, true));
                }
            }
            cost.refused += 1;
            self.step *= 0.5;
            if self.step < LEAST * self.increment {
                self.step = self.increment;
                return Ok(Step::Stuck);
            }
        }
    }

    fn committed(&mut self, course: &mut Course<D>, turns: bool) {
        self.step = (2.0 * self.step).min(self.increment);
        let here = (course.state.u.clone(), course.state.load_factor);
        let before = self.before.replace(here);
        let elastic = turns || before.is_none();
        self.last = before.filter(|_| !elastic).map(|(u, load_factor)| {
            let grown = course.state.load_factor - load_factor;
            course.state.u.iter().zip(&u).map(|(now, before)| (now - before) / grown).collect()
        });
    }

    fn memory(&self, _course: &Course<D>) -> Memory {
        Memory::Displacement(self.steps())
    }

    fn recall(&mut self, _course: &mut Course<D>, memory: Memory) -> Result<(), RunError> {
        let Memory::Displacement(steps) = memory else { return Err(RunError::Misfit) };
        self.recall_steps(steps);
        Ok(())
    }
}
