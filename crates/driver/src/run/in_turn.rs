//! States that are solved one after another, each recorded while the next is solved.

use super::certificate::Certificate;
use super::error::RunError;
use super::linear::LinearSolver;
use super::problem::Problem;
use super::report::Timing;
use super::right_hand_sides::solve_state;
use super::solved_state::SolvedState;
use super::workspace::StateSolution;
use peristat_assembly::system::System;

/// Unknowns of a state that is solved sooner than another thread wakes up.
const FEW_UNKNOWNS: usize = 4096;

/// Solves a state while another thread records the one before it; records first where there is no other, or not enough to do for it.
/// There is no solution if the run ends after the record. A thread that waits for parts of a product may take up the record meanwhile, so
/// `record` must not lock what `solve` may hold, such as the room of the products of a system.
///
/// # Errors
/// As `record`.
fn while_solving<T>(
    is_large: bool,
    record: Option<impl FnOnce() -> Result<bool, RunError> + Send>,
    solve: impl FnOnce() -> T,
) -> Result<Option<T>, RunError> {
    let Some(record) = record else { return Ok(Some(solve())) };
    if is_large && rayon::current_num_threads() > 1 {
        let mut goes_on = Ok(true);
        let solved = rayon::in_place_scope(|scope| {
            scope.spawn(|_| goes_on = record());
            solve()
        });
        Ok(goes_on?.then_some(solved))
    } else {
        Ok(record()?.then(solve))
    }
}

/// Takes a solved state, and tells whether the run goes on.
type Record<'a> = dyn FnMut(SolvedState) -> Result<bool, RunError> + Send + 'a;

/// States that were solved one after another.
pub(super) struct InTurn {
    /// Those that are not recorded yet: the last, or all where corrections follow.
    pub(super) kept: Vec<(usize, StateSolution, Certificate)>,
    /// The load of the last.
    pub(super) load: Vec<f64>,
    pub(super) evaluations: u64,
    pub(super) converged: bool,
    pub(super) is_interrupted: bool,
}

/// Solves the states one after another, and records those that are not kept; each while the next is solved, if these are
/// large and the solver may share the processor.
pub(super) fn in_turn<const D: usize>(
    problem: &dyn Problem<D>,
    system: &System<D>,
    solver: &mut LinearSolver<D>,
    (may_share, record): (bool, &mut Record<'_>),
    timing: &mut Timing,
) -> Result<InTurn, RunError> {
    let is_large = may_share && system.size() > FEW_UNKNOWNS;
    let (mut load, mut load_before) = (Vec::new(), Vec::new());
    let (mut kept, mut evaluations, mut converged) = (Vec::new(), 0, true);
    let mut before: Option<(usize, StateSolution, Certificate)> = None;
    for state in 0..problem.states() {
        let (record, load_before_it) = (&mut *record, &load_before);
        let record = before.take().map(|(state, solution, certificate)| {
            move || record(SolvedState { state, load: load_before_it, solution, certificate })
        });
        let solved = while_solving(is_large, record, || {
            solve_state(problem, system, solver, (state, &mut load), timing)
        })?;
        let Some(solved) = solved else {
            // Nobody takes what may have been solved meanwhile.
            solver.keep(state);
            return Ok(InTurn { kept, load, evaluations, converged, is_interrupted: true });
        };
        let ((solution, certificate), moved) = solved?;
        evaluations += moved;
        converged &= certificate.converged;
        if problem.is_corrected() || state + 1 == problem.states() {
            kept.push((state, solution, certificate));
        } else {
            before = Some((state, solution, certificate));
            std::mem::swap(&mut load, &mut load_before);
        }
    }
    Ok(InTurn { kept, load, evaluations, converged, is_interrupted: false })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicBool, Ordering};
    use std::sync::mpsc::channel;
    use std::time::Duration;

    fn with_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
        rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(work)
    }

    #[test]
    fn a_large_state_is_solved_while_the_one_before_is_recorded() {
        let patience = Duration::from_secs(60);
        let ((solves, hears_of_solve), (records, hears_of_record)) = (channel(), channel());
        let met = with_threads(2, move || {
            let record = move || {
                records.send(()).unwrap();
                Ok(hears_of_solve.recv_timeout(patience).is_ok())
            };
            // Neither can end without the other.
            while_solving(true, Some(record), move || {
                solves.send(()).unwrap();
                hears_of_record.recv_timeout(patience).is_ok()
            })
        });
        assert_eq!(met.unwrap(), Some(true));
    }

    #[test]
    fn small_states_and_those_of_one_thread_are_solved_after_a_record_that_lets_them() {
        for (threads, is_large) in [(1, true), (2, false)] {
            for goes_on in [true, false] {
                let is_recorded = AtomicBool::new(false);
                let record = || {
                    is_recorded.store(true, Ordering::Relaxed);
                    Ok(goes_on)
                };
                let solve = || is_recorded.load(Ordering::Relaxed);
                let solved = with_threads(threads, || while_solving(is_large, Some(record), solve));
                assert_eq!(solved.unwrap(), goes_on.then_some(true), "{threads} threads");
            }
        }
    }
}
