//! Bonds with which a lattice has the moduli of the material to rounding.
//!
//! With a weight `a >= 0` per half offset, `Σ a N Nᵀ = C`, `N = (n_x², n_y², n_x n_y)`: six equations, `C12 = C66` twice.
//! Of all solutions the one is taken that differs least, relatively, from the weights of the influence function.

use super::super::super::plane::{direction_product, is_within, length, project};
use super::super::{BondPlaneError, PlaneParameters};
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
    let products: Vec<[f64; 3]> = inside.iter().map(|&k| direction_product(offsets[k])).collect();
    let matrix = DMatrix::from_fn(PAIRS.len(), inside.len(), |e, k| {
        let (i, j) = PAIRS[e];
        products[k][i] * products[k][j]
    });
    // In units of C11: the weights of a case do not depend on its units by as much as a rounding.
    let rhs = DVector::from_fn(PAIRS.len(), |e, _| stiffness[PAIRS[e].0][PAIRS[e].1] / c11);
    let mut start = DVector::from_fn(inside.len(), |k, _| {
        let l = length(offsets[inside[k]]);
        parameters.influence.at((l / m).min(1.0)) * l
    });
    // The energy of an equal stretch in all directions is right: Σ a = 2 (C11 + C12).
    start *= 2.0 * (rhs[0] + rhs[2]) / start.sum().max(f64::MIN_POSITIVE);
    let least = 0.3 * start.mean();
    let scales = start.map(|a| a.max(least));
    let mut weights = project(&matrix, &rhs, &start, &scales);
    equalise(&mut weights, &inside.iter().map(|&k| offsets[k]).collect::<Vec<_>>());
    let residual = (&matrix * &weights - &rhs).amax();
    if residual.is_nan() || residual > EXACT {
        return Err(refusal(residual));
    }
    let mut all = vec![0.0; offsets.len()];
    inside.iter().zip(weights.iter()).for_each(|(&k, a)| all[k] = c11 * a);
    Ok(all)
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
