//! Joined sides of a body in the plane.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Two opposite sides that are joined, so that the body repeats itself. Nothing else holds or loads these edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Periodic {
    /// The direction from one of them to the other.
    pub along: Axis,
}

/// A direction of the plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Axis {
    /// From `left` to `right`.
    X,
    /// From `bottom` to `top`.
    Y,
}
