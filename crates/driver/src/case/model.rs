//! Model and body of a case.

use super::{
    Axisymmetric, CentreCrackedPanel, CompactTension, Frame, Grading, MeshBody, Orthotropic, OutlineBody,
    Plane, PointsBody, PowerLaw, RectangleBody, Shell, SingleEdgeBend, StatePlane, Stiffness,
};
use peristat_assembly::material::{Section, ShearCorrection};
use peristat_assembly::model::timoshenko_beam::{Grid, VolumeFactor, bond_law, end_treatment};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

/// What the body is made of.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Model {
    /// Peridynamic Timoshenko beam: deflection, rotation and, where something moves along the axis, axial displacement.
    TimoshenkoBeam(Box<Beam>),
    /// Isotropic body in the plane of central bonds: displacements along x and y.
    BondPlane(Plane),
    /// Orthotropic body in the plane of beam bonds: displacements along x and y, and rotations.
    BeamBondOrthotropic(Orthotropic),
    /// Isotropic body in the plane of state-based families, any Poisson's ratio: displacements along x and y.
    StatePlane(StatePlane),
    /// Isotropic body of revolution of state-based families: displacements along the radius x and the axis y.
    Axisymmetric(Axisymmetric),
    /// Membrane of a cylindrical shell of central bonds: displacements along the axis, along the circumference and outwards.
    ShellMembrane(Shell),
}

impl Model {
    /// Its name in case files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::TimoshenkoBeam(_) => "timoshenko_beam",
            Self::BondPlane(_) => "bond_plane",
            Self::BeamBondOrthotropic(_) => "beam_bond_orthotropic",
            Self::StatePlane(_) => "state_plane",
            Self::Axisymmetric(_) => "axisymmetric",
            Self::ShellMembrane(_) => "shell_membrane",
        }
    }
}

/// A Timoshenko beam. What its sections are is said by `section`, `stiffness` or `power_law`, one of them.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Beam {
    /// Young's modulus E, > 0; with `section`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub youngs_modulus: Option<f64>,
    /// Poisson's ratio ν, between −1 and 1/2; G = E/(2(1 + ν)). Give this or `shear_modulus`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub poisson_ratio: Option<f64>,
    /// Shear modulus G, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shear_modulus: Option<f64>,
    /// Cross-section.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub section: Option<Section>,
    /// Cross-section at the end of every line, of the same shape; dimensions vary linearly from those of `section`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub end_section: Option<Section>,
    /// Stiffness of the sections by numbers, instead of moduli and `section`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stiffness: Option<Stiffness>,
    /// A functionally graded section, instead of `youngs_modulus` and `section`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub power_law: Option<PowerLaw>,
    /// Where the shear correction factor κ comes from; `classical` if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shear_correction: Option<ShearCorrection>,
    /// Shear stiffness of a bond, by name; `exact` if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "bond_laws")]
    pub bond_law: Option<String>,
    /// Volume of points at the edge of the horizon.
    #[serde(default)]
    pub volume_factor: VolumeFactor,
    /// What happens to the bonds that an end cuts off, by name; `cover` on nodes, `ghost` on cells if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "end_treatments")]
    pub end_treatment: Option<String>,
    /// How distributed loads reach the points; `lumped` with a foundation or without the end treatment `cover`, else
    /// `consistent`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub distributed_loads: Option<LoadSharing>,
}

fn one_of<'a>(names: impl Iterator<Item = &'a str>) -> Schema {
    let names: Vec<&str> = names.collect();
    json_schema!({ "type": "string", "enum": names })
}

fn bond_laws(_: &mut SchemaGenerator) -> Schema {
    one_of(bond_law::TABLE.iter().map(|l| l.name))
}

fn end_treatments(_: &mut SchemaGenerator) -> Schema {
    one_of(end_treatment::TABLE.iter().map(|t| t.name))
}

/// How a distributed load or a traction becomes forces on points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LoadSharing {
    /// By the bonds: on a beam with exact fixed-end forces, in the plane by a field of stress that is in equilibrium with it.
    Consistent,
    /// Every point takes what acts on its own length or cell.
    Lumped,
}

/// The region that points fill.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Body {
    /// One straight line along x.
    Line(Line),
    /// Several straight lines along x that do not overlap; only links join them.
    Lines(Vec<Line>),
    /// Straight members between joints in the plane of x and y.
    Frame(Frame),
    /// A rectangle in the plane.
    Rectangle(RectangleBody),
    /// A polygon in the plane.
    Outline(OutlineBody),
    /// Points in the plane that a file lists.
    Points(PointsBody),
    /// A mesh in the plane.
    Mesh(MeshBody),
    /// A compact tension specimen with its pins and its crack.
    CompactTension(CompactTension),
    /// A bend specimen with its rollers and its edge crack.
    SingleEdgeBend(SingleEdgeBend),
    /// A panel with a crack in its middle.
    CentreCrackedPanel(CentreCrackedPanel),
}

/// A straight line along x.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Line {
    /// Position of the left end.
    #[serde(default)]
    pub from: f64,
    /// Length, > 0.
    pub length: f64,
    /// Number of cells, >= 1.
    pub cells: usize,
    /// `nodes`: points on the ends and between cells; `cells`: points in the middle of cells.
    #[serde(default)]
    pub grid: Grid,
    /// Cells of different lengths; all the same if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub grading: Option<Grading>,
}

impl Body {
    /// The lines; frames and bodies in the plane have none.
    pub fn lines(&self) -> &[Line] {
        match self {
            Self::Line(line) => std::slice::from_ref(line),
            Self::Lines(lines) => lines,
            _ => &[],
        }
    }
}
