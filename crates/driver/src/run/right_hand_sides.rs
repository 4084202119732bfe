//! Solving every right-hand side of a prepared problem.

use super::certificate::{self, Certificate, FEW_DIGITS};
use super::corrections::Corrections;
use super::error::RunError;
use super::in_turn::{InTurn, in_turn};
use super::linear::LinearSolver;
use super::load::Load;
use super::mechanism;
use super::method;
use super::prepare;
use super::problem::Problem;
use super::report::{RunReport, Timing};
use super::scene_sizes::Sizes;
use super::shared_solver::SharedSolver;
use super::solved_state::SolvedState;
use super::workspace::StateSolution;
use peristat_assembly::system::System;
use std::io;
use std::time::Instant;

/// Solution of a load and a factor on prescribed motions, with its certificate.
pub(super) fn certified<const D: usize>(
    problem: &dyn Problem<D>,
    system: &System<D>,
    solver: &mut LinearSolver<D>,
    (load, motion_factor): (&[f64], f64),
    timing: &mut Timing,
) -> (StateSolution, Certificate) {
    let begin = Instant::now();
    let solution = solver.solve(system, &Load::new(problem.model(), load), motion_factor);
    timing.solve += begin.elapsed().as_secs_f64();
    let begin = Instant::now();
    let certificate = certificate::certify(problem, system, load, &solution, solver.scales());
    timing.certify += begin.elapsed().as_secs_f64();
    (solution, certificate)
}

/// The same, with a cycle of more bits or a factor where a cycle leaves too few digits.
///
/// # Errors
/// A body that the load moves without resistance.
fn settled<const D: usize>(
    problem: &dyn Problem<D>,
    system: &System<D>,
    solver: &mut LinearSolver<D>,
    load: (&[f64], f64),
    timing: &mut Timing,
) -> Result<(StateSolution, Certificate), RunError> {
    let (mut solution, mut certificate) = certified(problem, system, solver, load, timing);
    let is_poor = |certificate: &Certificate| !certificate.converged || certificate.digits < FEW_DIGITS;
    while is_poor(&certificate) && solver.can_fall_back(problem) {
        solver.fall_back(problem, system, timing)?;
        (solution, certificate) = certified(problem, system, solver, load, timing);
    }
    if !certificate.converged {
        mechanism::refuse(problem, system, &solution, &certificate)?;
    }
    Ok((solution, certificate))
}

/// Solution of a state, whose load replaces what `load` holds, and the bond evaluations of its own system, if it has one.
///
/// # Errors
/// As [`settled`], and motions that contradict each other.
pub(super) fn solve_state<const D: usize>(
    problem: &dyn Problem<D>,
    system: &System<D>,
    solver: &mut LinearSolver<D>,
    (state, load): (usize, &mut Vec<f64>),
    timing: &mut Timing,
) -> Result<((StateSolution, Certificate), u64), RunError> {
    load.clear();
    load.resize(system.size(), 0.0);
    let factor = problem.add_load(state, load);
    let moved = prepare::moved(problem, system, state)?;
    let (system, motion_factor) = moved.as_ref().map_or((system, factor), |moved| (moved, 1.0));
    let solved = settled(problem, system, solver, (load, motion_factor), timing)?;
    Ok((solved, moved.as_ref().map_or(0, System::evaluations)))
}

/// Corrects the solutions of states that converged, where the problem has corrections: all as often as the one that stalls first, so that
/// a combination of load cases is the sum of these.
fn correct<const D: usize>(
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

/// Whether there is to be a next state after one was taken.
pub(super) fn goes_on(taken: io::Result<()>) -> Result<bool, RunError> {
    match taken {
        Ok(()) => Ok(true),
        Err(error) if error.kind() == io::ErrorKind::Interrupted => Ok(false),
        Err(error) => Err(error.into()),
    }
}

/// Solves every state of a prepared problem, whatever its model, and hands solution and certificate to `take`, a large one
/// perhaps while the next is solved.
pub(super) fn solve_states<const D: usize>(
    problem: &dyn Problem<D>,
    prepared: (&System<D>, Sizes),
    take: &mut (dyn FnMut(SolvedState) -> io::Result<()> + Send),
) -> Result<RunReport, RunError> {
    solve_states_by(None, problem, prepared, take)
}

/// The same by a solver that several processes share, where there is one.
pub(super) fn solve_states_by<'a, const D: usize>(
    shared: Option<Box<dyn SharedSolver + 'a>>,
    problem: &dyn Problem<D>,
    (system, sizes): (&'a System<D>, Sizes),
    take: &mut (dyn FnMut(SolvedState) -> io::Result<()> + Send),
) -> Result<RunReport, RunError> {
    let mut timing = Timing::default();
    let begin = Instant::now();
    let is_cycle = shared.is_none() && method::plan(problem) == method::Plan::Cycle;
    let coarser = if is_cycle { problem.coarser(system) } else { None };
    timing.assemble = begin.elapsed().as_secs_f64();
    let is_shared = shared.is_some();
    let mut solver = match shared {
        Some(shared) => LinearSolver::shared(problem, system, shared),
        None => LinearSolver::new(problem, system, coarser.as_ref(), &mut timing)?,
    };
    let mut record_time = 0.0;
    let mut record = |solved: SolvedState| {
        let begin = Instant::now();
        let goes_on = goes_on(take(solved));
        record_time += begin.elapsed().as_secs_f64();
        goes_on
    };
    let solved = in_turn(problem, system, &mut solver, (!is_shared, &mut record), &mut timing)?;
    let InTurn { mut kept, mut load, evaluations, converged, mut is_interrupted } = solved;
    correct(problem, system, &mut solver, &mut kept, &mut timing);
    // The factor and the levels are the largest things in memory: what is left is recorded without them.
    let (report, mut counters) = solver.into_reports();
    drop(coarser);
    let is_alone = kept.len() == 1;
    for (state, solution, certificate) in kept {
        if !is_alone {
            load.fill(0.0);
            problem.add_load(state, &mut load);
        }
        if !record(SolvedState { state, load: &load, solution, certificate })? {
            is_interrupted = true;
            break;
        }
    }
    timing.record += record_time;
    counters.bond_evaluations = evaluations + system.evaluations();
    counters.stored_bond_factors = system.terms().iter().map(|t| t.stored_factors()).sum();
    Ok(RunReport {
        sizes,
        solver: report,
        counters,
        timing,
        converged,
        is_interrupted,
        ..RunReport::default()
    })
}
