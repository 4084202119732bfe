//! A case as its author wrote it: the JSON types, nothing resolved, nothing checked beyond their shape.

mod about_field;
mod amount;
mod body;
mod condition;
mod contact;
mod continuum;
mod crack;
mod drawing;
mod expectation;
mod facts;
mod field;
mod field_lists;
mod foundation;
mod fracture;
mod frame;
mod grading;
mod initial_strain;
mod library;
mod line_load;
mod load_factor;
mod mass_load;
mod modulus;
mod names;
mod overrides;
mod path;
mod periodic;
mod plane_body;
mod plane_load;
mod plane_output;
mod read;
mod refine;
mod region;
mod region_material;
mod solid_body;
mod specimen;
mod strengths;
mod temperature;
mod vector;
mod vertex;

pub use crate::model::{Critical, LoadSharing, Model, Pressure};
pub use crate::units::Units;
pub use about_field::{Field, Origin, PlateOrigin, Unit};
pub(crate) use amount::number;
pub use amount::{Amount, Amounts};
pub use body::{Body, Line};
pub use condition::{
    At, Combination, Distributed, DistributedForce, Inclined, Link, Load, LoadCase, PointLoad, RigidLink,
    Sign, Sine, Steps, Support,
};
pub use contact::{ContactCentre, Hertz};
pub use continuum::Continuum;
pub use crack::{CrackDisc, CrackFronts, GivenCrack};
pub use drawing::{Arrows, Drawing, PictureFormat, Signs};
pub use expectation::{Baseline, Check, ClosedForm, Formula, Limit, Probe, Reduction, Value};
pub use facts::{FRACTURE_FACTS, PATH_FACTS};
pub use field::FieldName;
pub use foundation::{BedStiffness, Foundation};
pub use fracture::{CrackDirection, Fracture, Strategy};
pub use frame::{AxialForce, Frame, Joint, Member, MemberEnd, Offsets};
pub use grading::Grading;
pub use initial_strain::InitialStrain;
pub use line_load::LineLoad;
pub(crate) use load_factor::LOAD_FACTOR;
pub use mass_load::{Gravity, Spin};
pub use modulus::{Modulus, Table};
pub use names::Names;
pub use path::{Path, PathControl, Turn};
pub use periodic::Periodic;
pub use peristat_assembly::material::Rolled;
pub use plane_body::{
    CircleHole, CrackName, EllipseHole, Hole, MeshBody, OutlineBody, PointsBody, PolygonHole, RectangleBody,
    SlotHole,
};
pub use plane_load::{BodyForce, Traction};
pub use plane_output::{LineOutput, StressIntensity, TipQuantity, Tips};
pub use read::{Source, from_text, read, read_text};
pub use refine::Overrides;
pub use region::{
    BallRegion, Bearing, BoxRegion, CylinderRegion, DiscRegion, EdgeRegion, FaceRegion, HalfPlaneRegion,
    HalfSpaceRegion, HoleRegion, Region, Rigid,
};
pub use region_material::RegionMaterial;
pub use solid_body::{BallCut, BlockBody, BlockCut, BoreCut, SolidBody, SolidCut, SpaceAxis};
pub use specimen::{CentreCrackedPanel, CompactTension, SingleEdgeBend};
pub use strengths::Strengths;
pub use temperature::{Expansion, Temperature};
pub use vector::Vector;
pub use vertex::{ArcTo, Vertex};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A problem for peristat. Lengths, forces and stresses are in the units that `units` names.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// Location of the JSON Schema, for editors; ignored.
    #[serde(rename = "$schema", default, skip_serializing_if = "Option::is_none")]
    pub schema: Option<String>,
    /// What the case is, in a few words.
    pub title: String,
    /// One or two sentences on what it shows.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub about: Option<String>,
    /// The consistent units of all numbers. They label axes and feed plausibility warnings; nothing is converted.
    #[serde(default)]
    pub units: Units,
    /// Path of a file of materials and profiles by name, relative to the case, which `material` and `rolled` then name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub library: Option<String>,
    /// Name of the material in the `library`: moduli of `model`, `density` and `thermal_expansion`, where the case gives none itself.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub material: Option<String>,
    /// What the body is made of: a beam, a plate or a shell, with its material.
    pub model: Model,
    /// Mass per volume of the material, > 0, for `gravity` and `spin`: kg/m³ in `m-N-Pa`, t/mm³ in `mm-N-MPa`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub density: Option<f64>,
    /// Strain of the material per kelvin, for `temperature`; with fibres `[along, across]` them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub thermal_expansion: Option<Expansion>,
    /// Strengths of the material, for fields such as `utilisation` on bodies in the plane and solids.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strengths: Option<Strengths>,
    /// Geometry and discretisation.
    pub body: Body,
    /// Horizon over spacing, δ/h, >= 1; on a graded grid the number of neighbours on each side; of listed points the
    /// spacing is the root of their mean area, in space the cube root of their mean volume. Give this or `horizon`; without both it is 3; 2 on solids of cells, and without cracks, `fracture` and `path` on
    /// lattices of `bond_plane` with edges that are completed and of `state_plane` with the usual edges and one material; 3.2 where no beam bond lies on the fibres.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub horizon_ratio: Option<f64>,
    /// Horizon δ, a length; not on a graded grid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub horizon: Option<f64>,
    /// Sides of a body in the plane that are lines of symmetry: `left`, `right`, `bottom`, `top`. The body is the part on one
    /// side of them, and nothing else holds or loads these edges.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub symmetry: Vec<String>,
    /// Pairs of opposite sides of a body that are joined: behind one of them the body goes on at the other.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub periodic: Vec<Periodic>,
    /// Cracks of a body: lines in the plane, surfaces in a solid.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub cracks: Vec<GivenCrack>,
    /// Which bonds cracks cut next to their ends; `effective` if not given, and `crossed` where bonds break or soften.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub crack_fronts: Option<CrackFronts>,
    /// Regions of a body in the plane by name. Edges, named holes and groups of a mesh are regions of their own.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub regions: BTreeMap<String, Region>,
    /// Materials of regions, or of members of a frame, by name, and thicknesses of regions of a plate in bending; everything else is of
    /// the material of `model`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub materials: BTreeMap<String, RegionMaterial>,
    /// What holds the body.
    #[serde(default)]
    pub supports: Vec<Support>,
    /// Regions of a body that move as rigid bodies.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub rigid: Vec<Rigid>,
    /// Winkler foundations under a beam.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub foundation: Vec<Foundation>,
    /// What joins points of a beam.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub links: Vec<Link>,
    /// The loads, where there is one load case.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub loads: Vec<Load>,
    /// Several load cases, instead of `loads`, solved with one factorisation.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub load_cases: Vec<LoadCase>,
    /// Sums of load cases with factors; prescribed motions of supports count once.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub combinations: Vec<Combination>,
    /// Load steps, where `loads` and prescribed motions grow together.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub steps: Option<Steps>,
    /// How the body breaks under `loads` and prescribed motions that grow, instead of `steps`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fracture: Option<Fracture>,
    /// How a body of bonds that soften is followed, instead of `steps`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub path: Option<Path>,
    /// How to solve; `auto` says what it took and why.
    #[serde(default)]
    pub solver: Solver,
    /// Whose solution the results of a body in the plane are; `nonlocal` if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub limit: Option<Continuum>,
    /// How many corrections at most lead to the limit `local`, 0 to 4; 2 if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub corrections: Option<usize>,
    /// Values to report.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub probes: Vec<Probe>,
    /// Lines through a body in the plane along which all fields are written.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub lines: Vec<LineOutput>,
    /// Stress intensities of cracks.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub stress_intensity: Vec<StressIntensity>,
    /// How diagrams and maps are drawn.
    #[serde(default, skip_serializing_if = "Drawing::is_usual")]
    pub drawing: Drawing,
    /// What the results must be.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub checks: Vec<Check>,
    /// Left out by `peristat verify` unless it is asked for all.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub slow: bool,
}

impl Case {
    /// The files that the case names, relative to its folder.
    pub fn files_mut(&mut self) -> Vec<&mut String> {
        let baselines = self.checks.iter_mut().filter_map(|check| match check {
            Check::Baseline(baseline) => Some(&mut baseline.file),
            _ => None,
        });
        let body = match &mut self.body {
            Body::Points(body) => Some(&mut body.file),
            Body::Mesh(body) => Some(&mut body.file),
            Body::Solid(body) => Some(&mut body.file),
            Body::Outline(body) => body.file.as_mut(),
            _ => None,
        };
        let surfaces = self.cracks.iter_mut().filter_map(|crack| crack.file.as_mut());
        let moduli = self
            .materials
            .values_mut()
            .flat_map(|m| [&mut m.youngs_modulus, &mut m.shear_modulus, &mut m.stiffness_factor]);
        let tables = moduli.filter_map(|modulus| match modulus {
            Some(Modulus::Table(table)) => Some(&mut table.file),
            _ => None,
        });
        baselines.chain(body).chain(surfaces).chain(tables).chain(self.library.as_mut()).collect()
    }

    /// Whether displacements are to be corrected until they are those of local elasticity.
    pub fn is_corrected(&self) -> bool {
        self.limit == Some(Continuum::Local)
    }

    /// Whether the body breaks or softens: its states are found one after the other, and it is not known how many there are.
    pub fn is_traced(&self) -> bool {
        self.fracture.is_some() || self.path.is_some()
    }
}

/// The linear solver.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Solver {
    /// For beams the strain form where it applies, else a factor that suits the pattern of the stiffness; for bodies in
    /// the plane multigrid, a factor or `pcg`, by their size and the number of load cases.
    #[default]
    Auto,
    /// Strain form: well conditioned whatever the slenderness; straight beams with few supports.
    Strain,
    /// Band Cholesky factor and conjugate gradients on the bonds; beams.
    Band,
    /// Sparse Cholesky factor and conjugate gradients on the bonds.
    Sparse,
    /// Conjugate gradients on the bonds, preconditioned by coarser lattices; bodies in the plane that fill a lattice.
    Multigrid,
    /// Conjugate gradients on the bonds, preconditioned by the blocks of the points; bodies in the plane.
    Pcg,
}
