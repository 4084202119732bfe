//! Loads that act on mass: weight and the inertia of turning.

use super::{SpaceAxis, Vector};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The weight of a body of some `density`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Gravity {
    /// Direction in which things fall, of any length, along x and y, and z where points move along it. On a line x runs along it
    /// and y is that of w.
    pub along: Vector,
    /// Acceleration, > 0; that of the earth, 9.80665 m/s² in the units of the case, if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub acceleration: Option<f64>,
    /// Name of the region that is heavy; the whole body if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub region: Option<String>,
}

/// The inertia of a body of some `density` that turns steadily about an axis: a force per volume outwards, density times ω² times the
/// distance from the axis. Give `omega` or `rpm`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Spin {
    /// Angular velocity ω, radians per second.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub omega: Option<f64>,
    /// Revolutions per minute.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rpm: Option<f64>,
    /// Position of the axis: x and y in the plane, x, y and z of a point on it in a solid. A body of revolution turns about its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub about: Option<Vector>,
    /// Direction of the axis, of a solid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis: Option<SpaceAxis>,
    /// Name of the region that has mass; the whole body if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub region: Option<String>,
}
