//! Running a scene, whatever its body.

use super::error::RunError;
use super::obstacles::can_be_solved;
use super::options::RunOptions;
use super::report::RunReport;
use super::restart::Restart;
use super::scene_sizes::Sizes;
use super::sink::Sink;
use super::state::StateResult;
use super::{beam, body, plate};
use crate::scene::Scene;

/// Solves every state of a scene and hands its result to `sink` as it comes; one that breaks or softens goes on from `resume`.
///
/// # Errors
/// [`RunError`]; a state that did not converge is no error but an outcome in the report.
pub fn run(
    scene: &Scene,
    options: &RunOptions,
    resume: Option<Restart>,
    sink: &mut dyn Sink,
) -> Result<RunReport, RunError> {
    can_be_solved(scene)?;
    match scene {
        Scene::Beam(scene) if scene.fracture.is_some() => beam::run_breaking(scene, options, resume, sink),
        Scene::Body(scene) if scene.fracture.is_some() => body::run_breaking(scene, options, resume, sink),
        Scene::Plate(scene) if scene.fracture.is_some() => plate::run_breaking(scene, options, resume, sink),
        Scene::Body(scene) if scene.path.is_some() => body::run_softening(scene, options, resume, sink),
        _ if resume.is_some() => Err(RunError::NotResumable),
        Scene::Beam(scene) => beam::run(scene, options, &mut |result| sink.take(StateResult::Beam(result))),
        Scene::Body(scene) => body::run(scene, options, &mut |result| sink.take(StateResult::Body(result))),
        Scene::Plate(scene) => {
            plate::run(scene, options, &mut |result| sink.take(StateResult::Plate(result)))
        }
    }
}

/// Sizes of a scene that can be solved.
///
/// # Errors
/// As [`run`].
pub fn sizes(scene: &Scene, options: &RunOptions) -> Result<Sizes, RunError> {
    can_be_solved(scene)?;
    match scene {
        Scene::Beam(scene) => beam::sizes(scene, options),
        Scene::Body(scene) => body::sizes(scene, options),
        Scene::Plate(scene) => plate::sizes(scene, options),
    }
}
