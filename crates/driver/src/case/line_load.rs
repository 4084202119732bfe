//! Loads along lines on plates in bending.

use super::{Amount, Names};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A force or moment per length of a plate in bending, along an `edge`, or along a row or column of points `from` one `to` another.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LineLoad {
    /// Name of an edge or of a hole, or a list of several; `all` is the whole border, and `outer` is it without the holes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edge: Option<Names>,
    /// Start of a line on the plate, along x or y to its end.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from: Option<[f64; 2]>,
    /// End of the line.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub to: Option<[f64; 2]>,
    /// Force per length along w: a number, or a formula such as `"100*(1 - x)"`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force: Option<Amount>,
    /// Moment per length of an edge that is M_nn there: positive, it bends the plate beside it so that its rotation along the outward normal grows.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moment_n: Option<Amount>,
    /// Twisting moment per length of an edge that is M_nt there, counter-clockwise around the body.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moment_t: Option<Amount>,
}
