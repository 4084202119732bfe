//! The checks of many cases.

use crate::background::{Failure, beside, refuse_after_fork};
use crate::error::{in_python, json};
use peristat::Error;
use peristat::diagnostic::FaultRecord;
use peristat::input::Reach;
use peristat::run::{CheckResult, RunError};
use peristat::verify::{Found, Outcome, Request, verify as verify_cases};
use pyo3::prelude::*;
use serde::Serialize;
use std::path::PathBuf;
use std::sync::atomic::Ordering;

/// What came of a file, as the Python half reads it.
#[derive(Serialize)]
struct Verified {
    case: PathBuf,
    verdict: String,
    seconds: f64,
    passed: bool,
    checks: Vec<CheckResult>,
    warnings: Vec<String>,
    faults: Vec<FaultRecord>,
    reason: Option<&'static str>,
}

impl From<Outcome> for Verified {
    fn from(outcome: Outcome) -> Self {
        let (faults, reason) = match &outcome.found {
            Found::Solved(_) => (Vec::new(), None),
            Found::Fault(error) => (error.records(), None),
            Found::Skipped(reason) => (Vec::new(), Some(*reason)),
        };
        Self {
            verdict: outcome.verdict().to_lowercase(),
            passed: !outcome.is_failure(),
            checks: outcome.summary().map_or(Vec::new(), |summary| summary.checks.clone()),
            warnings: outcome.summary().map_or(Vec::new(), |summary| summary.warnings.clone()),
            case: outcome.case,
            seconds: outcome.seconds,
            faults,
            reason,
        }
    }
}

/// Makes the checks of cases, and of those in folders; a list as JSON.
#[pyfunction]
pub(crate) fn verify(
    py: Python<'_>,
    paths: Vec<PathBuf>,
    all: bool,
    threads: Option<u16>,
    max_memory: Option<u64>,
    allow_outside: bool,
) -> PyResult<String> {
    refuse_after_fork()?;
    let reach = if allow_outside { Reach::Anywhere } else { Reach::Inside };
    let request = Request { paths, all, output: None, force: false, threads, max_memory, reach };
    let outcomes = beside(py, None, move |stop| {
        let is_interrupted = || stop.load(Ordering::Relaxed);
        let outcomes = verify_cases(&request, &is_interrupted).map_err(Error::Io)?;
        match is_interrupted() {
            true => Err(Failure::Library(Error::Run(RunError::Interrupted))),
            false => Ok(outcomes),
        }
    })?;
    let told = json(&outcomes.into_iter().map(Verified::from).collect::<Vec<_>>())?;
    Ok(in_python(&told))
}
