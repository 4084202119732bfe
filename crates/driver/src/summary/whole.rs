//! Everything about a finished run but the fields.

use super::estimate::Estimates;
use super::extremes::Located;
use super::model::ModelSummary;
use super::state::StateSummary;
use crate::case::Units;
use crate::memory;
use crate::run::beam::ExactState;
use crate::run::fracture::FractureReport;
use crate::run::path::PathReport;
use crate::run::{CheckResult, Counters, ProbeResult, Sizes, SolverReport, Timing};
use serde::Serialize;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// Everything converged and every check passed.
    Passed,
    /// Everything converged, a check failed.
    CheckFailed,
    /// A state did not converge.
    NotConverged,
    /// The run was asked to end before it was done; all is of the run so far.
    Interrupted,
}

/// Everything about a finished run but the fields.
#[derive(Clone, Debug, Serialize)]
pub struct Summary {
    /// How it ended.
    pub status: Status,
    /// How far a run came that was interrupted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub interrupted: Option<String>,
    /// Title of the case.
    pub title: String,
    /// Units of all numbers.
    pub units: Units,
    /// Model and its derived numbers.
    pub model: ModelSummary,
    /// Sizes.
    #[serde(flatten)]
    pub sizes: Sizes,
    /// Estimated discretisation errors, unless the run was to leave them out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub estimate: Option<Estimates>,
    /// Why there are none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub no_estimate: Option<String>,
    /// Checks.
    pub checks: Vec<CheckResult>,
    /// Probes.
    pub probes: Vec<ProbeResult>,
    /// States: load steps, or load cases and combinations.
    pub states: Vec<StateSummary>,
    /// Extreme values over all load cases and combinations, with the name of the state.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub envelope: BTreeMap<Cow<'static, str>, [(String, Located); 2]>,
    /// How the body broke.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fracture: Option<FractureReport>,
    /// How the body went along its path.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub path: Option<PathReport>,
    /// What the states of the exact beam are, for estimates of errors.
    #[serde(skip)]
    pub exact: Option<Vec<ExactState>>,
    /// What the scene was spared, and why.
    pub skipped: Vec<String>,
    /// Counters.
    pub counters: Counters,
    /// Warnings on the case.
    pub warnings: Vec<String>,
    /// Method and why it was chosen.
    pub solver: SolverReport,
    /// Wall time per stage, s.
    pub timing_s: Timing,
    /// Largest resident memory of the process, bytes, where the system tells and [`Self::measured`] has asked.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub peak_memory_bytes: Option<u64>,
    /// Version of peristat.
    pub version: &'static str,
}

impl Summary {
    /// The same with the largest resident memory of the process so far. To ask the system takes a fifth of the time of a small beam.
    #[must_use]
    pub fn measured(self) -> Self {
        Self { peak_memory_bytes: memory::peak(), ..self }
    }
}
