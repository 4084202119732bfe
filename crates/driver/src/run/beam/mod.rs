//! Running beams and frames: what solving one, or breaking it, needs beside the common run, and the fields recovered.

mod between;
mod collect;
mod comparison;
mod curve;
mod eigenstrain;
mod ends;
mod exact_state;
mod extremes;
mod fields;
mod fracture;
mod law;
mod line_points;
mod one_way;
mod peak;
mod problem;
mod reaction;
mod reduced;
mod skipped;
mod soft_motions;
mod strain;
mod twin;
mod verdict;

pub use exact_state::ExactState;
pub(crate) use extremes::Along;
pub use extremes::MemberForces;
pub use fields::{BeamResult, LineFields};
pub use line_points::LinePoints;
pub use one_way::{OneWayCount, OneWayState};
pub use reaction::{JointReaction, Reaction};
pub(crate) use verdict::{checks, probes};

use super::prepare::prepare_within;
use super::restart::Restart;
use super::{RunError, RunOptions, RunReport, Sink, Sizes, SolvedState, memory, solve_states};
use crate::scene::beam::BeamScene;
use fracture::BreakingBeam;
use law::Gauge;
use peristat_assembly::model::timoshenko_beam::{CriticalStrains, TimoshenkoBeam};
use peristat_assembly::model::{Breakable, Model};
use peristat_assembly::system::System;

/// Solves every state of a beam and hands its result to `sink` as it comes. A beam that is not exact on any grid is compared
/// with the one that is, if the options say so.
///
/// # Errors
/// As [`super::run`].
pub fn run(
    scene: &BeamScene,
    options: &RunOptions,
    sink: &mut (dyn FnMut(BeamResult) -> std::io::Result<()> + Send),
) -> Result<RunReport, RunError> {
    let Some(mut gauge) = Gauge::new(scene, options) else { return run_linear(scene, options, sink) };
    let mut report = run_linear(scene, options, &mut |result| {
        gauge.compare(scene, &result);
        sink(result)
    })?;
    report.timing.compare = gauge.seconds;
    report.exact = gauge.finish(&mut report.warnings);
    Ok(report)
}

/// The same without a comparison.
fn run_linear(
    scene: &BeamScene,
    options: &RunOptions,
    sink: &mut (dyn FnMut(BeamResult) -> std::io::Result<()> + Send),
) -> Result<RunReport, RunError> {
    let recover = recovers(scene, options);
    let options = &RunOptions { recover, ..*options };
    let mut report = if scene.one_way.is_empty() {
        let mut take = |solved: SolvedState| sink(collect::result(scene, solved, recover));
        match scene.has_axial {
            true => solve::<3>(scene, options, &mut take)?,
            false => solve::<2>(scene, options, &mut take)?,
        }
    } else {
        match scene.has_axial {
            true => one_way::solve_states::<3>(scene, options, sink)?,
            false => one_way::solve_states::<2>(scene, options, sink)?,
        }
    };
    report.skipped = skipped::skipped(scene, &report, recover);
    Ok(report)
}

/// Breaks the bonds of a beam, and hands its equilibria to `sink` as they come.
///
/// # Errors
/// As [`super::run`].
pub fn run_breaking(
    scene: &BeamScene,
    options: &RunOptions,
    resume: Option<Restart>,
    sink: &mut dyn Sink,
) -> Result<RunReport, RunError> {
    let recover = recovers(scene, options);
    let options = &RunOptions { recover, ..*options };
    let mut report = match scene.has_axial {
        true => break_beam::<3>(scene, options, resume, sink)?,
        false => break_beam::<2>(scene, options, resume, sink)?,
    };
    if !report.is_interrupted {
        report.timing.compare = law::warn_of_intact(scene, options, &mut report.warnings);
    }
    report.skipped = skipped::skipped(scene, &report, recover);
    Ok(report)
}

fn break_beam<const D: usize>(
    scene: &BeamScene,
    options: &RunOptions,
    resume: Option<Restart>,
    sink: &mut dyn Sink,
) -> Result<RunReport, RunError>
where
    TimoshenkoBeam: Breakable<D, Critical = CriticalStrains>,
{
    let Some(fracture) = &scene.fracture else { return Err(RunError::NotResumable) };
    let prepared = prepare::<D>(scene, options)?;
    let mut breaking = BreakingBeam::new(scene, fracture, options.recover);
    super::fracture::run(&mut breaking, prepared, resume, sink)
}

/// Whether anything asks for section forces.
fn recovers(scene: &BeamScene, options: &RunOptions) -> bool {
    options.recover
        || scene.probes.iter().any(|p| p.field.is_recovered())
        || scene.expectations.iter().any(|e| e.is_recovered(&scene.probes))
}

/// Sizes of a beam that can be solved.
///
/// # Errors
/// As that of a run: its memory, contradictions of its supports, motions that nothing holds.
pub fn sizes(scene: &BeamScene, options: &RunOptions) -> Result<Sizes, RunError> {
    match scene.has_axial {
        true => prepare::<3>(scene, options).map(|p| p.1),
        false => prepare::<2>(scene, options).map(|p| p.1),
    }
}

/// The system of a beam, as [`super::prepare`] checks it, and whether the solver that is asked for applies.
///
/// # Errors
/// As [`super::prepare`]; a solver that does not apply is a fault of the case, too.
pub(crate) fn prepare<const D: usize>(
    scene: &BeamScene,
    options: &RunOptions,
) -> Result<(System<D>, Sizes), RunError>
where
    TimoshenkoBeam: Model<D>,
{
    let chosen = strain::chosen(scene);
    let prepared = prepare_for::<D>(scene, chosen.as_ref().ok().and_then(Option::as_ref), options)?;
    // Faults of the beam come before that of its solver.
    chosen?;
    Ok(prepared)
}

/// The same for the way in which it will be solved: in strains, if their form is given.
fn prepare_for<const D: usize>(
    scene: &BeamScene,
    chosen: Option<&strain::StrainProblem>,
    options: &RunOptions,
) -> Result<(System<D>, Sizes), RunError>
where
    TimoshenkoBeam: Model<D>,
{
    let needed = match chosen {
        Some(parts) => strain::memory::<D>(scene, &parts.form, options.recover),
        None => memory::estimate::<D>(scene, options.recover),
    };
    match scene.one_way.is_empty() {
        true => prepare_within(scene, needed, options),
        false => one_way::prepare_within(scene, needed, options),
    }
}

/// Solves every state in strains where that is the way to do it, else as any problem.
fn solve<const D: usize>(
    scene: &BeamScene,
    options: &RunOptions,
    take: &mut (dyn FnMut(SolvedState) -> std::io::Result<()> + Send),
) -> Result<RunReport, RunError>
where
    TimoshenkoBeam: Model<D>,
{
    let chosen = strain::chosen(scene);
    let (system, sizes) = prepare_for::<D>(scene, chosen.as_ref().ok().and_then(Option::as_ref), options)?;
    match chosen? {
        Some(parts) => strain::solve_states(scene, parts, (&system, sizes), options.recover, take),
        None => solve_states(scene, (&system, sizes), take),
    }
}
