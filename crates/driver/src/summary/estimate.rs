//! Estimated errors of the discretisation.

use serde::Serialize;

/// Estimated discretisation errors of a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Estimates {
    /// Grids that they come from.
    pub kind: Grids,
    /// What they are against.
    pub against: String,
    /// Spacings that were solved beside the run's own, relative to it, fine to coarse.
    pub spacings: Vec<f64>,
    /// Why there is no further grid, from which an order could be observed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub remark: Option<String>,
    /// Estimates.
    pub quantities: Vec<Estimate>,
}

/// The grids that an estimate takes beside that of the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Grids {
    /// Coarser ones only, which cost less than the run.
    Coarser,
    /// A finer one, which costs more than the run, and a coarser one.
    FinerAndCoarser,
    /// None: the run has solved the exact beam beside its own.
    ExactBeam,
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
    /// The same over the magnitude of the value; none where that is rounding beside the largest value of the field.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub relative: Option<f64>,
    /// Observed order; none where it had to be assumed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub order: Option<f64>,
    /// Whether the grids agree but for rounding, so that there is no error of the grid.
    pub settled: bool,
    /// Whether the values of the grids go anywhere. Those at a singular place do not.
    pub reliable: bool,
    /// What the estimate rests on.
    pub basis: String,
}
