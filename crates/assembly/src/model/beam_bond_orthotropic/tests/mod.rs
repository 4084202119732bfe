//! What holds for every calibrated family of beam bonds.

mod bond;
mod cut;
mod feasible;
mod material;
mod plate;
mod published;
mod toughness;
mod weights;

use super::*;
use crate::body::Cell;
use crate::bonds::Mat;
use crate::model::plane::{Calibration, Edges};

const MPA: f64 = 1e6;

/// E1/E2 = 4.
const A: OrthotropicMaterial = OrthotropicMaterial {
    youngs_modulus_1: 41_000.0 * MPA,
    youngs_modulus_2: 10_400.0 * MPA,
    poisson_ratio_12: 0.28,
    shear_modulus_12: 4_300.0 * MPA,
    thickness: 1.0e-3,
};

/// E1/E2 = 12.5.
const B: OrthotropicMaterial = OrthotropicMaterial {
    youngs_modulus_1: 105_000.0 * MPA,
    youngs_modulus_2: 8_400.0 * MPA,
    poisson_ratio_12: 0.32,
    shear_modulus_12: 4_000.0 * MPA,
    thickness: 0.6e-3,
};

/// Matched bonds on a lattice along x.
fn parameters(material: OrthotropicMaterial, degrees: f64, horizon_ratio: f64) -> OrthotropicParameters {
    OrthotropicParameters {
        material,
        fibre_angle: degrees.to_radians(),
        lattice_angle: 0.0,
        horizon_ratio,
        calibration: Calibration::Matched,
        start: None,
        edges: Edges::Overlay,
    }
}

/// Bonds as published on a lattice along x.
fn as_published(material: OrthotropicMaterial, degrees: f64, horizon_ratio: f64) -> OrthotropicParameters {
    let calibration = Calibration::Published;
    OrthotropicParameters { calibration, edges: Edges::None, ..parameters(material, degrees, horizon_ratio) }
}

/// Largest difference of two stiffnesses.
fn difference(a: &Mat<3, 3>, b: &Mat<3, 3>) -> f64 {
    let each = a.iter().flatten().zip(b.iter().flatten());
    each.fold(0.0, |most, (x, y)| most.max((x - y).abs()))
}
