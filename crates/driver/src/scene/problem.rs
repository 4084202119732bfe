//! A scene as a problem to be solved, with two or three unknowns per point.

use super::{Scene, motions};
use crate::case::Solver;
use crate::run::{Problem, StrainProblem};
use peristat_assembly::condition::Equation;
use peristat_assembly::model::Model;
use peristat_assembly::model::timoshenko_beam::{StrainForm, TimoshenkoBeam};
use peristat_assembly::stiffness::Spring;
use peristat_assembly::system::FreeMotion;

impl<const D: usize> Problem<D> for Scene
where
    TimoshenkoBeam: Model<D>,
{
    type Model = TimoshenkoBeam;

    fn model(&self) -> &TimoshenkoBeam {
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

    fn strain_problem(&self) -> Result<StrainProblem<'_>, String> {
        if self.has_axial {
            return Err("it is for beams with the unknowns w and phi".into());
        }
        if !self.bedding.is_empty() {
            return Err("the beam lies on an elastic foundation".into());
        }
        let form = StrainForm::new(&self.beam).map_err(|reason| reason.to_string())?;
        let states = self.states.iter().map(|state| (&state.loads, state.motion_factor)).collect();
        Ok(StrainProblem { beam: &self.beam, form, states })
    }

    fn describe(&self, motion: &FreeMotion) -> String {
        motions::describe(self, motion)
    }

    fn remedy(&self) -> &'static str {
        motions::remedy(self)
    }
}
