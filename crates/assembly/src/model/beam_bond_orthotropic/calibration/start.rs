//! Bonds with about the moduli of the material, from which exact ones are looked for.
//!
//! Both starts take bonds of the matrix as in an isotropic body, `a ∝ L`, with `Σ a = C22 + C12` of the matrix, and the
//! rest of C11 on bonds near the fibres. They differ in which are near, and in the transverse stiffness.

use super::super::super::plane::length;
use super::super::{OrthotropicError, OrthotropicParameters, Start};
use super::published::negative_fibre_shear;
use super::{Fibres, flexibilities};
use crate::body::Cell;

/// What the start `aligned` is called where it does not exist.
const WHAT: &str = "the start `aligned`";
/// What to do there.
const HINT: &str = "take the start `oblique`";

/// Width of the kernel of the start `oblique` about the fibres, rad.
const WIDTH: f64 = 8.0 * std::f64::consts::PI / 180.0;

/// Zero of a modulus of bonds, per C11.
const NOISE: f64 = 1e-12;

/// Weights `[a, b, q]`, Pa, and the start that they are.
///
/// # Errors
/// The start `aligned` is asked for and does not exist.
pub(super) fn weights(
    parameters: &OrthotropicParameters,
    offsets: &[Cell],
    fibres: &Fibres,
) -> Result<(Vec<[f64; 3]>, Start), OrthotropicError> {
    if parameters.start == Some(Start::Oblique) {
        return Ok((oblique(parameters, offsets, fibres), Start::Oblique));
    }
    match aligned(parameters, offsets, fibres) {
        Ok(weights) => Ok((weights, Start::Aligned)),
        Err(refusal) if parameters.start == Some(Start::Aligned) => Err(refusal),
        Err(_) => Ok((oblique(parameters, offsets, fibres), Start::Oblique)),
    }
}

/// Only bonds along the fibres carry `C11 − C22`; half of what C66 has beyond the bonds of the matrix is theirs, half that
/// of bonds across, so that strain and rotation are not coupled.
fn aligned(
    parameters: &OrthotropicParameters,
    offsets: &[Cell],
    fibres: &Fibres,
) -> Result<Vec<[f64; 3]>, OrthotropicError> {
    let material = &parameters.material;
    if !fibres.are_bonds() {
        let (horizon_ratio, degrees) = (parameters.horizon_ratio, parameters.relative_angle().to_degrees());
        return Err(OrthotropicError::NoFibreBonds { horizon_ratio, degrees, what: WHAT });
    }
    let [[c11, c12, _], [_, c22, _], [_, _, c66]] = material.stiffness();
    // An isotropic matrix with these has C22 = 3/2 axial + 2 matrix and C12 = 1/2 axial − 2 matrix.
    let axial = 0.5 * (c22 + c12);
    let matrix = 0.5 * (c22 - 1.5 * axial);
    let extra = 4.0 * c66 - 2.0 * c22 + 2.0 * c12;
    if matrix < -NOISE * c11 {
        let poisson_ratio_12 = material.poisson_ratio_12;
        return Err(OrthotropicError::NegativeMatrixShear { poisson_ratio_12, what: WHAT, hint: HINT });
    }
    if extra < -NOISE * c11 {
        return Err(negative_fibre_shear(material, WHAT, HINT));
    }
    let (matrix, extra) = (matrix.max(0.0), extra.max(0.0));
    let beta = |k: usize| flexibilities(material, length(offsets[k]));
    let along = |k: usize| f64::from(fibres.along[k]);
    let across = |k: usize| f64::from(fibres.across[k]);
    let n = offsets.len();
    let axial = shares(n, 2.0 * axial, |k| length(offsets[k]));
    let fibre = shares(n, c11 - c22, |k| along(k) * length(offsets[k]));
    let matrix = shares(n, 16.0 * matrix, |k| 1.0 / ((1.0 + beta(k)[0]) * length(offsets[k])));
    let beam = |k: usize| 1.0 / ((1.0 + beta(k)[1]) * length(offsets[k]));
    let extra_along = shares(n, 0.5 * extra, |k| along(k) * beam(k));
    let extra_across = shares(n, 0.5 * extra, |k| across(k) * beam(k));
    let each = |k: usize| {
        let (matrix, extra) = (matrix[k], extra_along[k] + extra_across[k]);
        let [of_matrix, of_fibre] = beta(k);
        [axial[k] + fibre[k], matrix + extra, bend(matrix, of_matrix) + bend(extra, of_fibre)]
    };
    Ok((0..n).map(each).collect())
}

/// Bonds carry `C11 − C22` the more the closer they are to the fibres; the transverse stiffness is that of a matrix.
fn oblique(parameters: &OrthotropicParameters, offsets: &[Cell], fibres: &Fibres) -> Vec<[f64; 3]> {
    let material = &parameters.material;
    let [[c11, c12, _], [_, c22, _], [_, _, c66]] = material.stiffness();
    let beta = |k: usize| flexibilities(material, length(offsets[k]))[0];
    let [c, s] = fibres.direction;
    let near = |k: usize| {
        let [a, b, _] = offsets[k].map(f64::from);
        let angle = (b * c - a * s).abs().atan2((a * c + b * s).abs());
        length(offsets[k]) * (-0.5 * (angle / WIDTH).powi(2)).exp()
    };
    let n = offsets.len();
    let axial = shares(n, c22 + c12, |k| length(offsets[k]));
    let fibre = shares(n, c11 - c22, near);
    let shear = shares(n, 4.0 * (c66 - c12), |k| 1.0 / ((1.0 + beta(k)) * length(offsets[k])));
    (0..n).map(|k| [axial[k] + fibre[k], shear[k], bend(shear[k], beta(k))]).collect()
}

/// Weight of the bend of a beam whose shear has the weight `b`.
pub(super) fn bend(b: f64, flexibility: f64) -> f64 {
    b * (1.0 + flexibility) / 12.0
}

/// A total shared out by weights; nothing if they are all zero.
fn shares(n: usize, total: f64, weight: impl Fn(usize) -> f64) -> Vec<f64> {
    let weights: Vec<f64> = (0..n).map(weight).collect();
    let sum: f64 = weights.iter().sum();
    weights.iter().map(|w| if sum > 0.0 { total * w / sum } else { 0.0 }).collect()
}
