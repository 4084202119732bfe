//! Bonds with which a lattice has the moduli of the material to rounding and does not couple strain and rotation.
//!
//! `Σ a N Nᵀ + b T Tᵀ = C` and `Σ b T = 0`, eight equations for `a, b >= 0` per half offset. Of all solutions the one is
//! taken that differs least, relatively, from the start. The weight q of the bend keeps its ratio to b.

use super::super::super::plane::{direction_product, length, project};
use super::super::material::turned;
use super::super::moments::shear_row;
use super::super::{OrthotropicError, OrthotropicParameters, Start};
use super::{Fibres, flexibilities, start};
use crate::body::Cell;
use nalgebra::{DMatrix, DVector};

/// Pairs of strains that have a modulus.
const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (0, 1), (2, 2), (0, 2), (1, 2)];

/// Components of the coupling `Σ b T`; the other one is opposite to the first.
const COUPLING: [usize; 2] = [1, 2];

/// Largest residual of a modulus that counts as exact, per C11.
const EXACT: f64 = 1e-12;

/// Weights `[a, b, q]` of half offsets inside the horizon, Pa, and the start they were found from.
///
/// # Errors
/// [`OrthotropicError::NotRepresentable`], and those of the start.
pub(in super::super) fn weights(
    parameters: &OrthotropicParameters,
    offsets: &[Cell],
    fibres: &Fibres,
) -> Result<(Vec<[f64; 3]>, Start), OrthotropicError> {
    let material = &parameters.material;
    let (first, taken) = start::weights(parameters, offsets, fibres)?;
    let stiffness = material.stiffness();
    // In units of C11: the weights of a case do not depend on its units by as much as a rounding.
    let c11 = stiffness[0][0];
    let stiffness = turned(&stiffness.map(|row| row.map(|c| c / c11)), fibres.direction);
    let n = offsets.len();
    let matrix = equations(offsets);
    let rhs = DVector::from_fn(PAIRS.len() + COUPLING.len(), |e, _| {
        PAIRS.get(e).map_or(0.0, |&(i, j)| stiffness[i][j])
    });
    let begin = DVector::from_fn(2 * n, |k, _| first[k % n][k / n] / c11);
    let scales = scales(&begin);
    let mut found = project(&matrix, &rhs, &begin, &scales);
    equalise(&mut found, offsets, fibres);
    let residual = (&matrix * &found - &rhs).amax();
    if residual.is_nan() || residual > EXACT {
        return Err(OrthotropicError::NotRepresentable { horizon_ratio: parameters.horizon_ratio, residual });
    }
    let each = |k: usize| {
        let (a, b, [_, b0, q0]) = (c11 * found[k], c11 * found[n + k], first[k]);
        let matrix_beam = start::bend(b, flexibilities(material, length(offsets[k]))[0]);
        [a, b, if b0 > 0.0 { b * (q0 / b0) } else { matrix_beam }]
    };
    Ok(((0..n).map(each).collect(), taken))
}

/// The six moduli and the coupling of unit weights, those of a before those of b.
fn equations(offsets: &[Cell]) -> DMatrix<f64> {
    let n = offsets.len();
    DMatrix::from_fn(PAIRS.len() + COUPLING.len(), 2 * n, |e, k| {
        let row = if k < n { direction_product(offsets[k]) } else { shear_row(offsets[k - n]) };
        match PAIRS.get(e) {
            Some(&(i, j)) => row[i] * row[j],
            None if k < n => 0.0,
            None => row[COUPLING[e - PAIRS.len()]],
        }
    })
}

/// What changes of the weights are measured by: the weights themselves, but for small ones.
fn scales(begin: &DVector<f64>) -> DVector<f64> {
    let n = begin.len() / 2;
    let (mean_a, mean_b) = (begin.rows(0, n).mean(), begin.rows(n, n).mean());
    let least = [0.3 * mean_a, 0.3 * mean_b + 1e-6 * mean_a];
    DVector::from_fn(2 * n, |k, _| begin[k].max(least[k / n]))
}

/// Gives bonds that are images of each other in the fibres the same weights, to the last bit.
fn equalise(weights: &mut DVector<f64>, offsets: &[Cell], fibres: &Fibres) {
    let n = offsets.len();
    for k in 0..n {
        let image = fibres.image(offsets[k]).and_then(|image| offsets.iter().position(|o| *o == image));
        for (own, other) in image.filter(|&l| l > k).into_iter().flat_map(|l| [(k, l), (n + k, n + l)]) {
            let mean = 0.5 * (weights[own] + weights[other]);
            (weights[own], weights[other]) = (mean, mean);
        }
    }
}
