//! How loads reach points.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How a distributed load or a traction becomes forces on points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LoadSharing {
    /// By the bonds: on a beam with exact fixed-end forces, in the plane by a field of stress that is in equilibrium with it.
    Consistent,
    /// Every point takes what acts on its own length or cell.
    Lumped,
}
