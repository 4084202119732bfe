//! The record of a run: what `summary.json` holds and `--json` prints.

mod beam;
mod body;
mod collector;
mod doubts;
mod estimate;
pub mod words;

pub use crate::model::MaterialSummary;
pub use beam::{BeamForces, BeamSummary};
pub use body::{BodyForces, BodySummary};
pub use collector::Collector;
pub use estimate::{Estimate, Estimates, Grids};

use crate::case::Units;
use crate::run::beam::ExactState;
use crate::run::fracture::FractureReport;
use crate::run::path::PathReport;
use crate::run::{Certificate, CheckResult, Counters, ProbeResult, Sizes, SolverReport, Timing};
use serde::{Deserialize, Serialize};
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
}

/// A value and where it is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Located {
    /// Value.
    pub value: f64,
    /// Position on its line, or the first coordinate.
    pub x: f64,
    /// The second coordinate of a point of a body.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub y: Option<f64>,
    /// The third coordinate of a point of a solid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub z: Option<f64>,
    /// Member of a frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub member: Option<String>,
}

/// Smallest and largest value of a field.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Extremes {
    /// Smallest.
    pub smallest: Located,
    /// Largest.
    pub largest: Located,
}

/// One state without its fields. `F` is the kind of its forces where it is known, so that they are read as such.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StateSummary<F = Forces> {
    /// Name.
    pub name: String,
    /// Load factor.
    pub load_factor: f64,
    /// Extreme values by field.
    pub extremes: BTreeMap<Cow<'static, str>, Extremes>,
    /// Forces, of the body and of what holds it.
    #[serde(flatten)]
    pub forces: F,
    /// Certificate.
    pub certificate: Certificate,
}

/// Forces of a state.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Forces {
    /// Of a beam or frame.
    Beam(BeamForces),
    /// Of a body in the plane.
    Body(BodyForces),
}

/// Model and its derived numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum ModelSummary {
    /// A beam or frame.
    Beam(BeamSummary),
    /// A body in the plane.
    Body(BodySummary),
}

impl ModelSummary {
    /// Spacing, of the first line of a beam.
    pub fn spacing(&self) -> f64 {
        match self {
            Self::Beam(beam) => beam.spacing[0],
            Self::Body(plane) => plane.spacing,
        }
    }

    /// Horizon, of the first line of a beam.
    pub fn horizon(&self) -> f64 {
        match self {
            Self::Beam(beam) => beam.spacing[0] * beam.horizon_ratio[0],
            Self::Body(plane) => plane.spacing * plane.horizon_ratio,
        }
    }
}

/// Everything about a finished run but the fields.
#[derive(Clone, Debug, Serialize)]
pub struct Summary {
    /// How it ended.
    pub status: Status,
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
    /// Largest resident memory of the process, bytes, where the system tells.
    pub peak_memory_bytes: Option<u64>,
    /// Version of peristat.
    pub version: &'static str,
}
