//! `verify`: the checks of many cases.

mod find;
mod report;

use super::args::Global;
use super::writing::Writing;
use super::{DONE, FAILED, USAGE, complain, note, say, solve};
use crate::workers::side_by_side;
use peristat::Error;
use peristat::input::file;
use peristat::output::atomic::write_atomically;
use peristat::output::folder::below;
use peristat::results::Claim;
use peristat::run::{RunOptions, taking};
use peristat::summary::Summary;
use std::collections::{HashMap, HashSet};
use std::io;
use std::path::{Component, Path, PathBuf};
use std::time::Instant;

/// What to verify.
pub(super) struct Request {
    pub(super) paths: Vec<PathBuf>,
    pub(super) all: bool,
    pub(super) junit: Option<PathBuf>,
    pub(super) output: Option<PathBuf>,
    pub(super) force: bool,
}

/// What came of one file.
struct Outcome {
    case: PathBuf,
    seconds: f64,
    found: Found,
}

/// What a file is found to be.
enum Found {
    /// A case with its result.
    Solved(Box<Summary>),
    /// A case without one.
    Fault(Error),
    /// Nothing to verify here, and why.
    Skipped(&'static str),
}

/// Why slow cases are skipped.
const SLOW: &str = "slow, with `--all` only";

/// Makes the checks of all cases.
pub(super) fn verify(request: &Request, global: &Global) -> Result<u8, Error> {
    let mut files = Vec::new();
    let default = [PathBuf::from("cases")];
    let paths = if request.paths.is_empty() { &default[..] } else { &request.paths };
    for path in paths {
        find::collect(path, request.all, &mut files)?;
    }
    let mut known = HashSet::new();
    files.retain(|file| known.insert(file.clone()));
    if request.output.is_some() {
        apart(&files)?;
    }
    if let Some(file) = request.junit.as_ref().filter(|_| !request.force) {
        replaceable(file)?;
    }
    let outcomes = side_by_side(global.threads, files.len(), |k| outcome(&files[k], request, global));
    if outcomes.iter().all(|o| matches!(o.found, Found::Skipped(_))) {
        note(&nothing(&outcomes));
        return Ok(USAGE);
    }
    for outcome in &outcomes {
        if let Found::Fault(error) = &outcome.found {
            complain(error, global);
            note("\n");
        }
    }
    if let Some(file) = &request.junit {
        write_atomically(file, report::junit(&outcomes).as_bytes())?;
    }
    if global.json {
        say(&report::json(&outcomes))?;
    } else if !global.quiet {
        say(&report::table(&outcomes, global.verbose))?;
    }
    let bad_input = outcomes.iter().any(|o| matches!(o.found, Found::Fault(_)));
    Ok(match (bad_input, outcomes.iter().any(Outcome::is_failure)) {
        (true, _) => USAGE,
        (false, true) => FAILED,
        (false, false) => DONE,
    })
}

/// What to say where there is no case to solve.
fn nothing(outcomes: &[Outcome]) -> String {
    let slow = outcomes.iter().filter(|o| matches!(o.found, Found::Skipped(SLOW))).count();
    match slow {
        0 => "error: there are no cases to verify\nhint: name case files or folders that hold some\n".into(),
        _ => format!(
            "error: all {slow} cases here are marked `slow`\nhint: add `--all`, or name them one by one\n"
        ),
    }
}

/// The path of a case without its root and its steps upwards, so that results stay in the folder that was asked for.
fn inside(case: &Path) -> PathBuf {
    let case = case.with_extension("");
    case.components().filter(|c| matches!(c, Component::Normal(_))).collect()
}

/// Whether no two cases would have their results in one folder.
fn apart(files: &[PathBuf]) -> io::Result<()> {
    let mut folders: HashMap<PathBuf, &PathBuf> = HashMap::new();
    for path in files {
        if let Some(other) = folders.insert(inside(path), path) {
            let message = format!(
                "{} and {} would have their results in one folder\nhint: verify them one by one, into folders of their own",
                other.display(),
                path.display()
            );
            return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
        }
    }
    Ok(())
}

fn outcome(case: &Path, request: &Request, global: &Global) -> Outcome {
    let begin = Instant::now();
    let found = found(case, request, global).unwrap_or_else(Found::Fault);
    Outcome { case: case.into(), seconds: begin.elapsed().as_secs_f64(), found }
}

/// Solves a case. Of files that nobody named, slow cases and those that are none are skipped.
fn found(case: &Path, request: &Request, global: &Global) -> Result<Found, Error> {
    let named = request.paths.iter().any(|path| path == case);
    if let Some(other) = find::other_than_case(case, global.max_memory).filter(|_| !named) {
        return Ok(Found::Skipped(other));
    }
    let loaded = solve::load(case, &[], global)?;
    if loaded.scene.case().slow && !request.all && !named {
        return Ok(Found::Skipped(SLOW));
    }
    let summary = match &request.output {
        Some(folder) => {
            let claim = Claim::new(&below(folder, &inside(case))?, request.force)?;
            solve::solve_into(
                &loaded,
                None,
                Writing::new(&loaded.scene, claim),
                solve::Wanted::Nothing,
                global,
            )
        }
        None => {
            let options = RunOptions { recover: false, max_memory: global.max_memory, compare: true };
            loaded.run(&options, None, &mut taking(|_| Ok(())))
        }
    };
    summary.map(|summary| Found::Solved(Box::new(summary)))
}

/// Whether a JUnit report may be written to a file: it is not there, or holds an earlier report.
fn replaceable(path: &Path) -> io::Result<()> {
    let is_report = || file::read(path, None).is_ok_and(|bytes| bytes.starts_with(report::JUNIT.as_bytes()));
    if !path.exists() || is_report() {
        return Ok(());
    }
    let message = format!(
        "{} exists and is no JUnit report\nhint: choose another file, or add `--force`",
        path.display()
    );
    Err(io::Error::new(io::ErrorKind::AlreadyExists, message))
}
