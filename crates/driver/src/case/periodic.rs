//! Joined sides of a body.

use super::SpaceAxis;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Two opposite sides that are joined, so that the body repeats itself. Nothing else holds or loads these edges or faces.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Periodic {
    /// The direction from one of them to the other.
    pub along: SpaceAxis,
    /// Whether the body can become longer or shorter in this direction, with the same strain everywhere: a body with open
    /// ends. Without, it has the same length: plane strain.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub stretches: bool,
    /// Force through the body along this direction where it stretches, tension positive: that of closed ends. Of a body of
    /// revolution that through the whole ring. It acts with `loads`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force: Option<f64>,
}
