//! What the record of a run says of plates in bending.

use super::{Extremes, Forces, Located, StateSummary, plate_forces};
use crate::case::Model;
use crate::run::plate::{PlateResult, checks, probes};
use crate::run::{CheckResult, ProbeResult, scan};
use crate::scene::PlateScene;
use crate::scene::plate::PlateMaterial;
use peristat_assembly::model::plate_bending::ShearLaw;
use serde::Serialize;

/// The plate that was solved.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlateSummary {
    /// Name of the model.
    pub name: &'static str,
    /// Young's modulus.
    pub youngs_modulus: f64,
    /// Poisson's ratio.
    pub poisson_ratio: f64,
    /// Thickness.
    pub thickness: f64,
    /// Regions that are thicker or thinner, or of another material.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub materials: Vec<PlateRegion>,
    /// Bending stiffness D per width.
    pub bending_stiffness: f64,
    /// Shear stiffness κGt per width.
    pub shear_stiffness: f64,
    /// Shear stiffness of bonds.
    pub shear_law: ShearLaw,
    /// Horizon over spacing.
    pub horizon_ratio: f64,
    /// Side of a cell.
    pub spacing: f64,
    /// Pieces of bonds that leave the body.
    pub pieces: usize,
}

/// A region of a plate with a section of its own.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlateRegion {
    /// Name of its material.
    pub name: String,
    /// Young's modulus.
    pub youngs_modulus: f64,
    /// Poisson's ratio.
    pub poisson_ratio: f64,
    /// Thickness.
    pub thickness: f64,
    /// Bending stiffness D per width.
    pub bending_stiffness: f64,
    /// Strain per kelvin, where it is other than that of the case.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub thermal_expansion: Option<f64>,
    /// Area of its cells.
    pub area: f64,
}

/// What the summary needs of a state.
pub(super) fn state(
    scene: &PlateScene,
    result: &PlateResult,
) -> (StateSummary, Vec<ProbeResult>, Vec<CheckResult>) {
    let extremes = result.fields().filter_map(|field| {
        let values = result.values(field)?;
        let [smallest, largest] = scan::extremes(&values)?.map(|point| {
            let [x, y] = scene.plate.nodes().place(point);
            Located { value: values[point], x, y: Some(y), z: None, member: None }
        });
        let unit = field.about().unit.label(scene.units).into();
        Some((field.name().into(), Extremes { smallest, largest, unit }))
    });
    let state = StateSummary {
        name: result.record.name.clone(),
        load_factor: result.record.load_factor,
        extremes: extremes.collect(),
        forces: Forces::Plate(plate_forces::of(scene, result)),
        certificate: result.record.certificate.clone(),
    };
    let probes = probes(scene, result);
    let checks = checks(scene, result, &probes);
    (state, probes, checks)
}

/// The model of a plate and its derived numbers.
pub(super) fn model(scene: &PlateScene) -> PlateSummary {
    let parameters = scene.plate.parameters();
    let youngs_modulus = match &scene.case.model {
        Model::PlateBending(keys) => keys.youngs_modulus,
        _ => unreachable!("the model of a plate in bending is its own"),
    };
    let area = scene.plate.nodes().spacing().powi(2);
    let region = |material: &PlateMaterial| PlateRegion {
        name: material.name.clone(),
        youngs_modulus: material.keys.youngs_modulus,
        poisson_ratio: material.keys.poisson_ratio,
        thickness: material.keys.thickness,
        bending_stiffness: material.section.bending,
        thermal_expansion: material.thermal_expansion,
        area: area * material.cells as f64,
    };
    PlateSummary {
        materials: scene.materials.iter().map(region).collect(),
        name: scene.case.model.name(),
        youngs_modulus,
        poisson_ratio: parameters.section.poisson_ratio,
        thickness: scene.thickness.base,
        bending_stiffness: parameters.section.bending,
        shear_stiffness: parameters.section.shear,
        shear_law: parameters.shear_law,
        horizon_ratio: parameters.horizon_ratio,
        spacing: scene.plate.nodes().spacing(),
        pieces: scene.plate.pieces(),
    }
}
