//! Beams that break.

use super::{collect, reaction};
use crate::case::{FieldName, Solver};
use crate::run::fracture::{BreakingBody, Facts};
use crate::run::{Problem, SolvedState, StateResult};
use crate::scene::beam::{BeamScene, State};
use crate::scene::fracture::FractureScene;
use peristat_assembly::condition::Equation;
use peristat_assembly::model::timoshenko_beam::{CriticalStrains, PHI, TimoshenkoBeam, U, W};
use peristat_assembly::model::{Breakable, Model};
use peristat_assembly::stiffness::Spring;
use peristat_assembly::system::FreeMotion;

/// A scene with a beam some of whose bonds are broken.
struct BrokenBeam<'a> {
    scene: &'a BeamScene,
    beam: TimoshenkoBeam,
}

/// A beam whose bonds break.
pub(super) struct BreakingBeam<'a> {
    problem: BrokenBeam<'a>,
    fracture: &'a FractureScene<CriticalStrains>,
    recover: bool,
}

impl<'a> BreakingBeam<'a> {
    /// The whole beam of a scene.
    pub(super) fn new(
        scene: &'a BeamScene,
        fracture: &'a FractureScene<CriticalStrains>,
        recover: bool,
    ) -> Self {
        Self { problem: BrokenBeam { scene, beam: scene.beam.clone() }, fracture, recover }
    }
}

impl<const D: usize> Problem<D> for BrokenBeam<'_>
where
    TimoshenkoBeam: Model<D>,
{
    fn model(&self) -> &dyn Model<D> {
        &self.beam
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
        Problem::<D>::add_load(self.scene, state, force)
    }

    fn describe(&self, motion: &FreeMotion) -> String {
        Problem::<D>::describe(self.scene, motion)
    }

    fn remedy(&self) -> &'static str {
        Problem::<D>::remedy(self.scene)
    }
}

impl<const D: usize> BreakingBody<D> for BreakingBeam<'_>
where
    TimoshenkoBeam: Breakable<D, Critical = CriticalStrains>,
{
    type Model = TimoshenkoBeam;

    fn model(&self) -> &TimoshenkoBeam {
        &self.problem.beam
    }

    fn problem(&self) -> &dyn Problem<D> {
        &self.problem
    }

    fn fracture(&self) -> &FractureScene<CriticalStrains> {
        self.fracture
    }

    fn model_mut(&mut self) -> &mut TimoshenkoBeam {
        &mut self.problem.beam
    }

    fn load(&self, u: &[f64], multipliers: &[f64]) -> f64 {
        let scene = self.problem.scene;
        let (probe, n) = (&scene.probes[self.fracture.load], scene.beam.points());
        // Others are refused.
        let Some(point) = probe.point().map(|p| p.point) else { return 0.0 };
        let unknown = |component: usize| u.get(component * n + point).copied().unwrap_or(0.0);
        let held = || {
            reaction::forces(scene, multipliers, &scene.springs, u).into_iter().filter(|h| h.point == point)
        };
        match probe.field {
            FieldName::W => unknown(W),
            FieldName::Phi => unknown(PHI),
            FieldName::U => unknown(U),
            FieldName::ReactionX => held().map(|h| h.force[0]).sum(),
            FieldName::ReactionForce => held().map(|h| h.force[1]).sum(),
            FieldName::ReactionMoment => held().map(|h| h.moment).sum(),
            // The others are recovered or of frames, and refused.
            _ => 0.0,
        }
    }

    fn load_is_force(&self) -> bool {
        // A moment works with a rotation, which is no smaller than a deflection of a beam longer than its height.
        !matches!(
            self.problem.scene.probes[self.fracture.load].field,
            FieldName::W | FieldName::Phi | FieldName::U
        )
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
        let BrokenBeam { scene, beam } = &self.problem;
        let loads = scene.states[0].loads.scaled(load_factor);
        let state = State { name, load_factor, motion_factor: load_factor, loads, eigenstrains: Vec::new() };
        let mut result = collect::of_beam(scene, (beam, &scene.springs), &state, solved, self.recover);
        result.record.facts = Some(facts);
        StateResult::Beam(result)
    }
}
