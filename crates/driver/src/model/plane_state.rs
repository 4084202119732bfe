//! Plane stress and plane strain.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Plane stress or plane strain: what is zero across the plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PlaneState {
    /// No stress across the plane: thin plates. Central bonds have ν = 1/3 then.
    PlaneStress,
    /// No strain across the plane: thick bodies. Central bonds have ν = 1/4 then.
    PlaneStrain,
}
