//! What the record of a run says of bodies.

use super::{Extremes, Forces, Located, StateSummary};
use crate::case::FieldName;
use crate::model::{MaterialSummary, OtherMaterial, Surface};
use crate::run::body::{BodyReaction, BodyResult, MirrorReaction, checks, probes};
use crate::run::{CheckResult, Corrections, ProbeResult, scan};
use crate::scene::body::BodyScene;
use peristat_assembly::model::plane::{Calibration, CriticalStretch, Edges};
use serde::{Deserialize, Serialize};

/// Forces of what holds a body in the plane.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BodyForces {
    /// Forces of supports and rigid regions on the body, in the order of the case.
    pub reactions: Vec<BodyReaction>,
    /// Forces across lines of symmetry.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub mirrors: Vec<MirrorReaction>,
    /// How displacements were corrected until they are those of local elasticity.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub corrections: Option<Corrections>,
}

/// The body that was solved.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BodySummary {
    /// Name of the model.
    pub name: &'static str,
    /// What it is made of.
    #[serde(flatten)]
    pub material: MaterialSummary,
    /// Materials of regions.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub materials: Vec<RegionSummary>,
    /// Thickness; solids have none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub thickness: Option<f64>,
    /// Whether it is a solid.
    #[serde(skip)]
    pub is_solid: bool,
    /// Where the stiffness of bonds comes from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub calibration: Option<Calibration>,
    /// What is done about the bonds that points near edges lack.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub edges: Option<Edges>,
    /// Horizon over spacing.
    pub horizon_ratio: f64,
    /// Side of a cell, or root of the mean area of listed points, in space of their mean volume.
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
    /// Triangles near edges, or points near faces with tetrahedra, of the overlay.
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

/// A material of regions.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RegionSummary {
    /// Its name.
    pub name: String,
    /// Its number in the field `material`.
    pub number: u32,
    /// Points that are of it.
    pub points: usize,
    /// Young's modulus, where it has its own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub youngs_modulus: Option<ValueSummary>,
    /// Poisson's ratio, where it has its own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub poisson_ratio: Option<f64>,
    /// Shear modulus, where it has its own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shear_modulus: Option<ValueSummary>,
    /// Factor on all moduli, where it has its own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stiffness_factor: Option<ValueSummary>,
    /// Angle of its fibres from x, degrees, where it has its own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fibre_angle: Option<f64>,
    /// Critical stretch of its bonds, where they break.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub critical_stretch: Option<ValueSummary>,
    /// That of the bonds between it and the base material, where there is some of that.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub interface_stretch: Option<ValueSummary>,
}

/// What the points of a material have.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum ValueSummary {
    /// Of all of them.
    One(f64),
    /// The least and the greatest one.
    Between([f64; 2]),
}

impl From<[f64; 2]> for ValueSummary {
    fn from([least, greatest]: [f64; 2]) -> Self {
        if least == greatest { Self::One(least) } else { Self::Between([least, greatest]) }
    }
}

fn is_zero(number: &usize) -> bool {
    *number == 0
}

/// What the summary needs of a state.
pub(super) fn state(
    scene: &BodyScene,
    result: &BodyResult,
) -> (StateSummary, Vec<ProbeResult>, Vec<CheckResult>) {
    let is_number = |field: &FieldName| *field != FieldName::Material;
    let extremes = result.fields().filter(is_number).filter_map(|field| {
        let values = result.values(scene, field)?;
        let located = scan::extremes(&values)?.map(|point| {
            let [x, y, z] = scene.body().position(point);
            let z = (scene.body().axes() == 3).then_some(z);
            Located { value: values[point], x, y: Some(y), z, member: None }
        });
        let [smallest, largest] = located;
        let unit = field.about().unit.label(scene.units).into();
        Some((field.name().into(), Extremes { smallest, largest, unit }))
    });
    let state = StateSummary {
        name: result.record.name.clone(),
        load_factor: result.record.load_factor,
        extremes: extremes.collect(),
        forces: Forces::Body(BodyForces {
            reactions: result.reactions.clone(),
            mirrors: result.mirrors.clone(),
            corrections: result.corrections.clone(),
        }),
        certificate: result.record.certificate.clone(),
    };
    let probes = probes(scene, result);
    let checks = checks(scene, result, &probes);
    (state, probes, checks)
}

/// The model of a body and its derived numbers.
pub(super) fn model(scene: &BodyScene) -> BodySummary {
    let material = scene.material();
    let about = material.about();
    let breaks = scene.fracture.is_some() || scene.path.is_some();
    let on_border = if scene.model.follows_border() { scene.model.completing() } else { 0 };
    let ghosts = scene.model.ghosts().len() - scene.images().count();
    BodySummary {
        name: about.name,
        material: material.summary(&scene.resolved(&[]), ghosts, scene.units),
        materials: materials(scene),
        thickness: (about.surface != Surface::Solid).then_some(about.thickness),
        is_solid: about.surface == Surface::Solid,
        calibration: (!about.has_families).then_some(about.calibration),
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

/// The materials of regions, with their points.
fn materials(scene: &BodyScene) -> Vec<RegionSummary> {
    let mixture = scene.materials();
    let critical = scene.fracture.as_ref().map(|fracture| &fracture.steps.critical);
    let youngs = scene.material().youngs_moduli().first().map_or(1.0, |(_, base)| *base);
    let has_base = mixture.numbers.contains(&0);
    // Bonds of a stiffer point break at a smaller stretch.
    let stretches = |other: &OtherMaterial, of: &dyn Fn(&CriticalStretch, f64) -> f64| {
        let [least, greatest] = other.youngs_modulus.unwrap_or([youngs; 2]).map(|e| e / youngs);
        // With fibres there are two.
        let critical = critical.filter(|_| scene.material().fibres().is_none())?;
        let base = critical.by_offset().first()?;
        Some(ValueSummary::from([greatest, least].map(|modulus| base * of(critical, modulus))))
    };
    let of = |(other, number): (&OtherMaterial, u32)| RegionSummary {
        name: other.name.clone(),
        number,
        points: mixture.numbers.iter().filter(|own| **own == number).count(),
        youngs_modulus: other.youngs_modulus.map(Into::into),
        poisson_ratio: other.poisson_ratio,
        shear_modulus: other.shear_modulus.map(Into::into),
        stiffness_factor: other.stiffness_factor.map(Into::into),
        fibre_angle: other.fibre_angle,
        critical_stretch: stretches(other, &|critical, modulus| critical.ratio_within(number, modulus)),
        interface_stretch: stretches(other, &|critical, modulus| {
            critical.ratio_between([(0, 1.0), (number, modulus)])
        })
        .filter(|_| has_base),
    };
    mixture.others.iter().zip(1..).map(of).collect()
}

/// Number of bonds that cracks cut on a lattice, those of images left out.
fn cut_bonds(scene: &BodyScene) -> Option<usize> {
    let lattice = scene.body().cells()?;
    if scene.cracks.is_empty() {
        return None;
    }
    let about = scene.material().about();
    let reach = about.horizon_ratio + about.partial_neighbours + 1e-9;
    let mut offsets = scene.material().offsets().ok()?;
    offsets.retain(|step| f64::from(step.iter().map(|k| k * k).sum::<i32>()).sqrt() <= reach);
    Some(scene.cuts(lattice, &offsets).len())
}
