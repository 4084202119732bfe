//! Treatments that stiffen the bonds near edges.

use super::super::super::plane::Mirrors;
use super::super::super::plane::at;
use super::super::neighbourhood::{Neighbourhood, direction_product};
use super::super::{Edges, PlaneParameters};
use crate::body::{Cell, SquareLattice};
use crate::stiffness::Exception;
use std::collections::HashMap;

/// Factors of the bonds of a lattice.
#[derive(Clone, Debug)]
pub(in super::super) struct EdgeFactors {
    /// Per offset: factor of bonds between points that lack nothing.
    pub(in super::super) base: Vec<f64>,
    /// Factors of other bonds, per that of their offset; offsets as in the neighbourhood.
    pub(in super::super) exceptions: Vec<Exception>,
}

/// `2 V/(V_i + V_j)`, V the volume of a full family and V_i, V_j those of the two ends.
pub(in super::super) fn volume_factor(full: f64, ends: [f64; 2]) -> f64 {
    2.0 * full / (ends[0] + ends[1])
}

/// `1/√((n_x/g_x)² + (n_y/g_y)²)` with the squares of the direction of the bond and the means of both ends' ratios g of the
/// energy of the continuum to that of the point, in uniform stretches along x and y.
pub(in super::super) fn energy_factor(squares: [f64; 2], ends: [[f64; 2]; 2]) -> f64 {
    let g = |k: usize| 0.5 * (ends[0][k] + ends[1][k]);
    1.0 / (squares[0] / (g(0) * g(0)) + squares[1] / (g(1) * g(1))).sqrt()
}

/// Factors of the treatments `volume` and `energy` from the uncut body.
pub(in super::super) fn edge_factors(
    lattice: &SquareLattice,
    mirrors: &Mirrors,
    hood: &Neighbourhood,
    parameters: &PlaneParameters,
    near: &[usize],
) -> EdgeFactors {
    let c11 = parameters.material.c11();
    // What a point needs to know of itself: its family's volume, or the two ratios of energies.
    let own = |present: &dyn Fn(Cell, bool) -> bool| -> [f64; 2] {
        let mut sums = [0.0; 3];
        for k in hood.bonded() {
            let (step, n) = (hood.offsets[k], direction_product(hood.offsets[k]));
            let count = [true, false].iter().filter(|&&side| present(step, side)).count() as f64;
            sums[0] += count * hood.parts[k];
            sums[1] += 0.5 * count * hood.weights[k] * n[0] * n[0];
            sums[2] += 0.5 * count * hood.weights[k] * n[1] * n[1];
        }
        match parameters.edges {
            Edges::Volume => [sums[0]; 2],
            _ => [c11 / sums[1], c11 / sums[2]],
        }
    };
    let full = own(&|_, _| true);
    let factor = |k: usize, ends: [[f64; 2]; 2]| match parameters.edges {
        Edges::Volume => volume_factor(full[0], [ends[0][0], ends[1][0]]),
        _ => {
            let [x, y, _] = direction_product(hood.offsets[k]);
            energy_factor([x, y], ends)
        }
    };
    let base: Vec<f64> = (0..hood.offsets.len()).map(|k| factor(k, [full, full])).collect();
    // Images have what their real points have.
    let of = |cell: Cell| own(&|step, side| lattice.number(at(cell, step, side)).is_some());
    let known: HashMap<usize, [f64; 2]> = near
        .iter()
        .map(|&p| (p, of(mirrors.image(lattice.cell(p)).0)))
        .filter(|(_, own)| *own != full)
        .collect();
    let mut exceptions = Vec::new();
    for &point in near.iter().filter(|p| known.contains_key(p)) {
        for k in hood.bonded() {
            for up in [true, false] {
                let Some(other) = lattice.number(at(lattice.cell(point), hood.offsets[k], up)) else {
                    continue;
                };
                // A bond between two such points is met twice.
                if up || !known.contains_key(&other) {
                    let ends = [known[&point], known.get(&other).copied().unwrap_or(full)];
                    let lower = if up { point } else { other };
                    exceptions.push(Exception { offset: k, lower, factor: factor(k, ends) / base[k] });
                }
            }
        }
    }
    EdgeFactors { base, exceptions }
}
