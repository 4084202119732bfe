//! A beam scene as a problem to be solved.

use super::Scene;
use crate::run::Problem;
use peristat_assembly::condition::Equation;
use peristat_assembly::model::Model;
use peristat_assembly::model::timoshenko_beam::TimoshenkoBeam;
use peristat_assembly::stiffness::Spring;
use peristat_assembly::system::FreeMotion;

impl Problem<2> for Scene {
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

    fn states(&self) -> usize {
        self.states.len()
    }

    fn add_load(&self, state: usize, force: &mut [f64]) -> f64 {
        let state = &self.states[state];
        state.loads.add_to(&self.beam, force);
        state.motion_factor
    }

    fn describe(&self, motion: &FreeMotion) -> String {
        let position = |point: usize| self.beam.position(point)[0];
        let parts: Vec<String> =
            motion.parts.iter().map(|&[a, b]| format!("x = {} to {}", position(a), position(b))).collect();
        let amount = |kind: usize| {
            let name = TimoshenkoBeam::RIGID_MOTIONS[kind];
            motion.motions.iter().find(|m| m.0 == name).map_or(0.0, |m| m.1)
        };
        let (shift, turn) = (amount(0), amount(1));
        let how = if turn == 0.0 {
            "move along w".to_string()
        } else {
            let centre = format!("{:.6}", motion.centre[0] - shift / turn);
            format!("rotate about x = {}", centre.trim_end_matches('0').trim_end_matches('.'))
        };
        format!("the beam from {} is free to {how}", parts.join(" and from "))
    }
}
