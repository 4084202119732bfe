//! Running plates in bending: the common run, and the fields recovered.

mod along_lines;
mod fields;
mod fracture;
mod levels;
mod of_moments;
mod problem;
mod reaction;
mod verdict;

pub use along_lines::{AlongLines, LineReaction};
pub use fields::PlateResult;
pub use reaction::PlateReaction;
pub(crate) use verdict::{checks, probes};

use super::restart::Restart;
use super::sink::Sink;
use super::{RunError, RunOptions, RunReport, Sizes, SolvedState, prepare, solve_states};
use crate::scene::PlateScene;

/// Solves every state of a plate and hands its result to `sink` as it comes.
///
/// # Errors
/// As [`super::run`].
pub fn run(
    scene: &PlateScene,
    options: &RunOptions,
    sink: &mut (dyn FnMut(PlateResult) -> std::io::Result<()> + Send),
) -> Result<RunReport, RunError> {
    let recover = options.recover || asks_for_moments(scene);
    let (system, sizes) = prepare(scene, &RunOptions { recover, ..*options })?;
    let mut take = |solved: SolvedState| sink(fields::collect(scene, solved, recover));
    let mut report = solve_states(scene, (&system, sizes), &mut take)?;
    report.skipped = skipped(scene, &report, recover);
    Ok(report)
}

/// Breaks the bonds of a plate, and hands equilibria to `sink` as they come.
///
/// # Errors
/// As [`super::run`].
pub fn run_breaking(
    scene: &PlateScene,
    options: &RunOptions,
    resume: Option<Restart>,
    sink: &mut dyn Sink,
) -> Result<RunReport, RunError> {
    let Some(fracture) = &scene.fracture else { return Err(RunError::NotResumable) };
    let recover = options.recover || asks_for_moments(scene);
    let prepared = prepare(scene, &RunOptions { recover, ..*options })?;
    let mut breaking = fracture::BreakingPlate::new(scene, fracture, recover);
    let mut report = super::fracture::run(&mut breaking, prepared, resume, sink)?;
    report.skipped = skipped(scene, &report, recover);
    Ok(report)
}

/// Sizes of a plate that can be solved.
///
/// # Errors
/// As [`super::sizes`].
pub fn sizes(scene: &PlateScene, options: &RunOptions) -> Result<Sizes, RunError> {
    prepare(scene, options).map(|prepared| prepared.1)
}

/// Whether a probe, a check or a line reads more than deflections, rotations and reactions.
fn asks_for_moments(scene: &PlateScene) -> bool {
    !scene.lines.is_empty()
        || scene.probes.iter().any(|probe| probe.is_recovered())
        || scene.expectations.iter().any(verdict::is_recovered)
}

/// What a plate was spared, and why.
fn skipped(scene: &PlateScene, report: &RunReport, recover: bool) -> Vec<String> {
    let points = scene.plate.nodes().points();
    let mut skipped = vec!["Newton iterations: every term is linear".to_string()];
    skipped.push("points beyond the edges: bonds end on them, where points lie".into());
    let counters = &report.counters;
    if counters.right_hand_sides > counters.factorisations {
        let spared = counters.right_hand_sides - counters.factorisations;
        let s = if spared == 1 { "" } else { "s" };
        skipped.push(format!("{spared} factorisation{s}: the stiffness does not depend on the load"));
    }
    if !recover {
        skipped
            .push(format!("moments and shear forces of {points} points: no output or check asks for them"));
    }
    skipped
}
