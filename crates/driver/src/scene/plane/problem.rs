//! A body in the plane as a problem to be solved.

use super::{PlaneScene, levels, motions};
use crate::case::Solver;
use crate::run::{Coarser, Problem, Spread};
use peristat_assembly::body::Crack;
use peristat_assembly::condition::Equation;
use peristat_assembly::model::bond_plane::BondPlane;
use peristat_assembly::stiffness::Spring;
use peristat_assembly::system::FreeMotion;

impl Problem<2> for PlaneScene {
    type Model = BondPlane;

    fn model(&self) -> &BondPlane {
        &self.model
    }

    fn springs(&self) -> &[Spring] {
        &self.conditions.springs
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
        for &(case, factor) in &state.terms {
            self.load_cases[case].add_to(&self.model, factor, force);
        }
        state.motion_factor
    }

    fn spread(&self) -> Spread {
        levels::spread(&self.model)
    }

    fn positions(&self) -> Option<Vec<[f64; 2]>> {
        Some((0..self.model.points()).map(|point| self.model.place(point)).collect())
    }

    fn coarser(&self) -> Option<Coarser<2>> {
        let cracks: Vec<Crack> = self.cracks.iter().map(|c| c.crack.clone()).collect();
        levels::coarser(&self.model, &cracks, &self.conditions)
    }

    fn describe(&self, motion: &FreeMotion) -> String {
        motions::describe(self, motion)
    }

    fn remedy(&self) -> &'static str {
        "a body in the plane needs `ux` and `uy` held on one place and one of them on another, in every part that cracks leave"
    }
}
