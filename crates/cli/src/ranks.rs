//! The command where `mpirun` has started several processes: they solve one case together. The first one tells everything.

use super::args::{Command, Global, Run};
use super::solve::{load, run_loaded, with_fields};
use super::{DONE, USAGE, failed, note, processes};
use peristat::Loaded;
use peristat::run::body::{follow, lead};
use peristat_petsc::Session;
use peristat_solve::Ranks;
use std::thread::available_parallelism;

/// Does what the arguments say, together with all other processes.
pub(super) fn command(command: Command, global: Global) -> u8 {
    // Before PETSc starts: what `mpirun` allows this process is shared by those beside it, where it has not bound them to cores.
    let cores = available_parallelism().map_or(1, usize::from);
    let threads = global.threads.map_or((cores / processes::beside()).max(1), usize::from);
    let _ = rayon::ThreadPoolBuilder::new().num_threads(threads).build_global();
    let session = match Session::start() {
        Ok(session) => session,
        Err(error) => {
            note(&format!("error: {error}\n"));
            return USAGE;
        }
    };
    let first = session.number() == 0;
    match command {
        Command::Run(run) => match refused(&run) {
            // Coarser grids would be solved by the first process alone.
            None => solve(&session, &Run { no_estimate: true, ..run }, &global),
            Some(what) => end(first, &format!("error: {what} with `mpirun`\n")),
        },
        _ => {
            end(first, "error: `mpirun` is for `peristat run` alone\nhint: leave it out for other commands\n")
        }
    }
}

/// An option that is for one process alone, in words.
fn refused(run: &Run) -> Option<&'static str> {
    match run {
        _ if run.resume => Some("no run can be resumed"),
        _ if run.estimate => Some("no error is estimated from finer grids"),
        _ => None,
    }
}

fn end(first: bool, message: &str) -> u8 {
    if first {
        note(message);
    }
    USAGE
}

/// Solves a case.
fn solve(ranks: &dyn Ranks, run: &Run, global: &Global) -> u8 {
    let loaded = load(&run.case, &run.overrides, global);
    let mut failures = [f64::from(u8::from(loaded.is_err()))];
    ranks.sum(&mut failures);
    match loaded {
        Err(error) if ranks.number() == 0 || failures[0] < ranks.count() as f64 => failed(&error, global),
        Err(_) => USAGE,
        Ok(_) if failures[0] > 0.0 => USAGE,
        Ok(loaded) if ranks.number() > 0 => {
            // What is read is dropped once the part of this process is built.
            follow(loaded.scene, &with_fields(global), ranks);
            DONE
        }
        Ok(loaded) => lead(ranks, || as_first(ranks, &loaded, run, global)),
    }
}

/// What the first process does: all but the others' part of the solve.
fn as_first(ranks: &dyn Ranks, loaded: &Loaded, run: &Run, global: &Global) -> u8 {
    let done = run_loaded(loaded, run, global, &|options, _, watched| loaded.run_on(ranks, options, watched));
    done.unwrap_or_else(|error| failed(&error, global))
}
