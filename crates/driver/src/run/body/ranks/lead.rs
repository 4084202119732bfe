//! The first process leads, all others follow.

use super::agree::agree;
use super::crew::Crew;
use super::refuse;
use crate::model::with_body;
use crate::run::body::problem::BodyProblem;
use crate::run::{RunError, RunOptions, can_be_solved, prepare};
use crate::scene::Scene;
use crate::scene::body::BodyScene;
use peristat_assembly::model::plane::Solvable;
use peristat_solve::Ranks;

/// What all processes do next.
pub(super) enum Task {
    /// Build their parts.
    Build,
    /// Solve for a residual.
    Solve { residual_drop: f64, max_iterations: usize },
    /// Apply the preconditioner to a residual.
    Precondition,
    /// Nothing more.
    End,
}

impl Task {
    /// Tells all others.
    pub(super) fn tell(&self, ranks: &dyn Ranks) {
        let mut words = match *self {
            Self::Build => [1.0, 0.0, 0.0],
            Self::Solve { residual_drop, max_iterations } => [2.0, residual_drop, max_iterations as f64],
            Self::Precondition => [3.0, 0.0, 0.0],
            Self::End => [0.0; 3],
        };
        ranks.broadcast(&mut words);
    }

    /// The next one, as the first process tells it.
    pub(super) fn next(ranks: &dyn Ranks) -> Self {
        let mut words = [0.0; 3];
        ranks.broadcast(&mut words);
        match words {
            [1.0, ..] => Self::Build,
            [2.0, residual_drop, iterations] => {
                Self::Solve { residual_drop, max_iterations: iterations as usize }
            }
            [3.0, ..] => Self::Precondition,
            _ => Self::End,
        }
    }
}

/// Does the work of the first process, and lets the others go.
pub fn lead<T>(ranks: &dyn Ranks, work: impl FnOnce() -> T) -> T {
    let done = work();
    Task::End.tell(ranks);
    done
}

/// Does the work of another process than the first until this lets it go. The first one tells all errors.
pub fn follow(scene: Scene, options: &RunOptions, ranks: &dyn Ranks) {
    let Task::Build = Task::next(ranks) else { return };
    let follower = build(&scene, options, ranks);
    // Names, loads and images of the whole body are with the first process.
    drop(scene);
    match follower.and_then(|follower| follower.follow()) {
        Ok(()) => {}
        // It is an error of all processes, which the first one tells before it lets this one go.
        Err(_) => while !matches!(Task::next(ranks), Task::End) {},
    }
}

/// Tells the others to build their parts, and returns the body that all of them share.
///
/// # Errors
/// [`RunError`] for scenes that cannot be solved, or not so.
pub(crate) fn begin<'s>(ranks: &dyn Ranks, scene: &'s Scene) -> Result<&'s BodyScene, RunError> {
    Task::Build.tell(ranks);
    shared(ranks, scene)
}

/// The body that all processes share.
fn shared<'s>(ranks: &dyn Ranks, scene: &'s Scene) -> Result<&'s BodyScene, RunError> {
    agree(ranks, can_be_solved(scene).and_then(|()| refuse::body(scene)))
}

/// What follows the first process.
pub(super) trait Follower {
    /// Does what the first process asks for until there is nothing more.
    ///
    /// # Errors
    /// [`RunError::Solve`] where some factor does not exist, on all processes.
    fn follow(&self) -> Result<(), RunError>;
}

fn build<'r>(
    scene: &Scene,
    options: &RunOptions,
    ranks: &'r dyn Ranks,
) -> Result<Box<dyn Follower + 'r>, RunError> {
    let scene = shared(ranks, scene)?;
    with_body!(&scene.model, body => of_body(&BodyProblem::new(scene, body.clone()), options, ranks))
}

fn of_body<'r, const D: usize>(
    problem: &BodyProblem<dyn Solvable<D>>,
    options: &RunOptions,
    ranks: &'r dyn Ranks,
) -> Result<Box<dyn Follower + 'r>, RunError> {
    let (system, _) = agree(ranks, prepare(problem, options))?;
    Ok(Box::new(Crew::new(problem, &system, ranks)?))
}
