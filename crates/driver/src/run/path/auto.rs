//! The control that a scene asks for, and what takes over where it gets stuck.

use super::super::RunError;
use super::control::{Control, Goal, Load, Step};
use super::course::Course;
use super::displacement::Displacement;
use super::dissipation::Dissipation;
use super::event::Events;
use super::kept::Memory;
use crate::case::PathControl;
use crate::scene::path::PathScene;
use peristat_assembly::stiffness::Kinematics;

/// A control that can be changed.
pub(super) struct Chosen<const D: usize> {
    control: Box<dyn Control<D>>,
    /// What drives the body now.
    pub(super) name: PathControl,
    /// Why.
    pub(super) reason: String,
    /// Whether the case leaves the choice.
    is_auto: bool,
}

impl<const D: usize> Chosen<D> {
    pub(super) fn new(scene: &PathScene, course: &Course<D>) -> Self {
        let (name, reason) = scene.chosen();
        Self { control: make(name, scene, course), name, reason, is_auto: scene.control == PathControl::Auto }
    }

    /// Goes on as another run did.
    ///
    /// # Errors
    /// Its memory is of another kind, or a matrix has no factor.
    pub(super) fn resume(
        scene: &PathScene,
        course: &mut Course<D>,
        (name, reason): (PathControl, String),
        memory: Memory,
    ) -> Result<Self, RunError> {
        let mut control = make(name, scene, course);
        control.recall(course, memory)?;
        Ok(Self { control, name, reason, is_auto: scene.control == PathControl::Auto })
    }

    /// What the control remembers.
    pub(super) fn memory(&self, course: &Course<D>) -> Memory {
        self.control.memory(course)
    }

    /// A next state; where there is none, another control is tried.
    pub(super) fn step(
        &mut self,
        scene: &PathScene,
        course: &mut Course<D>,
        goal: Goal,
        load: Load<D>,
    ) -> Result<Step<D>, RunError> {
        let step = self.control.step(course, goal, load)?;
        if !matches!(step, Step::Stuck) || !self.is_auto || self.name != PathControl::Displacement {
            return Ok(step);
        }
        self.name = match scene.kinematics {
            Kinematics::Linear => PathControl::Event,
            Kinematics::Finite => PathControl::Dissipation,
        };
        self.reason +=
            &format!("; at the load factor {} steps found no equilibrium", course.state.load_factor);
        self.control = make(self.name, scene, course);
        self.control.committed(course, false);
        self.control.step(course, goal, load)
    }

    pub(super) fn committed(&mut self, course: &mut Course<D>, turns: bool) {
        self.control.committed(course, turns);
    }
}

fn make<const D: usize>(name: PathControl, scene: &PathScene, course: &Course<D>) -> Box<dyn Control<D>> {
    match name {
        PathControl::Auto | PathControl::Displacement => Box::new(Displacement::new(scene.increment)),
        PathControl::Event => Box::new(Events::new(course, scene.increment)),
        PathControl::Dissipation => {
            Box::new(Dissipation::new(course, scene.increment, scene.energy_increment))
        }
    }
}
