//! The constants of the continuum, as published, for fibres along bonds.

use super::super::super::plane::length;
use super::super::{OrthotropicError, OrthotropicMaterial, OrthotropicParameters};
use super::{Fibres, flexibilities};
use crate::body::Cell;
use std::f64::consts::PI;

/// What to do where the published bonds do not exist.
const HINT: &str = "take the calibration `matched`";

/// Stiffness densities of bonds, free of units of length: with the spacing h and the volume V of a point, all Pa. Matrix
/// constants are of all bonds, those of the fibres are added on bonds along them.
///
/// From equal energy of any uniform strain of points that turn with the body. The printed transverse constant of the
/// fibres has two sums multiplied where the energy has one sum of products, which is taken here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PublishedConstants {
    /// `c_m V h`: axial.
    pub matrix_axial: f64,
    /// `d_m V/h`: bending.
    pub matrix_bending: f64,
    /// `c_f V h`.
    pub fibre_axial: f64,
    /// `d_f V/h`.
    pub fibre_bending: f64,
}

impl PublishedConstants {
    /// Constants for a horizon of `m` spacings and fibres of the lengths (spacings) of half offsets. The sums over fibre
    /// bonds take the full volume of every neighbour.
    pub fn new(material: &OrthotropicMaterial, m: f64, fibre_lengths: &[f64]) -> Self {
        let (e1, e2) = (material.youngs_modulus_1, material.youngs_modulus_2);
        let (nu, g, q) = (material.poisson_ratio_12, material.shear_modulus_12, material.determinant());
        // Both signs of every half offset.
        let axial: f64 = 2.0 * fibre_lengths.iter().sum::<f64>();
        let bending = fibre_lengths.iter().map(|l| 1.0 / ((1.0 + flexibilities(material, *l)[1]) * l));
        let bending = 2.0 * bending.sum::<f64>();
        let phi = m * (5.0 * g / (6.0 * e2)).sqrt();
        // The horizon over ∫₀^δ dξ/(1 + β).
        let lambda = phi / (phi - phi.atan());
        Self {
            matrix_axial: 6.0 * (1.0 + nu) * e2 / (q * PI * m.powi(3)),
            matrix_bending: lambda * (1.0 - 3.0 * nu) * e2 / (6.0 * PI * m * q),
            fibre_axial: 2.0 * (e1 - e2) / (q * axial),
            fibre_bending: (2.0 * g * q - (1.0 - nu) * e2) / (3.0 * q * bending),
        }
    }

    /// `[a, b, q]`, Pa, of a bond.
    fn weights(&self, material: &OrthotropicMaterial, step: Cell, is_fibre: bool) -> [f64; 3] {
        let (l, share) = (length(step), f64::from(is_fibre));
        let [beta_matrix, beta_fibre] = flexibilities(material, l);
        let matrix = 12.0 * self.matrix_bending / ((1.0 + beta_matrix) * l);
        let fibre = 12.0 * self.fibre_bending * share / ((1.0 + beta_fibre) * l);
        [
            (self.matrix_axial + self.fibre_axial * share) * l,
            matrix + fibre,
            (self.matrix_bending + self.fibre_bending * share) / l,
        ]
    }
}

/// Weights of half offsets inside the horizon, Pa.
///
/// # Errors
/// No bonds along the fibres, or the constants of bending of the matrix or of the fibres are negative.
pub(in super::super) fn weights(
    parameters: &OrthotropicParameters,
    offsets: &[Cell],
    fibres: &Fibres,
) -> Result<Vec<[f64; 3]>, OrthotropicError> {
    let material = &parameters.material;
    let m = parameters.horizon_ratio;
    let what = "the calibration `published`";
    if !fibres.are_bonds() {
        let degrees = parameters.relative_angle().to_degrees();
        return Err(OrthotropicError::NoFibreBonds { horizon_ratio: m, degrees, what });
    }
    let fibre_lengths: Vec<f64> =
        offsets.iter().zip(&fibres.along).filter(|(_, f)| **f).map(|(&step, _)| length(step)).collect();
    let mut constants = PublishedConstants::new(material, m, &fibre_lengths);
    // What is left of a constant that is zero is rounding.
    let noise = 1e-14 * material.youngs_modulus_1;
    for constant in [&mut constants.matrix_bending, &mut constants.fibre_bending] {
        *constant = if constant.abs() <= noise { 0.0 } else { *constant };
    }
    if constants.matrix_bending < 0.0 {
        let poisson_ratio_12 = material.poisson_ratio_12;
        return Err(OrthotropicError::NegativeMatrixShear { poisson_ratio_12, what, hint: HINT });
    }
    if constants.fibre_bending < 0.0 {
        return Err(negative_fibre_shear(material, what, HINT));
    }
    let each = offsets.iter().zip(&fibres.along);
    Ok(each.map(|(&step, &is_fibre)| constants.weights(material, step, is_fibre)).collect())
}

/// The refusal of a material with too small a shear modulus.
pub(super) fn negative_fibre_shear(
    material: &OrthotropicMaterial,
    what: &'static str,
    hint: &'static str,
) -> OrthotropicError {
    let least =
        (1.0 - material.poisson_ratio_12) * material.youngs_modulus_2 / (2.0 * material.determinant());
    OrthotropicError::NegativeFibreShear { shear_modulus_12: material.shear_modulus_12, least, what, hint }
}
