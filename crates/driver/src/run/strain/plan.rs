//! Where the strain form applies.

use super::StrainProblem;
use crate::case::Solver;
use crate::diagnostic::{Faults, JsonPath};
use crate::run::{Problem, RunError};

/// Supports beyond the two that hold a beam, at most: each takes one more solution and couples all strains.
const REDUNDANT: usize = 8;

/// Eigenvalues of the scaled stiffness below this belong to a bond law that locks: what conjugate gradients on the bonds
/// finish is then closer.
const LEAST: f64 = 1e-6;

/// What the strain form needs of a problem, or why it does not apply.
fn applies<const D: usize, P: Problem<D>>(problem: &P) -> Result<StrainProblem<'_>, String> {
    let parts = problem.strain_problem()?;
    if problem.equations().iter().any(|equation| equation.terms.len() != 1) {
        return Err("links join points of the beam".into());
    }
    if problem.springs().iter().any(|spring| spring.single().is_none()) {
        return Err("a spring acts in a direction between two unknowns".into());
    }
    let supports = problem.equations().len() + problem.springs().len();
    if supports > REDUNDANT + 2 {
        return Err(format!("{supports} displacements are held or sprung, more than {}", REDUNDANT + 2));
    }
    Ok(parts)
}

/// The strain form of a problem where it is the way to solve it.
///
/// # Errors
/// [`RunError::Case`] if the case asks for it and it does not apply.
pub(in super::super) fn chosen<const D: usize, P: Problem<D>>(
    problem: &P,
) -> Result<Option<StrainProblem<'_>>, RunError> {
    match problem.solver() {
        Solver::Auto => Ok(applies(problem).ok().filter(|parts| parts.form.least_eigenvalue() >= LEAST)),
        Solver::Band | Solver::Sparse => Ok(None),
        Solver::Strain => applies(problem).map(Some).map_err(|reason| {
            let mut faults = Faults::default();
            faults
                .error(JsonPath::default().key("solver"), format!("the strain form does not apply: {reason}"))
                .hint("leave `solver` out, and the best one is taken");
            RunError::Case(faults)
        }),
    }
}
