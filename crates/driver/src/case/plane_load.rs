//! Loads on bodies in the plane and on solids.

use super::{Amount, Amounts, Hertz, LoadSharing, Names, SpaceAxis, Vector};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Forces per area on an edge, or on a face of a solid. How they vary is said by `uniform`, `linear`, `parabolic`, `formula`, `pressure`,
/// `total` or `hertz`, one of them. An edge of a rectangle starts at its left or lower end, one of a polygon at the vertex that has its number.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Traction {
    /// Name of an edge or of a hole, or a list of several; `all` is the whole border, and `outer` is it without the holes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edge: Option<Names>,
    /// Name of a face of a solid, or of a cut.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub face: Option<String>,
    /// Force per area along x and y, and z where points move along it, the same everywhere.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uniform: Option<Vector>,
    /// Straight from the first value at the start of the edge to the second at its end; on a face from one side of the block to the
    /// other, `along` an axis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub linear: Option<[Vector; 2]>,
    /// This value in the middle of the edge, or of the block `along` an axis, zero at both ends, a parabola between.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub parabolic: Option<Vector>,
    /// The axis along which `linear` and `parabolic` vary on a face of a solid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub along: Option<SpaceAxis>,
    /// Force per area along x and y, and z where points move along it, by formulas of the position, such as `["10*y^2", 0]`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub formula: Option<Amounts>,
    /// Force per area against the edge, into the body: a number, or a formula such as `"9.81e-6*(200 - y)"`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pressure: Option<Amount>,
    /// Force along x and y, and z where points move along it, spread evenly over the edge.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub total: Option<Vector>,
    /// The pressure of a smooth round body on a straight edge, or on a flat face of a solid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hertz: Option<Hertz>,
    /// How deep a consistent traction reaches into the body before it has faded, > 0; two horizons if not given. Where the
    /// stress that it makes goes on smoothly, such as through the wall of a cylinder, deeper is more accurate. With it a
    /// pressure on a round hole or a slot is consistent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub depth: Option<f64>,
    /// How it reaches the points: `consistent` on straight edges along the lattice with the calibration `matched`, and on
    /// holes with a `depth`, else `lumped`, if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sharing: Option<LoadSharing>,
}

impl Traction {
    /// The key that names what it acts on, and that name.
    pub fn border(&self) -> Option<(&'static str, &str)> {
        let edge = self.edge.as_deref().map(|name| ("edge", name));
        edge.or(self.face.as_deref().map(|name| ("face", name)))
    }
}

/// A force on every point of a region; `density` or `total`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BodyForce {
    /// Name of the region; the whole body if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub region: Option<String>,
    /// Force per volume along x and y, and z where points move along it: numbers, or formulas such as `"-7.7e-5*(1 + y/100)"`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub density: Option<Amounts>,
    /// Force along x and y, and z where points move along it, shared by volume.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub total: Option<Vector>,
}
