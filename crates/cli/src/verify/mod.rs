//! `verify`: the checks of many cases.

mod report;

use super::args::Global;
use super::{DONE, FAILED, USAGE, complain, note, say};
use peristat::Error;
use peristat::input::file;
use peristat::output::atomic::write_atomically;
use peristat::verify::{self, Found, Outcome, Request, SLOW};
use std::io;
use std::path::Path;

/// Makes the checks of all cases, and writes a JUnit report if one is asked for.
pub(super) fn verify(request: &Request, junit: Option<&Path>, global: &Global) -> Result<u8, Error> {
    if let Some(file) = junit.filter(|_| !request.force) {
        replaceable(file)?;
    }
    let outcomes = verify::verify(request, &|| false)?;
    if outcomes.iter().all(|o| matches!(o.found, Found::Skipped(_))) {
        note(&nothing(&outcomes));
        return Ok(USAGE);
    }
    for outcome in outcomes.iter().filter(|_| !global.json) {
        if let Found::Fault(error) = &outcome.found {
            complain(error, global);
            note("\n");
        }
    }
    if let Some(file) = junit {
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
