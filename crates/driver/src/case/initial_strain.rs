//! Strains without stress that members have from the beginning.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A strain or a curvature that a line or member would have if nothing held it: prestress, or a member that does not fit between its
/// joints. Give one of `strain`, `length` and `force`, or `curvature`, or both.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct InitialStrain {
    /// Member of a frame.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub member: Option<String>,
    /// Strain of the axis, positive where it would be longer.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strain: Option<f64>,
    /// By how much it is made longer than the distance of its ends; one that is too short has a negative one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub length: Option<f64>,
    /// Axial force that it has as long as its ends are held, such as that of a tendon: N > 0 is tension.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force: Option<f64>,
    /// Curvature, the derivative of phi along it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub curvature: Option<f64>,
}
