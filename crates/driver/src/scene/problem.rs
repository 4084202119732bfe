//! A scene as a problem to be solved, with two or three unknowns per point.

use super::{Scene, motions};
use crate::case::Solver;
use crate::run::{Problem, StrainProblem};
use peristat_assembly::condition::Equation;
use peristat_assembly::model::timoshenko_beam::{TimoshenkoBeam, U};
use peristat_assembly::stiffness::{ObliqueSpring, Spring};
use peristat_assembly::system::FreeMotion;

/// Implements [`Problem`] for a number of unknowns per point; nothing but the model's reading of them differs.
macro_rules! problem {
    ($d:literal) => {
        impl Problem<$d> for Scene {
            type Model = TimoshenkoBeam;

            fn model(&self) -> &TimoshenkoBeam {
                &self.beam
            }

            fn springs(&self) -> &[Spring] {
                &self.springs
            }

            fn oblique_springs(&self) -> &[ObliqueSpring] {
                &self.oblique_springs
            }

            fn equations(&self) -> &[Equation] {
                &self.equations
            }

            fn idle(&self) -> usize {
                // Displacements along a bar between its ends.
                let bars = self.beam.chains().iter().filter(|c| $d > U && c.stretches_as_bar());
                bars.map(|c| c.points.saturating_sub(2)).sum()
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

            fn strain_problem(&self) -> Option<StrainProblem<'_>> {
                let states = self.states.iter().map(|state| (&state.loads, state.motion_factor));
                (!self.has_axial).then(|| StrainProblem { beam: &self.beam, states: states.collect() })
            }

            fn describe(&self, motion: &FreeMotion) -> String {
                motions::describe(self, motion)
            }

            fn remedy(&self) -> &'static str {
                motions::remedy(self)
            }
        }
    };
}

problem!(2);
problem!(3);
