//! Treatments that stiffen the bonds near edges.

use super::super::body::Kind;
use super::super::bond::PlaneBond;
use super::super::near::at;
use super::super::neighbourhood::Neighbourhood;
use super::super::{Edges, Mirrors, geometry};
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
pub(in super::super::super) fn volume_factor(full: f64, ends: [f64; 2]) -> f64 {
    2.0 * full / (ends[0] + ends[1])
}

/// `1/√((n_x/g_x)² + (n_y/g_y)²)` with the squares of the direction of the bond and the means of both ends' ratios g of the
/// energy of the continuum to that of the point, in uniform stretches along x and y.
pub(in super::super::super) fn energy_factor(squares: [f64; 2], ends: [[f64; 2]; 2]) -> f64 {
    let g = |k: usize| 0.5 * (ends[0][k] + ends[1][k]);
    1.0 / (squares[0] / (g(0) * g(0)) + squares[1] / (g(1) * g(1))).sqrt()
}

/// Factors of the treatments `volume` and `energy` from the uncut body; bonds that are `apart`, sorted, are none of its.
pub(in super::super) fn edge_factors<
    const D: usize,
    const M: usize,
    const S: usize,
    B: PlaneBond<D, M, S>,
>(
    (lattice, mirrors): (&SquareLattice, &Mirrors),
    neighbourhood: &Neighbourhood<M>,
    kind: &Kind<B>,
    near: &[usize],
    apart: &[(usize, usize)],
) -> EdgeFactors {
    // Family volume, and twice the energies in unit stretches along x and y, that a bond brings to either end.
    let shares: Vec<[f64; 3]> = (0..neighbourhood.offsets.len())
        .map(|k| {
            let geometry = geometry(lattice, neighbourhood.offsets[k]);
            let (uniform, unit) = (kind.bond.in_uniform_state(&geometry), kind.bond.moduli(&geometry));
            let energy = |axis: usize| -> f64 {
                (0..M).map(|m| 0.5 * neighbourhood.weights[k][m] * unit[m] * uniform[m][axis].powi(2)).sum()
            };
            [neighbourhood.parts[k], energy(0), energy(1)]
        })
        .collect();
    let volume = lattice.spacing().powi(2) * kind.thickness;
    // What a point needs to know of itself: its family's volume, or the two ratios of energies.
    let own = |present: &dyn Fn(usize, bool) -> bool| -> [f64; 2] {
        let mut sums = [0.0; 3];
        for k in neighbourhood.bonded() {
            let count = [true, false].iter().filter(|&&side| present(k, side)).count() as f64;
            (0..3).for_each(|q| sums[q] += count * shares[k][q]);
        }
        match kind.edges {
            Edges::Volume => [sums[0]; 2],
            _ => [0, 1].map(|axis| kind.stretch_moduli[axis] * volume / sums[1 + axis]),
        }
    };
    let full = own(&|_, _| true);
    let factor = |k: usize, ends: [[f64; 2]; 2]| match kind.edges {
        Edges::Volume => volume_factor(full[0], [ends[0][0], ends[1][0]]),
        _ => {
            let [x, y, _] = geometry(lattice, neighbourhood.offsets[k]).xi;
            let squared = x * x + y * y;
            energy_factor([x * x / squared, y * y / squared], ends)
        }
    };
    let base: Vec<f64> = (0..neighbourhood.offsets.len()).map(|k| factor(k, [full, full])).collect();
    // Images have what their real points have.
    let joined = |cell: Cell, k: usize, side: bool| {
        let lower = if side { cell } else { at(cell, neighbourhood.offsets[k], false) };
        lattice.number(lower).is_some_and(|lower| apart.binary_search(&(k, lower)).is_err())
    };
    let there =
        |cell: Cell, k: usize, side: bool| lattice.number(at(cell, neighbourhood.offsets[k], side)).is_some();
    let of = |cell: Cell| own(&|k, side| there(cell, k, side) && (apart.is_empty() || joined(cell, k, side)));
    let known: HashMap<usize, [f64; 2]> = near
        .iter()
        .map(|&p| (p, of(mirrors.image(lattice.cell(p)).0)))
        .filter(|(_, own)| *own != full)
        .collect();
    let mut exceptions = Vec::new();
    for &point in near.iter().filter(|p| known.contains_key(p)) {
        for k in neighbourhood.bonded() {
            for up in [true, false] {
                let Some(other) = lattice.number(at(lattice.cell(point), neighbourhood.offsets[k], up))
                else {
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
