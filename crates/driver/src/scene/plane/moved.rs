//! A body in the plane with the tips of a crack moved, as a problem of its own: points, conditions and loads are those of
//! the body.

use super::{PlaneScene, levels};
use crate::case::Solver;
use crate::run::{Coarser, Problem, Spread};
use peristat_assembly::body::Crack;
use peristat_assembly::condition::Equation;
use peristat_assembly::model::bond_plane::BondPlane;
use peristat_assembly::stiffness::Spring;
use peristat_assembly::system::FreeMotion;

/// A scene with another model of its body.
#[derive(Debug)]
pub struct MovedTips<'a> {
    pub(super) scene: &'a PlaneScene,
    pub(super) model: BondPlane,
    pub(super) cracks: Vec<Crack>,
}

impl Problem<2> for MovedTips<'_> {
    type Model = BondPlane;

    fn model(&self) -> &BondPlane {
        &self.model
    }

    fn springs(&self) -> &[Spring] {
        &self.scene.conditions.springs
    }

    fn equations(&self) -> &[Equation] {
        &self.scene.equations
    }

    fn solver(&self) -> Solver {
        self.scene.solver
    }

    fn states(&self) -> usize {
        self.scene.states.len()
    }

    fn add_load(&self, state: usize, force: &mut [f64]) -> f64 {
        let state = &self.scene.states[state];
        for &(case, factor) in &state.terms {
            self.scene.load_cases[case].add_to(&self.model, factor, force);
        }
        state.motion_factor
    }

    fn spread(&self) -> Spread {
        levels::spread(&self.model)
    }

    fn positions(&self) -> Option<Vec<[f64; 2]>> {
        self.scene.positions()
    }

    fn coarser(&self) -> Option<Coarser<2>> {
        levels::coarser(&self.model, &self.cracks, &self.scene.conditions)
    }

    fn describe(&self, motion: &FreeMotion) -> String {
        format!("with the tip moved by a spacing {}", self.scene.describe(motion))
    }

    fn remedy(&self) -> &'static str {
        "a stress intensity needs a ligament of several spacings before the tip"
    }
}
