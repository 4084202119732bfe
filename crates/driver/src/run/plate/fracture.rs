//! Plates in bending that break.

use super::fields::{self, Equilibrium};
use super::verdict;
use crate::case::Solver;
use crate::run::fracture::{BreakingBody, Facts};
use crate::run::{Problem, SolvedState, Spread, StateResult};
use crate::scene::PlateScene;
use crate::scene::plate::{PlateFracture, PlateQuantity};
use peristat_assembly::condition::Equation;
use peristat_assembly::model::Model;
use peristat_assembly::model::plate_bending::PlateBending;
use peristat_assembly::stiffness::Spring;
use peristat_assembly::system::FreeMotion;

/// A scene with a plate some of whose bonds are broken.
struct BrokenPlate<'a> {
    scene: &'a PlateScene,
    plate: PlateBending,
}

/// A plate whose bonds break.
pub(super) struct BreakingPlate<'a> {
    problem: BrokenPlate<'a>,
    fracture: &'a PlateFracture,
    recover: bool,
}

impl<'a> BreakingPlate<'a> {
    /// The whole plate of a scene.
    pub(super) fn new(scene: &'a PlateScene, fracture: &'a PlateFracture, recover: bool) -> Self {
        Self { problem: BrokenPlate { scene, plate: scene.plate.clone() }, fracture, recover }
    }
}

impl Problem<3> for BrokenPlate<'_> {
    fn model(&self) -> &dyn Model<3> {
        &self.plate
    }

    fn springs(&self) -> &[Spring] {
        &self.scene.springs
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
        self.scene.add_load(state, force)
    }

    fn breaks(&self) -> bool {
        true
    }

    fn spread(&self) -> Spread {
        Spread::Plane
    }

    fn positions(&self) -> Option<Vec<[f64; 2]>> {
        self.scene.positions()
    }

    fn describe(&self, motion: &FreeMotion) -> String {
        Problem::<3>::describe(self.scene, motion)
    }

    fn remedy(&self) -> &'static str {
        self.scene.remedy()
    }
}

impl BreakingBody<3> for BreakingPlate<'_> {
    type Model = PlateBending;

    fn model(&self) -> &PlateBending {
        &self.problem.plate
    }

    fn problem(&self) -> &dyn Problem<3> {
        &self.problem
    }

    fn fracture(&self) -> &PlateFracture {
        self.fracture
    }

    fn model_mut(&mut self) -> &mut PlateBending {
        &mut self.problem.plate
    }

    fn load(&self, u: &[f64], multipliers: &[f64]) -> f64 {
        let scene = self.problem.scene;
        let probe = &scene.probes[self.fracture.load];
        verdict::mechanical(scene, probe, u, multipliers).unwrap_or(0.0)
    }

    fn load_is_force(&self) -> bool {
        let probe = &self.problem.scene.probes[self.fracture.load];
        matches!(probe.quantity, PlateQuantity::Reaction { .. })
    }

    fn facts(&self, _broken: &[u64]) -> Vec<(String, f64)> {
        Vec::new()
    }

    fn result(
        &mut self,
        solved: SolvedState,
        name: String,
        load_factor: f64,
        facts: Facts,
        _broken: &[u64],
    ) -> StateResult {
        let BrokenPlate { scene, plate } = &self.problem;
        let equilibrium = Equilibrium { name, load_factor, facts: Some(facts) };
        StateResult::Plate(fields::of_plate((scene, plate), solved, equilibrium, self.recover))
    }
}
