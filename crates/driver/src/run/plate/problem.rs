//! A plate as a problem to be solved.

use super::levels;
use crate::case::Solver;
use crate::run::{Coarser, Problem, Spread};
use crate::scene::PlateScene;
use peristat_assembly::condition::Equation;
use peristat_assembly::model::Model;
use peristat_assembly::stiffness::Spring;
use peristat_assembly::system::{FreeMotion, System};

/// Points up to which a factor is taken: it leaves thirteen digits, where cycles leave nine.
const MOST_FACTORED: usize = 60_000;

impl Problem<3> for PlateScene {
    fn model(&self) -> &dyn Model<3> {
        &self.plate
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

    fn breaks(&self) -> bool {
        self.fracture.is_some()
    }

    fn add_load(&self, state: usize, force: &mut [f64]) -> f64 {
        let state = &self.states[state];
        for &(case, factor) in &state.terms {
            let loads = &self.load_cases[case].force;
            force.iter_mut().zip(loads).for_each(|(sum, load)| *sum += factor * load);
        }
        force.iter_mut().zip(self.heat(state).forces()).for_each(|(sum, load)| *sum += load);
        state.motion_factor
    }

    fn motions(&self, state: usize) -> Option<Vec<f64>> {
        if self.by_step.iter().all(Vec::is_empty) {
            return None;
        }
        let factor = self.states[state].load_factor;
        let of = |(equation, by_step): (&Equation, &Vec<f64>)| match by_step.get(state) {
            Some(value) => *value,
            None => factor * equation.value,
        };
        Some(self.equations.iter().zip(&self.by_step).map(of).collect())
    }

    fn spread(&self) -> Spread {
        let nodes = self.plate.nodes();
        let is_factored = self.solver == Solver::Auto && nodes.points() <= MOST_FACTORED;
        match is_factored || levels::is_coarsest(nodes) {
            true => Spread::Plane,
            false => Spread::Lattice,
        }
    }

    fn coarsest_points(&self) -> usize {
        levels::coarsest_points(self.plate.nodes())
    }

    fn coarser(&self, _system: &System<3>) -> Option<Coarser<3>> {
        levels::coarser(self)
    }

    fn positions(&self) -> Option<Vec<[f64; 2]>> {
        let nodes = self.plate.nodes();
        Some((0..nodes.points()).map(|point| nodes.place(point)).collect())
    }

    fn describe(&self, motion: &FreeMotion) -> String {
        PlateScene::describe(self, motion)
    }

    fn remedy(&self) -> &'static str {
        "a plate in bending needs `w` held at three points that are not in a line, or `w` and a rotation along an edge"
    }
}
