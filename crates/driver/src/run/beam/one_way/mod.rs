//! Solving beams some of whose parts act one way: each state by a search for those that act.
//!
//! Loads do not superpose, so every state, combinations and steps as well, has a search of its own, from what acts in the state before.
//! With the parts that act the beam is linear. It ends where none of them has a force of the wrong sign and none of the others is
//! passed: for a beam that they hold there is one such set, whatever the way to it.

mod acting;
mod counts;
mod search;

pub use counts::{OneWayCount, OneWayState};

use super::{BeamResult, collect};
use crate::diagnostic::Faults;
use crate::run::prepare::{check_memory, prepare_within as prepare_problem};
use crate::run::right_hand_sides::certified;
use crate::run::{
    Counters, LinearSolver, Problem, RunError, RunOptions, RunReport, Sizes, SolvedState, SolverReport,
    Timing, goes_on,
};
use crate::scene::beam::BeamScene;
use acting::Acting;
use peristat_assembly::model::Model;
use peristat_assembly::model::timoshenko_beam::TimoshenkoBeam;
use peristat_assembly::system::{FreeMotion, System, free_motions};
use search::Search;
use std::time::Instant;

/// The system with all that can act together, as [`crate::run::prepare()`] checks it.
///
/// # Errors
/// As that.
pub(super) fn prepare_within<const D: usize>(
    scene: &BeamScene,
    needed: u64,
    options: &RunOptions,
) -> Result<(System<D>, Sizes), RunError>
where
    TimoshenkoBeam: Model<D>,
{
    check_memory(needed, options.max_memory)?;
    let mut acting = Acting::new(scene, 0, vec![true; scene.one_way.len()]);
    // What cannot act beside the rest is left out.
    acting.system::<D>()?;
    prepare_problem(&acting, needed, options)
}

/// What was found of a state.
struct Found<'a> {
    acting: Acting<'a>,
    load: Vec<f64>,
    solution: crate::run::workspace::StateSolution,
    certificate: crate::run::Certificate,
    state: OneWayState,
}

/// What all searches took together.
#[derive(Default)]
struct Taken {
    timing: Timing,
    counters: Counters,
    solver: SolverReport,
}

/// Solves every state and hands its result to `sink`.
///
/// # Errors
/// As [`crate::run::run`]; a beam that is a mechanism once parts have lifted off.
pub(super) fn solve_states<const D: usize>(
    scene: &BeamScene,
    options: &RunOptions,
    sink: &mut dyn FnMut(BeamResult) -> std::io::Result<()>,
) -> Result<RunReport, RunError>
where
    TimoshenkoBeam: Model<D>,
{
    let (_, sizes) = super::prepare::<D>(scene, options)?;
    let mut taken = Taken::default();
    let (mut converged, mut is_interrupted, mut warnings) = (true, false, Faults::default());
    let mut acts = vec![true; scene.one_way.len()];
    for state in 0..scene.states.len() {
        let found = find::<D>(scene, state, acts, &mut taken)?;
        acts = found.acting.acts.clone();
        if !found.state.settled {
            warn(scene, state, &found.state, &mut warnings);
        }
        converged &= found.certificate.converged;
        let begin = Instant::now();
        let springs = found.acting.springs_of_scene();
        let Found { load, solution, certificate, .. } = found;
        let solved = SolvedState { state, load: &load, solution, certificate };
        let parts = (&scene.beam, &springs[..]);
        let mut result = collect::of_beam(scene, parts, &scene.states[state], solved, options.recover);
        result.one_way = Some(found.state);
        is_interrupted = !goes_on(sink(result))?;
        taken.timing.record += begin.elapsed().as_secs_f64();
        if is_interrupted {
            break;
        }
    }
    Ok(RunReport {
        sizes,
        solver: taken.solver,
        counters: taken.counters,
        timing: taken.timing,
        warnings,
        converged,
        is_interrupted,
        ..RunReport::default()
    })
}

/// Finds the parts that act in a state, from a guess.
fn find<'a, const D: usize>(
    scene: &'a BeamScene,
    state: usize,
    guess: Vec<bool>,
    taken: &mut Taken,
) -> Result<Found<'a>, RunError>
where
    TimoshenkoBeam: Model<D>,
{
    let (mut search, mut acts, mut solves) = (Search::default(), guess, 0);
    loop {
        let mut acting = Acting::new(scene, state, acts);
        let mut system = acting.system::<D>()?;
        let motions = free_motions(&scene.beam, &system);
        if !motions.is_empty() {
            acting.soften();
            system = acting.system::<D>()?;
        }
        let mut load = vec![0.0; system.size()];
        let factor = Problem::<D>::add_load(&acting, state, &mut load);
        let mut solver = LinearSolver::new(&acting, &system, None, &mut taken.timing)?;
        let (mut solution, mut certificate) =
            certified(&acting, &system, &mut solver, (&load, factor), &mut taken.timing);
        solution.multipliers = acting.of_all(&solution.multipliers);
        let wrongs = counts::wrongs(scene, &acting, (&solution, &solution.multipliers), solver.scales());
        solves += 1;
        taken.add(solver, &system);
        let wrong = counts::wrong(&wrongs);
        if wrong.is_empty() && !motions.is_empty() {
            return Err(loose(scene, state, &acting.acts, &motions));
        }
        let next = if wrong.is_empty() { None } else { search.next(&acting.acts, &wrong) };
        match next {
            Some(next) => acts = next,
            None => {
                let state = counts::state(scene, &acting.acts, &wrongs, solves);
                certificate.converged &= state.settled;
                return Ok(Found { acting, load, solution, certificate, state });
            }
        }
    }
}

impl Taken {
    fn add<const D: usize>(&mut self, solver: LinearSolver<D>, system: &System<D>) {
        let (report, counters) = solver.into_reports();
        let iterations = [std::mem::take(&mut self.solver.iterations), report.iterations.clone()].concat();
        self.solver = SolverReport { iterations, ..report };
        let own = &mut self.counters;
        own.factorisations += counters.factorisations;
        own.analyses += counters.analyses;
        own.pcg_iterations += counters.pcg_iterations;
        own.right_hand_sides += counters.right_hand_sides;
        own.factor_bytes = own.factor_bytes.max(counters.factor_bytes);
        own.bond_evaluations += system.evaluations();
        own.stored_bond_factors = system.terms().iter().map(|t| t.stored_factors()).sum();
    }
}

/// Says that a search went round in circles.
fn warn(scene: &BeamScene, state: usize, found: &OneWayState, warnings: &mut Faults) {
    let message = format!(
        "{}: which supports act was not found: after {} tries the same ones came again",
        scene.states[state].name, found.solves
    );
    let path = scene.path_of(scene.one_way[0].origin);
    warnings
        .warning(path, message)
        .hint("what acts one way may be held twice by others: look for supports at one place");
}

/// The error of a beam that nothing holds once parts have lifted off.
fn loose(scene: &BeamScene, state: usize, acts: &[bool], motions: &[FreeMotion]) -> RunError {
    let lifted = || scene.one_way.iter().zip(acts).filter(|(_, acts)| !**acts).map(|(part, _)| part.origin);
    let mut names: Vec<String> = Vec::new();
    lifted().map(|origin| scene.name_of(origin)).for_each(|name| {
        if !names.contains(&name) {
            names.push(name);
        }
    });
    let path = scene.path_of(lifted().next().unwrap_or(scene.one_way[0].origin));
    let mut faults = Faults::default();
    for motion in motions {
        let what = scene.describe_motion(motion);
        let name = &scene.states[state].name;
        faults
            .error(path.clone(), format!("`{name}` leaves {} without force; then {what}", names.join(", ")))
            .hint("a load must press it on what acts one way, or something that acts both ways must hold it");
    }
    RunError::Case(faults)
}
