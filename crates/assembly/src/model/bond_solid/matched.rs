//! Bonds with which a lattice of cubes has the moduli of the material to rounding.
//!
//! Offsets that are images of each other in the symmetries of the cube form an orbit of μ offsets with one weight a. Cubic
//! symmetry leaves two equations, with `f₄ = (n_x⁴+n_y⁴+n_z⁴)/3` and `f₂₂ = (1−3f₄)/6`:
//!
//! `½ Σ μ f₄ a = C11`, `½ Σ μ f₂₂ a = C11/3`.
//!
//! Of all non-negative solutions the one is taken that differs least, relatively, from the weights `ω ξ`, scaled to the right
//! energy of an equal stretch in all directions: `½ Σ μ a = 9K = 5 C11`.
//!
//! `isotropic` adds `Σ μ a ξ² H₄ = Σ μ a ξ² H₆ = 0`, the parts of the sixth moment with a direction that the cube leaves:
//! `H₄ = 3 f₄ − 3/5`, `H₆ = n_x² n_y² n_z² + H₄/22 − 1/105`. What that does is said of plates.

use super::super::plane::{is_within, length, project};
use super::{BondSolidParameters, SolidError, Weights};
use crate::body::Cell;
use nalgebra::{DMatrix, DVector};
use std::collections::BTreeMap;

/// Largest residual of a modulus that counts as exact, per C11.
const EXACT: f64 = 1e-12;

/// Weights of the offsets, Pa; zero beyond the horizon.
///
/// # Errors
/// [`SolidError::NotRepresentable`].
pub(super) fn weights(parameters: &BondSolidParameters, offsets: &[Cell]) -> Result<Vec<f64>, SolidError> {
    let m = parameters.horizon_ratio;
    let mut orbits: BTreeMap<[i32; 3], Vec<usize>> = BTreeMap::new();
    for (k, &offset) in offsets.iter().enumerate().filter(|(_, offset)| is_within(**offset, m)) {
        let mut kind = offset.map(i32::abs);
        kind.sort_unstable();
        orbits.entry(kind).or_default().push(k);
    }
    let refusal = |residual| SolidError::NotRepresentable { horizon_ratio: m, residual };
    if orbits.is_empty() {
        return Err(refusal(1.0));
    }
    let kinds: Vec<Cell> = orbits.keys().copied().collect();
    // Half of the offsets stand for all.
    let count = DVector::from_iterator(kinds.len(), orbits.values().map(|orbit| 2.0 * orbit.len() as f64));
    let equations = match parameters.weights {
        Weights::Nearest => 2,
        Weights::Isotropic => 4,
    };
    let matrix = DMatrix::from_fn(equations, kinds.len(), |equation, k| {
        let squares = kinds[k].map(|x| f64::from(x * x));
        let length = squares.iter().sum::<f64>();
        let f4 = squares.iter().map(|s| s * s).sum::<f64>() / (3.0 * length * length);
        let (h4, n6) = (3.0 * f4 - 0.6, squares.iter().product::<f64>() / length.powi(3));
        let of_one = match equation {
            0 => f4,
            1 => (1.0 - 3.0 * f4) / 6.0,
            2 => length / (m * m) * h4,
            _ => length / (m * m) * (n6 + h4 / 22.0 - 1.0 / 105.0),
        };
        0.5 * count[k] * of_one
    });
    // In units of C11.
    let rhs = DVector::from_fn(equations, |equation, _| [1.0, 1.0 / 3.0, 0.0, 0.0][equation]);
    let mut start = DVector::from_fn(kinds.len(), |k, _| {
        let length = length(kinds[k]);
        parameters.influence.at((length / m).min(1.0)) * length
    });
    start *= 10.0 / start.dot(&count).max(f64::MIN_POSITIVE);
    let least = 0.3 * start.dot(&count) / count.sum();
    let scales = DVector::from_fn(kinds.len(), |k, _| start[k].max(least) / count[k].sqrt());
    let found = project(&matrix, &rhs, &start, &scales);
    let residual = (&matrix * &found - &rhs).amax();
    if residual.is_nan() || residual > EXACT {
        return Err(refusal(residual));
    }
    let mut all = vec![0.0; offsets.len()];
    for (orbit, a) in orbits.values().zip(found.iter()) {
        orbit.iter().for_each(|&k| all[k] = 1.2 * parameters.youngs_modulus * a);
    }
    Ok(all)
}
