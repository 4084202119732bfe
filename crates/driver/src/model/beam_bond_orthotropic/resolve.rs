//! What the keys become.

use super::super::{Asked, BodyKind, Keys, Material, Model, Refused};
use super::{BeamBonds, LatticeRows, NAME, OBLIQUE, Orthotropic, are_alike, refusal};
use crate::diagnostic::{Faults, JsonPath, fibre_angle, positive, root, tidy};
use peristat_assembly::model::beam_bond_orthotropic::{
    BeamNeighbourhood, Laminae, OrthotropicError, OrthotropicMaterial, OrthotropicParameters, Start,
};
use peristat_assembly::model::plane::{Calibration, Edges};

/// Horizon ratio where bonds lie on the fibres.
const ALIGNED: f64 = 3.0;

impl Keys for Orthotropic {
    fn model(&self) -> Model {
        Model::BeamBondOrthotropic(self.clone())
    }

    fn thickness(&self) -> f64 {
        self.thickness
    }

    fn lattice_angle(&self) -> f64 {
        if self.lattice == LatticeRows::Fibre { self.fibre_angle.to_radians() } else { 0.0 }
    }

    fn takes_points(&self) -> bool {
        false
    }

    fn refuses(&self) -> Vec<Refused> {
        let of_fibres = Refused {
            key: "stress_intensity",
            message: "a stress intensity is that of an isotropic material, and this one has fibres",
            hint: "compare displacements, or stresses ahead of the tip",
        };
        if is_isotropic(self) { Vec::new() } else { vec![of_fibres] }
    }

    fn with_usual_bonds(&self) -> Model {
        let usual = Self { calibration: Calibration::default(), start: None, edges: None, ..self.clone() };
        Model::BeamBondOrthotropic(usual)
    }

    fn resolve(&self, asked: &Asked, faults: &mut Faults) -> Option<Box<dyn Material>> {
        let mut keys = self.clone();
        let parameters = parameters(&mut keys, asked, faults)?;
        Some(Box::new(BeamBonds { keys, parameters, angles: self.other_angles(asked) }))
    }
}

/// The parameters, filling in the defaults of the keys; the horizon ratio is to be set, and the angle of the lattice is the
/// one that is asked for.
fn parameters(model: &mut Orthotropic, asked: &Asked, faults: &mut Faults) -> Option<OrthotropicParameters> {
    let path = path();
    let mut fine = true;
    for (key, value) in [
        ("youngs_modulus_1", model.youngs_modulus_1),
        ("youngs_modulus_2", model.youngs_modulus_2),
        ("shear_modulus_12", model.shear_modulus_12),
        ("thickness", model.thickness),
    ] {
        fine &= positive(value, key, path.key(key), faults);
    }
    fine &= fibre_angle(model.fibre_angle, path.key("fibre_angle"), faults);
    if model.other_angles(asked).len() > Laminae::MOST {
        let message = format!("fibres have at most {} angles beside that of the model", Laminae::MOST);
        faults.error(root("materials"), message).hint("take fewer regions, or round their angles");
        fine = false;
    }
    if asked.body == BodyKind::Points {
        faults
            .error(asked.body_path.clone(), "the model `beam_bond_orthotropic` needs a lattice")
            .hint("take `rectangle` or `outline`; listed points and meshes are for `bond_plane`");
        fine = false;
    }
    fine &= has_no_mirrors_across_fibres(model, asked, faults);
    let plain = model.calibration == Calibration::Published;
    let edges = *model.edges.get_or_insert(if plain { Edges::None } else { Edges::Border });
    if !fine {
        return None;
    }
    let parameters = OrthotropicParameters {
        material: OrthotropicMaterial {
            youngs_modulus_1: model.youngs_modulus_1,
            youngs_modulus_2: model.youngs_modulus_2,
            poisson_ratio_12: model.poisson_ratio_12,
            shear_modulus_12: model.shear_modulus_12,
            thickness: model.thickness,
        },
        fibre_angle: model.fibre_angle.to_radians(),
        lattice_angle: 0.0,
        horizon_ratio: ALIGNED,
        calibration: model.calibration,
        start: model.start,
        edges,
    };
    match parameters.material.check() {
        Ok(()) => Some(parameters),
        Err(error) => {
            refusal(&error, parameters.calibration).tell(NAME, "horizon_ratio", faults);
            None
        }
    }
}

/// Path of the model in a case.
fn path() -> JsonPath {
    root("model").key(NAME)
}

impl Orthotropic {
    /// The angles of fibres of materials of regions that differ, and are not that of the model, degrees.
    fn other_angles(&self, asked: &Asked) -> Vec<f64> {
        let mut found: Vec<f64> = Vec::new();
        for &angle in &asked.fibre_angles {
            let is_own = are_alike(self.fibre_angle, angle);
            if !is_own && !found.iter().any(|own| are_alike(*own, angle)) {
                found.push(angle);
            }
        }
        found
    }
}

/// Mirrors need fibres along or across them.
fn has_no_mirrors_across_fibres(model: &Orthotropic, asked: &Asked, faults: &mut Faults) -> bool {
    let mut angles = [model.fibre_angle].into_iter().chain(asked.fibre_angles.iter().copied());
    let Some(angle) = angles.find(|angle| !asked.symmetry.is_empty() && angle % 90.0 != 0.0) else {
        return true;
    };
    faults
        .error(
            root("symmetry"),
            format!(
                "a mirror would turn the fibres from {0} to -{0} degrees: the body is not symmetric",
                tidy(angle)
            ),
        )
        .hint("model the whole body; fibres along x or y have mirrors");
    false
}

/// Whether all directions are alike.
fn is_isotropic(model: &Orthotropic) -> bool {
    let shear = 0.5 * model.youngs_modulus_1 / (1.0 + model.poisson_ratio_12);
    model.youngs_modulus_1 == model.youngs_modulus_2 && (model.shear_modulus_12 / shear - 1.0).abs() < 1e-9
}

/// The horizon ratio of a case that gives none; `angles` are those of other laminae, rad.
pub(super) fn horizon_ratio(parameters: &OrthotropicParameters, angles: &[f64]) -> f64 {
    let lies_between_bonds = |fibre_angle: f64| {
        let aligned = OrthotropicParameters {
            fibre_angle,
            horizon_ratio: ALIGNED,
            calibration: Calibration::Matched,
            start: Some(Start::Aligned),
            edges: Edges::None,
            ..*parameters
        };
        matches!(BeamNeighbourhood::new(&aligned), Err(OrthotropicError::NoFibreBonds { .. }))
    };
    let mut all = [parameters.fibre_angle].into_iter().chain(angles.iter().copied());
    if all.any(lies_between_bonds) { OBLIQUE } else { ALIGNED }
}

/// The start that the calibration `matched` has taken.
pub(super) fn start(parameters: &OrthotropicParameters) -> Option<Start> {
    BeamNeighbourhood::new(parameters).ok()?.start()
}

/// A warning for bonds that couple strain and rotation.
pub(super) fn warn(parameters: &OrthotropicParameters, faults: &mut Faults) {
    let Ok(bonds) = BeamNeighbourhood::new(parameters) else { return };
    if bonds.is_consistent() {
        return;
    }
    let (effective, given) = (bonds.effective_shear_modulus(), parameters.material.shear_modulus_12);
    faults
        .warning(
            path().key("calibration"),
            format!(
                "bonds as published couple strain and rotation: in shear the body acts as if G12 were {:.6e}, {:.2} % {} than {}",
                effective,
                100.0 * (effective / given - 1.0).abs(),
                if effective < given { "less" } else { "more" },
                tidy(given)
            ),
        )
        .hint("the calibration `matched` has the moduli that are given");
}
