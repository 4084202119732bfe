//! How displacements are corrected.

use super::certificate::Certificate;
use super::linear::LinearSolver;
use super::problem::Problem;
use super::report::Timing;
use super::workspace::StateSolution;
use peristat_assembly::system::System;
use serde::{Deserialize, Serialize};
use std::time::Instant;

/// The corrections of a state.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Corrections {
    /// The largest displacement of each one that was taken over the largest of all.
    pub sizes: Vec<f64>,
    /// Whether a further one had more than half of the one before it, in energy norm, and was not taken.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub stalled: bool,
}

/// Corrects the solutions of states that converged, where the problem has corrections: all as often as the one that stalls first, so that
/// a combination of load cases is the sum of these.
pub(super) fn correct<const D: usize>(
    problem: &dyn Problem<D>,
    system: &System<D>,
    solver: &mut LinearSolver<D>,
    states: &mut [(usize, StateSolution, Certificate)],
    timing: &mut Timing,
) {
    let begin = Instant::now();
    let mut of = |state: usize, u: &[f64], most: usize| {
        problem.corrected(state, (u, most), &mut |load| solver.correction(system, load))
    };
    let mut found: Vec<Option<(Vec<f64>, Corrections)>> = Vec::new();
    for (state, solution, certificate) in &*states {
        let corrected = certificate.converged.then(|| of(*state, &solution.u, usize::MAX)).flatten();
        found.push(corrected);
    }
    let most = found.iter().flatten().map(|(_, done)| done.sizes.len()).min().unwrap_or_default();
    for ((state, solution, _), found) in states.iter_mut().zip(found) {
        let Some((u, done)) = found else { continue };
        let again = (done.sizes.len() > most).then(|| of(*state, &solution.u, most)).flatten();
        let (u, done) = again.unwrap_or((u, done));
        (solution.u, solution.corrections) = (u, Some(done));
    }
    timing.solve += begin.elapsed().as_secs_f64();
}
