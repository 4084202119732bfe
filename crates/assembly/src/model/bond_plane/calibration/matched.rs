//! Bonds with which a lattice has the moduli of the material to rounding.
//!
//! With a weight `a >= 0` per half offset, `Σ a N Nᵀ = C`, `N = (n_x², n_y², n_x n_y)`: six equations, `C12 = C66` twice.
//! Of all solutions the one is taken that differs least, relatively, from the weights of the influence function.
//!
//! `isotropic` adds `Σ a ξ² cos 4φ = 0`, the only part of the sixth moment with a direction that the square leaves, and where there
//! are solutions `Σ a ξ⁴ cos 4φ = Σ a ξ⁴ cos 8φ = 0` of the eighth. Isotropic operators of a displacement in equilibrium contain
//! `Δ²u` and `Δ div u` alone, which are zero without body forces: what is left is of the next even order.

use super::super::super::plane::{direction_product, is_within, length, project};
use super::super::{BondPlaneError, PlaneParameters, Weights};
use crate::body::Cell;
use nalgebra::{DMatrix, DVector};
use std::collections::BTreeMap;

/// Pairs of strains that have a modulus.
const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (0, 1), (2, 2), (0, 2), (1, 2)];

/// Largest residual of a modulus that counts as exact, per C11.
const EXACT: f64 = 1e-12;

/// Weights of the offsets, Pa; zero beyond the horizon.
///
/// # Errors
/// [`BondPlaneError::NotRepresentable`].
pub(in super::super) fn weights(
    parameters: &PlaneParameters,
    offsets: &[Cell],
) -> Result<Vec<f64>, BondPlaneError> {
    let m = parameters.horizon_ratio;
    let inside: Vec<usize> = (0..offsets.len()).filter(|&k| is_within(offsets[k], m)).collect();
    let stiffness = parameters.material.stiffness();
    let refusal = |residual| BondPlaneError::NotRepresentable { horizon_ratio: m, residual };
    if inside.is_empty() {
        return Err(refusal(1.0));
    }
    let c11 = stiffness[0][0];
    // In units of C11: the weights of a case do not depend on its units by as much as a rounding.
    let moduli = PAIRS.map(|(i, j)| stiffness[i][j] / c11);
    let (inside_offsets, sets) =
        (inside.iter().map(|&k| offsets[k]).collect::<Vec<_>>(), moments(parameters));
    let mut found = Err(1.0);
    for moments in sets {
        found = solution(parameters, &inside_offsets, (&moduli, moments));
        if found.is_ok() {
            break;
        }
    }
    let weights = found.map_err(refusal)?;
    let mut all = vec![0.0; offsets.len()];
    inside.iter().zip(weights.iter()).for_each(|(&k, a)| all[k] = c11 * a);
    Ok(all)
}

/// Parts with a direction of higher moments: the power of ξ and the multiple of the angle.
type Moment = (i32, u8);

/// The moments that are to be zero, most of them first.
fn moments(parameters: &PlaneParameters) -> &'static [&'static [Moment]] {
    const SIXTH: &[Moment] = &[(2, 4)];
    const EIGHTH: &[Moment] = &[(2, 4), (4, 4), (4, 8)];
    match parameters.weights {
        Weights::Nearest => &[&[]],
        Weights::Isotropic => &[EIGHTH, SIXTH],
    }
}

/// Weights of offsets with the moduli, per C11, that make some moments zero; else the residual.
fn solution(
    parameters: &PlaneParameters,
    offsets: &[Cell],
    (moduli, moments): (&[f64; 6], &[Moment]),
) -> Result<DVector<f64>, f64> {
    let m = parameters.horizon_ratio;
    let products: Vec<[f64; 3]> = offsets.iter().map(|offset| direction_product(*offset)).collect();
    let matrix = DMatrix::from_fn(PAIRS.len() + moments.len(), offsets.len(), |e, k| match PAIRS.get(e) {
        Some(&(i, j)) => products[k][i] * products[k][j],
        None => {
            let (power, multiple) = moments[e - PAIRS.len()];
            // n_x² n_y² = (1 − cos 4φ)/8
            let four = 1.0 - 8.0 * products[k][2].powi(2);
            let cosine = if multiple == 4 { four } else { 2.0 * four * four - 1.0 };
            (length(offsets[k]) / m).powi(power) * cosine
        }
    });
    let rhs = DVector::from_fn(matrix.nrows(), |e, _| moduli.get(e).copied().unwrap_or(0.0));
    let mut start = DVector::from_fn(offsets.len(), |k, _| {
        let l = length(offsets[k]);
        parameters.influence.at((l / m).min(1.0)) * l
    });
    // The energy of an equal stretch in all directions is right: Σ a = 2 (C11 + C12).
    start *= 2.0 * (rhs[0] + rhs[2]) / start.sum().max(f64::MIN_POSITIVE);
    let least = 0.3 * start.mean();
    let scales = start.map(|a| a.max(least));
    let mut weights = project(&matrix, &rhs, &start, &scales);
    equalise(&mut weights, offsets);
    let residual = (&matrix * &weights - &rhs).amax();
    if residual <= EXACT { Ok(weights) } else { Err(residual) }
}

/// Gives offsets that are images of each other in the symmetries of the square the same weight, to the last bit.
fn equalise(weights: &mut DVector<f64>, offsets: &[Cell]) {
    let mut kinds: BTreeMap<[i32; 2], Vec<usize>> = BTreeMap::new();
    for (k, [a, b, _]) in offsets.iter().map(|offset| offset.map(i32::abs)).enumerate() {
        kinds.entry([a.max(b), a.min(b)]).or_default().push(k);
    }
    for alike in kinds.values() {
        let mean = alike.iter().map(|&k| weights[k]).sum::<f64>() / alike.len() as f64;
        alike.iter().for_each(|&k| weights[k] = mean);
    }
}
