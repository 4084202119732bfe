//! What the record of a run says of bodies in the plane.

use super::{Extremes, Forces, Located, StateSummary};
use crate::run::plane::{MirrorReaction, PlaneReaction, PlaneResult, checks, probes};
use crate::run::{CheckResult, ProbeResult, scan};
use crate::scene::plane::{PlaneBonds, PlaneScene};
use peristat_assembly::body::PlaneBody;
use peristat_assembly::model::beam_bond_orthotropic::{BeamNeighbourhood, Start};
use peristat_assembly::model::bond_plane::{Influence, PlaneState, VolumeFactor};
use peristat_assembly::model::plane::{Calibration, Edges};
use peristat_assembly::model::shell_membrane::ShellKinematics;
use peristat_assembly::model::state_based::{
    Axis, Dilatation, Geometry, Measure, StateEdges, StateParameters,
};
use serde::{Deserialize, Serialize};

/// Forces of what holds a body in the plane.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlaneForces {
    /// Forces of supports and rigid regions on the body, in the order of the case.
    pub reactions: Vec<PlaneReaction>,
    /// Forces across lines of symmetry.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub mirrors: Vec<MirrorReaction>,
}

/// The body that was solved.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlaneSummary {
    /// Name of the model.
    pub name: &'static str,
    /// What it is made of.
    #[serde(flatten)]
    pub material: PlaneMaterialSummary,
    /// Thickness.
    pub thickness: f64,
    /// Where the stiffness of bonds comes from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub calibration: Option<Calibration>,
    /// What is done about the bonds that points near edges lack.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub edges: Option<Edges>,
    /// Horizon over spacing.
    pub horizon_ratio: f64,
    /// Side of a cell, or root of the mean area of listed points.
    pub spacing: f64,
    /// Whether the points fill a lattice.
    pub lattice: bool,
    /// Points that are images behind lines of symmetry and joined sides.
    #[serde(skip_serializing_if = "is_zero")]
    pub images: usize,
    /// Cracks.
    #[serde(skip_serializing_if = "is_zero")]
    pub cracks: usize,
    /// Bonds of a lattice that cracks cut.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cut_bonds: Option<usize>,
    /// Overlay triangles near edges.
    pub triangles: usize,
    /// Triangles that have the parts of blocks that a border leaves, where it is completed as it runs.
    #[serde(skip_serializing_if = "is_zero")]
    pub cut_triangles: usize,
    /// Springs that have them in a body that breaks or softens.
    #[serde(skip_serializing_if = "is_zero")]
    pub cut_springs: usize,
    /// Points that lack bonds for which there is no triangle.
    pub uncorrected_points: usize,
}

/// Material and bonds of a body.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum PlaneMaterialSummary {
    /// Isotropic, of central bonds.
    Central {
        /// `plane_stress` or `plane_strain`.
        state: &'static str,
        /// Young's modulus.
        youngs_modulus: f64,
        /// Poisson's ratio.
        poisson_ratio: f64,
        /// Stiffness of bonds over their length.
        influence: Influence,
        /// Volume of points at the edge of the horizon, with the calibration `published`.
        #[serde(skip_serializing_if = "Option::is_none")]
        volume_factor: Option<VolumeFactor>,
    },
    /// Orthotropic, of beam bonds.
    Beams(OrthotropicSummary),
    /// Isotropic, of state-based families.
    State(FamilySummary),
    /// Isotropic, of a developed cylinder.
    Shell {
        /// Young's modulus.
        youngs_modulus: f64,
        /// Poisson's ratio.
        poisson_ratio: f64,
        /// Radius of the middle surface.
        radius: f64,
        /// Elongations of bonds.
        kinematics: ShellKinematics,
        /// Whether rows of bending resist changes of curvature.
        bending: bool,
    },
}

/// An isotropic material and its families.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FamilySummary {
    /// `plane_stress`, `plane_strain` or `axisymmetric`.
    pub state: &'static str,
    /// Young's modulus.
    pub youngs_modulus: f64,
    /// Poisson's ratio.
    pub poisson_ratio: f64,
    /// Weight of neighbours over their distance.
    pub influence: Influence,
    /// What is done about the neighbours that points near edges lack.
    #[serde(rename = "edges")]
    pub families_at_edges: StateEdges,
    /// What neighbours count by.
    pub measure: Measure,
    /// What points next to the axis have, where the body touches it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axis: Option<Axis>,
    /// How changes of volume are measured.
    pub dilatation: Dilatation,
    /// Points outside that complete families.
    pub ghosts: usize,
    /// Whether points feel more than their bonds: not where λ = μ.
    pub families: bool,
}

/// An orthotropic material and its bonds.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OrthotropicSummary {
    /// Young's modulus along the fibres.
    pub youngs_modulus_1: f64,
    /// Young's modulus across them.
    pub youngs_modulus_2: f64,
    /// Poisson's ratio ν12.
    pub poisson_ratio_12: f64,
    /// Shear modulus G12 of the material.
    pub shear_modulus_12: f64,
    /// Shear modulus G12 that a body of these bonds has.
    pub effective_shear_modulus_12: f64,
    /// Whether strain and rotation are not coupled, so that a body has the moduli of its bonds.
    pub consistent: bool,
    /// Angle of the fibres from x, degrees.
    pub fibre_angle: f64,
    /// Angle of the rows of the lattice from x, degrees.
    pub lattice_angle: f64,
    /// From where the calibration `matched` has found the bonds.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub start: Option<Start>,
}

fn is_zero(number: &usize) -> bool {
    *number == 0
}

/// What the summary needs of a state.
pub(super) fn state(
    scene: &PlaneScene,
    result: &PlaneResult,
) -> (StateSummary, Vec<ProbeResult>, Vec<CheckResult>) {
    let extremes = result.fields().filter_map(|field| {
        let values = result.values(scene, field)?;
        let located = scan::extremes(&values)?.map(|point| {
            let [x, y] = scene.body().position(point);
            Located { value: values[point], x, y: Some(y), member: None }
        });
        let [smallest, largest] = located;
        Some((field.name().into(), Extremes { smallest, largest }))
    });
    let state = StateSummary {
        name: result.record.name.clone(),
        load_factor: result.record.load_factor,
        extremes: extremes.collect(),
        forces: Forces::Plane(PlaneForces {
            reactions: result.reactions.clone(),
            mirrors: result.mirrors.clone(),
        }),
        certificate: result.record.certificate.clone(),
    };
    (state, probes(scene, result), checks(scene, result))
}

/// The model of a body and its derived numbers.
pub(super) fn model(scene: &PlaneScene) -> PlaneSummary {
    let bonds = scene.bonds();
    let breaks = scene.fracture.is_some() || scene.path.is_some();
    let on_border = if scene.model.follows_border() { scene.model.completing() } else { 0 };
    PlaneSummary {
        name: bonds.name(),
        material: material(scene),
        thickness: bonds.thickness(),
        calibration: (!bonds.has_families()).then(|| bonds.calibration()),
        edges: scene.model.edges(),
        horizon_ratio: scene.horizon() / scene.spacing(),
        spacing: scene.spacing(),
        lattice: scene.model.lattice().is_some(),
        images: scene.images().count(),
        cracks: scene.cracks.len(),
        cut_bonds: cut_bonds(scene),
        triangles: scene.model.triangles(),
        cut_triangles: if breaks { 0 } else { on_border },
        cut_springs: if breaks { on_border } else { 0 },
        uncorrected_points: scene.model.uncorrected(),
    }
}

/// Material and bonds.
fn material(scene: &PlaneScene) -> PlaneMaterialSummary {
    match scene.bonds() {
        PlaneBonds::State(parameters) => PlaneMaterialSummary::State(state_based(parameters, scene)),
        PlaneBonds::Central(parameters) => {
            let material = parameters.material;
            let published = parameters.calibration == Calibration::Published;
            PlaneMaterialSummary::Central {
                state: match material.state {
                    PlaneState::Stress => "plane_stress",
                    PlaneState::Strain => "plane_strain",
                },
                youngs_modulus: material.youngs_modulus,
                poisson_ratio: material.state.poisson_ratio(),
                influence: parameters.influence,
                volume_factor: published.then_some(parameters.volume_factor),
            }
        }
        PlaneBonds::Beams(parameters) => {
            // The bonds of a scene exist.
            let hood = BeamNeighbourhood::new(parameters).ok();
            let material = parameters.material;
            PlaneMaterialSummary::Beams(OrthotropicSummary {
                youngs_modulus_1: material.youngs_modulus_1,
                youngs_modulus_2: material.youngs_modulus_2,
                poisson_ratio_12: material.poisson_ratio_12,
                shear_modulus_12: material.shear_modulus_12,
                effective_shear_modulus_12: hood.as_ref().map_or(f64::NAN, |h| h.effective_shear_modulus()),
                consistent: hood.as_ref().is_some_and(BeamNeighbourhood::is_consistent),
                fibre_angle: parameters.fibre_angle.to_degrees(),
                lattice_angle: parameters.lattice_angle.to_degrees(),
                start: hood.and_then(|h| h.start()),
            })
        }
        PlaneBonds::Shell(parameters) => PlaneMaterialSummary::Shell {
            youngs_modulus: parameters.youngs_modulus,
            poisson_ratio: 1.0 / 3.0,
            radius: parameters.radius,
            kinematics: parameters.kinematics,
            bending: parameters.bending,
        },
    }
}

fn state_based(parameters: &StateParameters, scene: &PlaneScene) -> FamilySummary {
    let touches = scene.model.lattice().is_some_and(|(_, mirrors)| mirrors.columns[0].is_some());
    FamilySummary {
        state: match parameters.geometry {
            Geometry::PlaneStress(_) => "plane_stress",
            Geometry::PlaneStrain(_) => "plane_strain",
            Geometry::Axisymmetric => "axisymmetric",
        },
        youngs_modulus: parameters.youngs_modulus,
        poisson_ratio: parameters.poisson_ratio,
        influence: parameters.influence,
        families_at_edges: parameters.edges,
        measure: parameters.measure,
        axis: (parameters.is_axisymmetric() && touches && parameters.edges != StateEdges::Border)
            .then_some(parameters.axis),
        dilatation: parameters.dilatation,
        ghosts: scene.model.ghosts().len() - scene.images().count(),
        families: parameters.has_families(),
    }
}

/// Number of bonds that cracks cut on a lattice, those of images left out.
fn cut_bonds(scene: &PlaneScene) -> Option<usize> {
    let PlaneBody::Lattice(lattice) = scene.body() else { return None };
    if scene.cracks.is_empty() {
        return None;
    }
    let reach = scene.bonds().horizon_ratio() + scene.bonds().partial_neighbours() + 1e-9;
    let mut offsets = scene.bonds().offsets().ok()?;
    offsets.retain(|[i, j]| f64::from(*i).hypot(f64::from(*j)) <= reach);
    Some(scene.cuts(lattice, &offsets).len())
}
