//! A beam scene as a problem to be solved.

use super::Scene;
use super::place::tidy;
use crate::case::Solver;
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

    fn describe(&self, motion: &FreeMotion) -> String {
        // A part is a line, with the ghost points beyond its ends.
        let line = |point: usize| self.beam.chains()[self.beam.chain_of(point)].line();
        let parts: Vec<String> = motion
            .parts
            .iter()
            .map(|&[first, last]| {
                let (first, last) = (line(first), line(last));
                format!("x = {} to {}", tidy(first.from), tidy(last.from + last.length))
            })
            .collect();
        let amount = |kind: usize| {
            let name = <TimoshenkoBeam as Model<2>>::RIGID_MOTIONS[kind];
            motion.motions.iter().find(|m| m.0 == name).map_or(0.0, |m| m.1)
        };
        let (shift, turn) = (amount(0), amount(1));
        let how = if turn == 0.0 {
            "move along w".to_string()
        } else {
            format!("rotate about x = {}", tidy(motion.centre[0] - shift / turn))
        };
        format!("the beam from {} is free to {how}", parts.join(" and from "))
    }
}
