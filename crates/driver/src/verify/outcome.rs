//! What came of a file that was to be verified.

use crate::Error;
use crate::summary::{Status, Summary};
use std::path::PathBuf;

/// What came of one file.
#[derive(Debug)]
pub struct Outcome {
    /// The file.
    pub case: PathBuf,
    /// Time it took, s.
    pub seconds: f64,
    /// What it is found to be.
    pub found: Found,
}

/// What a file is found to be.
#[derive(Debug)]
pub enum Found {
    /// A case with its result.
    Solved(Box<Summary>),
    /// A case without one.
    Fault(Error),
    /// Nothing to verify here, and why.
    Skipped(&'static str),
}

/// Why slow cases are skipped.
pub const SLOW: &str = "slow, with `--all` only";
/// The verdict on a case whose checks all pass.
pub const PASSED: &str = "passed";
/// The verdict on a case that is solved and has no checks.
pub const UNCHECKED: &str = "without checks";

impl Outcome {
    /// The record of the run, of a case that was solved.
    pub fn summary(&self) -> Option<&Summary> {
        match &self.found {
            Found::Solved(summary) => Some(summary),
            Found::Fault(_) | Found::Skipped(_) => None,
        }
    }

    /// What came of it in a word or two; capitals say that something is wrong.
    pub fn verdict(&self) -> &'static str {
        match &self.found {
            Found::Skipped(_) => "skipped",
            Found::Fault(_) => "ERROR",
            Found::Solved(s) => match s.status {
                Status::Passed if s.checks.is_empty() => UNCHECKED,
                Status::Passed => PASSED,
                Status::CheckFailed => "FAILED",
                Status::NotConverged => "NOT CONVERGED",
                Status::Interrupted => "INTERRUPTED",
            },
        }
    }

    /// Whether something is wrong with it.
    pub fn is_failure(&self) -> bool {
        match &self.found {
            Found::Solved(summary) => summary.status != Status::Passed,
            Found::Fault(_) => true,
            Found::Skipped(_) => false,
        }
    }
}
