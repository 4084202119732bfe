//! A beam as a problem to be solved, with two or three unknowns per point.

use super::soft_motions::SoftMotions;
use crate::case::Solver;
use crate::run::Problem;
use crate::scene::BeamScene;
use peristat_assembly::condition::Equation;
use peristat_assembly::model::Model;
use peristat_assembly::model::timoshenko_beam::TimoshenkoBeam;
use peristat_assembly::stiffness::Spring;
use peristat_assembly::system::{FreeMotion, System};
use peristat_solve::SmoothVectors;

impl<const D: usize> Problem<D> for BeamScene
where
    TimoshenkoBeam: Model<D>,
{
    fn model(&self) -> &dyn Model<D> {
        &self.beam
    }

    fn springs(&self) -> &[Spring] {
        &self.springs
    }

    fn equations(&self) -> &[Equation] {
        &self.equations
    }

    fn solver(&self) -> Solver {
        self.solver
    }

    fn states(&self) -> usize {
        self.states.len()
    }

    fn add_load(&self, state: usize, force: &mut [f64]) -> f64 {
        let state = &self.states[state];
        state.loads.add_to(&self.beam, force);
        state.motion_factor
    }

    fn soft_motions(&self, system: &System<D>) -> Option<Box<dyn SmoothVectors>> {
        Some(Box::new(SoftMotions::new(self, system)?))
    }

    fn describe(&self, motion: &FreeMotion) -> String {
        self.describe_motion(motion)
    }

    fn remedy(&self) -> &'static str {
        self.remedy()
    }
}
