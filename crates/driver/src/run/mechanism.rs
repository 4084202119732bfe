//! Mechanisms that no support and no connection tells: parts that hang on so few bonds that they bend like hinges.

use super::certificate::Certificate;
use super::error::RunError;
use super::problem::Problem;
use super::workspace::StateSolution;
use crate::diagnostic::{Faults, root, tidy};
use peristat_assembly::system::System;

/// Stored energy over that of the same displacements of every point alone below which it is the rounding of a stiffness.
const ROUNDING: f64 = f64::EPSILON;

/// Refuses a solution without a digit that loads have found by moving the body where nothing resists.
///
/// # Errors
/// [`RunError::Case`] with the place that moves most.
pub(super) fn refuse<const D: usize>(
    problem: &dyn Problem<D>,
    system: &System<D>,
    solution: &StateSolution,
    certificate: &Certificate,
) -> Result<(), RunError> {
    let is_lost = certificate.digits == 0 && certificate.strain_digits == 0;
    // Springs that are softer than rounding have a warning that says so.
    let is_sprung = system.terms().iter().any(|term| term.is_grounded());
    if !is_lost || is_sprung || system.constraints().moves() {
        return Ok(());
    }
    let (n, u) = (system.points(), &solution.u);
    let mut blocks = vec![[[0.0; D]; D]; n];
    system.terms().iter().for_each(|term| term.add_diagonal(&mut blocks));
    let alone = |point: usize| (0..D).map(|c| blocks[point][c][c] * u[c * n + point].powi(2)).sum::<f64>();
    let stored = 2.0 * system.survey(u).energy;
    let all: f64 = (0..n).map(alone).sum();
    // Nothing moves where a cycle broke down at once.
    if !(all > 0.0 && all.is_finite()) || stored > ROUNDING * all {
        return Ok(());
    }
    let most = (0..n).max_by(|a, b| alone(*a).total_cmp(&alone(*b))).unwrap_or_default();
    let at = problem.model().position(most);
    let axes = if at[2] == 0.0 { 2 } else { 3 };
    let place = at[..axes].iter().map(|x| tidy(*x)).collect::<Vec<_>>().join(", ");
    let mut faults = Faults::default();
    faults
        .error(
            root("body"),
            format!("the body has a mechanism: under this load it moves, most at ({place}), and its bonds resist by no more than rounding"),
        )
        .hint("a part hangs on a single row of points or on a few bonds, which bend like a hinge: use a smaller spacing there, leave `edges` out, or hold the part");
    Err(RunError::Case(faults))
}
