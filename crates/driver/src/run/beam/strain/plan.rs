//! Where the strain form applies.

use super::StrainProblem;
use crate::case::Solver;
use crate::diagnostic::{Faults, JsonPath};
use crate::run::RunError;
use crate::scene::beam::BeamScene;
use peristat_assembly::model::timoshenko_beam::StrainForm;

/// Supports beyond the two that hold a beam, at most: each takes one more solution and couples all strains.
const REDUNDANT: usize = 8;

/// Eigenvalues of the scaled stiffness below this belong to a bond law that locks: what conjugate gradients on the bonds
/// finish is then closer.
const LEAST: f64 = 1e-6;

/// What the strain form needs of a beam, or why it does not apply.
fn applies(scene: &BeamScene) -> Result<StrainProblem<'_>, String> {
    if scene.fracture.is_some() {
        return Err("the beam breaks".into());
    }
    if !scene.one_way.is_empty() {
        return Err("supports or foundations act one way".into());
    }
    if scene.has_axial {
        return Err("it is for beams with the unknowns w and phi".into());
    }
    if !scene.bedding.is_empty() {
        return Err("the beam lies on an elastic foundation".into());
    }
    let form = StrainForm::new(&scene.beam).map_err(|reason| reason.to_string())?;
    if scene.equations.iter().any(|equation| equation.terms.len() != 1) {
        return Err("links join points of the beam".into());
    }
    if scene.springs.iter().any(|spring| spring.single().is_none()) {
        return Err("a spring acts in a direction between two unknowns".into());
    }
    let supports = scene.equations.len() + scene.springs.len();
    if supports > REDUNDANT + 2 {
        return Err(format!("{supports} displacements are held or sprung, more than {}", REDUNDANT + 2));
    }
    let states = scene.states.iter().map(|state| (&state.loads, state.motion_factor)).collect();
    let least_eigenvalue = form.least_eigenvalue();
    Ok(StrainProblem { beam: &scene.beam, form, least_eigenvalue, states })
}

/// The strain form of a beam where it is the way to solve it.
///
/// # Errors
/// [`RunError::Case`] if the case asks for it and it does not apply.
pub(in super::super) fn chosen(scene: &BeamScene) -> Result<Option<StrainProblem<'_>>, RunError> {
    match scene.solver {
        Solver::Auto => Ok(applies(scene).ok().filter(|parts| parts.least_eigenvalue >= LEAST)),
        Solver::Band | Solver::Sparse | Solver::Multigrid | Solver::Pcg => Ok(None),
        Solver::Strain => applies(scene).map(Some).map_err(|reason| {
            let mut faults = Faults::default();
            faults
                .error(JsonPath::default().key("solver"), format!("the strain form does not apply: {reason}"))
                .hint("leave `solver` out, and the best one is taken");
            RunError::Case(faults)
        }),
    }
}
