//! Supports, links and loads of a case.

use super::{
    Amount, BodyForce, Gravity, InitialStrain, LineLoad, Names, Pressure, Spin, Temperature, Traction,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A place: `{ "x": … }` on a line, `{ "joint": … }` or `{ "member": …, "x": … }` on a frame, `{ "x": …, "y": … }` or
/// `{ "region": … }` in the plane, with a `z` in a solid.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct At {
    /// Position along the beam, or in the plane; on a member its distance from the joint `from`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub x: Option<f64>,
    /// Position in the plane.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub y: Option<f64>,
    /// Position in a solid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub z: Option<f64>,
    /// Name of a region, of an edge, a hole or a group of a mesh in the plane, or of a face of a solid; or a list of several. In the
    /// plane `all` is the whole border, and `outer` is it without the holes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub region: Option<Names>,
    /// For a probe on an edge in the plane: direction into the body, [±1, 0] or [0, ±1], along which the field is
    /// extrapolated to the place from three points, one, two and three horizons behind the outermost one, or next to each
    /// other where the border is completed as it runs. Displacements of such a border are read on it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inward: Option<[i8; 2]>,
    /// For a probe: name of a straight edge along the rows of a lattice, or of a flat face of a solid. It reads the mean on the edge itself,
    /// along every row extrapolated as by `inward`, where `region` reads that of the points half a spacing inside.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edge: Option<String>,
    /// Name of a joint.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub joint: Option<String>,
    /// Name of a member.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub member: Option<String>,
}

impl At {
    /// Whether it names no place at all.
    pub fn is_nowhere(&self) -> bool {
        *self == Self::default()
    }
}

/// What holds a point or the points of a region: prescribed values, springs to the ground, or one of each. On bodies values can be
/// formulas of the position, such as `"1e-3*y"`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Support {
    /// Where; a point of the grid, the end of a line, or a joint; in the plane a region or a point. A straight edge along
    /// the lattice is held on its line, with forces that reach its points as a uniform traction does; of other regions the points are.
    pub at: At,
    /// Prescribed deflection of a line or a plate in bending, or displacement of a shell outwards.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub w: Option<Amount>,
    /// Prescribed displacement along x.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ux: Option<Amount>,
    /// Prescribed displacement along y, on a frame or in the plane.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uy: Option<Amount>,
    /// Prescribed displacement along z, of a solid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uz: Option<Amount>,
    /// Prescribed rotation, rad; in the plane where points turn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phi: Option<Amount>,
    /// Prescribed rotation of a plate in bending that is the slope of w along x where shear is rigid, rad.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phi_x: Option<Amount>,
    /// The same along y.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phi_y: Option<Amount>,
    /// The same along the outward normal of an edge of a plate: `w` and `phi_n` clamp it together with `phi_t`, `phi_n` alone guides it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phi_n: Option<Amount>,
    /// The same along an edge of a plate, counter-clockwise around the body: `w` and `phi_t` are a hard simple support, `w` alone is a soft one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phi_t: Option<Amount>,
    /// Prescribed displacement in one direction that is neither x nor y, on a frame or in the plane.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inclined: Option<Inclined>,
    /// Stiffness of a spring against deflection of a line, or of a plate in bending, force per length, > 0; all points of a region share it,
    /// those of an edge or a line of a plate by their lengths.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub w_spring: Option<f64>,
    /// Stiffness of a spring against displacement along x, force per length, > 0; all points of a region share it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ux_spring: Option<f64>,
    /// Stiffness of a spring against displacement along y, on a frame or in the plane, force per length, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uy_spring: Option<f64>,
    /// Stiffness of a spring against displacement along z, of a solid, force per length, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uz_spring: Option<f64>,
    /// Stiffness of a spring against rotation, moment per radian, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phi_spring: Option<f64>,
    /// Stiffness of a spring against the rotation across an edge of a plate in bending, moment per length of the edge and radian, > 0:
    /// what a wall or a beam there resists.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phi_n_spring: Option<f64>,
    /// The only sign that the reaction can have, on beams and frames: a bearing beneath a beam pushes `positive`, and the beam lifts
    /// off it; a stop that it moves towards pushes `negative`. The support then holds one motion.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub only: Option<Sign>,
    /// How far the prescribed motion may be passed before the support acts, >= 0; with `only`. Load factors do not change it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gap: Option<f64>,
}

/// A sign of forces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Sign {
    /// Along the axis that a displacement or a rotation is counted along.
    Positive,
    /// Against it.
    Negative,
}

impl Sign {
    /// 1 or −1.
    pub fn factor(self) -> f64 {
        match self {
            Self::Positive => 1.0,
            Self::Negative => -1.0,
        }
    }
}

/// A roller on an inclined plane: it holds the displacement normal to that plane.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Inclined {
    /// Direction that is held, counter-clockwise from x, degrees.
    pub degrees: f64,
    /// Prescribed displacement in this direction.
    #[serde(default)]
    pub displacement: f64,
}

/// A relation between two points.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Link {
    /// A rigid bar: the second point moves as if it were part of the first.
    Rigid(RigidLink),
}

/// A rigid bar between two points.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RigidLink {
    /// One end.
    pub from: At,
    /// The other end.
    pub to: At,
}

/// A load.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Load {
    /// A concentrated force and moment.
    Point(PointLoad),
    /// A force or moment per length of a beam.
    Distributed(Distributed),
    /// A force per area on an edge in the plane.
    Traction(Traction),
    /// A force on the points of a region in the plane.
    BodyForce(BodyForce),
    /// The weight of the body.
    Gravity(Gravity),
    /// The inertia of a body that turns about an axis.
    Spin(Spin),
    /// A pressure on a shell, or on a plate in bending.
    Pressure(Pressure),
    /// A force or moment per length along a line on a plate in bending.
    Line(LineLoad),
    /// A change of temperature.
    Temperature(Temperature),
    /// A strain that a line, a member or a region of a body has from the beginning.
    InitialStrain(InitialStrain),
}

/// A concentrated force and moment.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointLoad {
    /// Where.
    pub at: At,
    /// Force along w, across a line or member, or a plate in bending; outwards on a shell.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub force: f64,
    /// Force along a line or member, in the direction in which its position grows.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub axial: f64,
    /// Force along x, on a frame or in the plane, where the points of a region share it.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub force_x: f64,
    /// Force along y, on a frame or in the plane.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub force_y: f64,
    /// Force along z, in a solid.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub force_z: f64,
    /// Moment along phi; in the plane where points turn, and the points of a region share it.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub moment: f64,
    /// Moment about x, on a rigid region of a solid; on a plate in bending the one that turns phi_x.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub moment_x: f64,
    /// Moment about y, on a rigid region of a solid; on a plate in bending the one that turns phi_y.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub moment_y: f64,
    /// Moment about z, on a rigid region of a solid.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub moment_z: f64,
    /// Shared by the bonds that span it. Otherwise the chain is split at the load, which needs a point there; a load
    /// between points is always shared.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub spread: bool,
}

fn is_zero(value: &f64) -> bool {
    *value == 0.0
}

/// A load spread over a part of a line or member; forces per length of it, whatever its direction.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Distributed {
    /// Member of a frame.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub member: Option<String>,
    /// Start; the left end of the body, or the joint `from` of the member, if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from: Option<f64>,
    /// End; the right end of the body, or the joint `to` of the member, if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub to: Option<f64>,
    /// Force per length along w.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force: Option<DistributedForce>,
    /// Force per length along the line or member, in the direction in which its position grows.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axial: Option<DistributedForce>,
    /// Force per length along x, on a frame.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force_x: Option<DistributedForce>,
    /// Force per length along y, on a frame.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force_y: Option<DistributedForce>,
    /// Moment per length along phi (b̃ of Eq. (12a) times the area).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moment: Option<DistributedForce>,
}

/// How a distributed load varies.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum DistributedForce {
    /// The same everywhere.
    Uniform(f64),
    /// Straight from the first value at the start to the second at the end.
    Linear([f64; 2]),
    /// A sine wave over the loaded length.
    Sine(Sine),
    /// A formula of the position x, on a member the distance from its joint `from`, and of `load_factor` where there are steps; parabolas through its values at 513 places of
    /// the loaded length act.
    Formula(String),
}

/// A sine wave.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sine {
    /// Largest value.
    pub amplitude: f64,
    /// Half waves over the loaded length, >= 1.
    #[serde(default = "one")]
    pub half_waves: u32,
}

fn one() -> u32 {
    1
}

/// A named set of loads.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LoadCase {
    /// Name, unique among load cases and combinations.
    pub name: String,
    /// Its loads.
    #[serde(default)]
    pub loads: Vec<Load>,
}

/// A sum of load cases.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Combination {
    /// Name, unique among load cases and combinations.
    pub name: String,
    /// Factor per load case; others do not act.
    pub factors: BTreeMap<String, f64>,
}

/// Load steps.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Steps {
    /// Factor on all loads and prescribed motions, one per step; those whose formulas know it, as `load_factor`, have the value of
    /// these.
    pub load_factors: Vec<f64>,
}
