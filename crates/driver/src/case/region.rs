//! Named regions of bodies, and what moves as a rigid body.

use super::{Amount, Names, Vector};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Points of a body. Borders belong to a region.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Region {
    /// Points beside a straight edge.
    Edge(EdgeRegion),
    /// Points beside a face of a solid.
    Face(FaceRegion),
    /// The point nearest to a position; several where they are equally near.
    Corner(Vector),
    /// Points in a box.
    Box(BoxRegion),
    /// Points in a disc.
    Disc(DiscRegion),
    /// Points in a ball, of a solid.
    Ball(BallRegion),
    /// Points in a cylinder, of a solid.
    Cylinder(CylinderRegion),
    /// Points on one side of a line.
    HalfPlane(HalfPlaneRegion),
    /// Points of a solid on one side of a plane.
    HalfSpace(HalfSpaceRegion),
    /// Points around a hole.
    Hole(HoleRegion),
    /// Points of a group of the mesh.
    Group(String),
    /// Points of any of several regions.
    Union(Vec<String>),
}

/// Points beside a straight edge.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EdgeRegion {
    /// Name of the edge, or a list of several; `all` is the whole border, and `outer` is it without the holes.
    pub name: Names,
    /// How far inwards; one spacing, the outermost points, if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub depth: Option<f64>,
}

/// Points beside a face of a solid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FaceRegion {
    /// Name of the face.
    pub name: String,
    /// How far inwards; one spacing, the outermost points, if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub depth: Option<f64>,
}

/// Points in a ball.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BallRegion {
    /// Its middle.
    pub centre: [f64; 3],
    /// Its radius, > 0.
    pub radius: f64,
}

/// Points in a cylinder with flat ends.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CylinderRegion {
    /// Middle of one end.
    pub from: [f64; 3],
    /// Middle of the other.
    pub to: [f64; 3],
    /// Its radius, > 0.
    pub radius: f64,
}

/// Points of a solid on one side of a plane.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HalfSpaceRegion {
    /// A position on the plane.
    pub point: [f64; 3],
    /// Direction from the plane into the region, of any length.
    pub normal: [f64; 3],
}

/// Points in a box.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoxRegion {
    /// One corner.
    pub from: Vector,
    /// The opposite corner.
    pub to: Vector,
}

/// Points in a disc.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DiscRegion {
    /// Its middle.
    pub centre: [f64; 2],
    /// Its radius, > 0.
    pub radius: f64,
}

/// Points on one side of a line.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HalfPlaneRegion {
    /// A position on the line.
    pub point: [f64; 2],
    /// Direction from the line into the region, of any length.
    pub normal: [f64; 2],
}

/// Points around a hole.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HoleRegion {
    /// Name of the hole.
    pub name: String,
    /// How far from its border; one spacing if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub depth: Option<f64>,
}

/// A region that moves as a rigid body. What is not prescribed is free: with `ux` and `uy` alone it is a pin that turns, in a
/// solid with `ux`, `uy` and `uz` a ball joint.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rigid {
    /// Name of the region; it cannot share points with another rigid one.
    pub region: String,
    /// What its rotation is about and its displacements are of; the centroid of its points if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub centre: Option<Vector>,
    /// Prescribed displacement of the centre along x; it and all others may be formulas of `load_factor`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ux: Option<Amount>,
    /// Prescribed displacement of the centre along y.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uy: Option<Amount>,
    /// Prescribed displacement of the centre along z, of a solid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uz: Option<Amount>,
    /// Prescribed rotation in the plane, rad.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phi: Option<Amount>,
    /// Prescribed rotation about x, of a solid, rad.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phi_x: Option<Amount>,
    /// Prescribed rotation about y, of a solid, rad.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phi_y: Option<Amount>,
    /// Prescribed rotation about z, of a solid, rad.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phi_z: Option<Amount>,
    /// Where it bears on the rest of the body, like a pin in its hole; everywhere if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bearing: Option<Bearing>,
}

/// Which bonds join a rigid region to the rest: those to points that its centre sees at less than `half_angle` from
/// `direction`. The others are cut, and count as no damage.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bearing {
    /// Direction in which the region presses, of any length.
    pub direction: [f64; 2],
    /// Largest angle from it, degrees, > 0; 180 is all around.
    pub half_angle: f64,
}
