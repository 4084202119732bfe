//! Estimated errors of the discretisation.

use serde::Serialize;

/// Estimated discretisation errors of a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Estimates {
    /// What they are against.
    pub against: String,
    /// Spacings that were solved beside the run's own, relative to it.
    pub spacings: Vec<f64>,
    /// Why there is no coarser one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub remark: Option<String>,
    /// Wall time of these, s.
    pub seconds: f64,
    /// Estimates.
    pub quantities: Vec<Estimate>,
}

/// The estimated discretisation error of a quantity.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Estimate {
    /// Name of the quantity.
    pub name: String,
    /// Its value.
    pub value: f64,
    /// Estimated magnitude of its difference from the local solution.
    pub error: f64,
    /// The same over the magnitude of the extrapolated value; none where that vanishes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub relative: Option<f64>,
    /// Observed order; none where it had to be assumed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub order: Option<f64>,
    /// What the estimate rests on.
    pub basis: String,
}
