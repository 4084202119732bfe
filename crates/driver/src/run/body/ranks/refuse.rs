//! Cases that several processes cannot share.

use crate::run::Problem;
use crate::run::RunError;
use crate::run::method::{Plan, plan};
use crate::scene::Scene;
use crate::scene::body::BodyScene;

/// The body of a scene that several processes may share.
///
/// # Errors
/// [`RunError::NotShared`] with what stands against it.
pub(crate) fn body(scene: &Scene) -> Result<&BodyScene, RunError> {
    let scene = match scene {
        Scene::Body(scene) => scene,
        Scene::Beam(_) => return refused("beams and frames"),
        Scene::Plate(_) => return refused("plates in bending"),
    };
    let joins =
        |scene: &BodyScene| scene.model.lattice().is_some_and(|(_, mirrors)| mirrors.joined.contains(&true));
    match scene {
        scene if scene.case.is_traced() => refused("bodies that break or soften"),
        scene if scene.model.lattice().is_none() => refused("bodies of listed points"),
        scene if !scene.conditions.rigid.is_empty() => refused("bodies with rigid regions"),
        scene if scene.model.needs_all_rows() => refused("membranes of shells"),
        scene if joins(scene) => refused("bodies with joined sides"),
        scene if scene.limit.is_some() => refused("corrections to the limit of local elasticity"),
        scene if !scene.intensities.is_empty() => {
            refused("stress intensities, which need solves of their own,")
        }
        scene => Ok(scene),
    }
}

/// Whether a problem is solved by multigrid cycles, which alone are shared.
///
/// # Errors
/// [`RunError::NotShared`] where it is not.
pub(super) fn check_plan<const D: usize>(problem: &dyn Problem<D>) -> Result<(), RunError> {
    match plan(problem) {
        Plan::Cycle => Ok(()),
        Plan::Factor => refused("cases that are solved by a factor, as this one,"),
        Plan::Blocks => refused("bodies without coarser lattices"),
    }
}

/// An error for bodies that are too small for so many processes.
pub(super) fn too_small<T>(points: usize, processes: usize) -> Result<T, RunError> {
    refused(&format!("{points} points are too few for {processes} processes: they"))
}

/// An error that names what is refused.
pub(super) fn refused<T>(what: &str) -> Result<T, RunError> {
    Err(RunError::NotShared(what.into()))
}
