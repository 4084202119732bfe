//! Tetrahedra that a point makes with three others.

use super::super::plane::{Neighbourhood, is_cut};
use super::TENSOR;
use crate::body::{Cell, SquareLattice, minus, plus};
use crate::bonds::{Mat, Point};
use nalgebra::Matrix3;
use std::collections::HashSet;

/// The other three corners, as steps from the point.
pub(super) type Corners = [Cell; 3];

/// Tetrahedra are as good as the best if they are so up to this factor.
const AS_GOOD: f64 = 1.5;

/// The tetrahedra of a cell with the next cells along the axes, one per octant, or if there are none the best ones with any cells
/// near; those with a cut edge are left out.
pub(super) fn tetrahedra<const M: usize>(
    lattice: &SquareLattice,
    neighbourhood: &Neighbourhood<M>,
    cuts: &HashSet<(usize, usize)>,
    cell: Cell,
) -> Vec<Corners> {
    let has = |step: Cell| lattice.number(plus(cell, step)).is_some();
    let signs = |k: usize| [0, 1, 2].map(|axis| if k >> axis & 1 == 0 { 1 } else { -1 });
    let octants = (0..8).map(signs).map(|[x, y, z]| [[x, 0, 0], [0, y, 0], [0, 0, z]]);
    let mut found: Vec<Corners> = octants.filter(|corners| corners.iter().all(|&c| has(c))).collect();
    if found.is_empty() {
        found =
            [1, 2].into_iter().map(|reach| nearest(reach, &has)).find(|t| !t.is_empty()).unwrap_or_default();
    }
    let joined = |a: Cell, b: Cell| !is_cut(lattice, neighbourhood, cuts, plus(cell, a), plus(cell, b));
    found.retain(|&[a, b, c]| {
        [([0; 3], a), ([0; 3], b), ([0; 3], c), (a, b), (a, c), (b, c)].into_iter().all(|(a, b)| joined(a, b))
    });
    found
}

/// The best shaped tetrahedra with cells within some rows, columns and layers: all that are about equally good, so that images
/// in a mirror choose images.
fn nearest(reach: i32, has: &dyn Fn(Cell) -> bool) -> Vec<Corners> {
    let side = || -reach..=reach;
    let all = side().flat_map(|c| side().flat_map(move |b| side().map(move |a| [a, b, c])));
    let near: Vec<Cell> = all.filter(|&step| step != [0; 3] && has(step)).collect();
    let squared = |step: Cell| f64::from(step.iter().map(|k| k * k).sum::<i32>());
    let mut found: Vec<(f64, Corners)> = Vec::new();
    for (k, &c) in near.iter().enumerate() {
        for (l, &b) in near[..k].iter().enumerate() {
            for &a in &near[..l] {
                let volume = matrix(places([a, b, c])).determinant().abs();
                if volume > 0.5 {
                    let edges = [a, b, c, minus(b, a), minus(c, a), minus(c, b)].map(squared);
                    found.push((edges.iter().sum::<f64>().powf(1.5) / volume, [a, b, c]));
                }
            }
        }
    }
    let least = found.iter().map(|f| f.0).fold(f64::INFINITY, f64::min);
    found.into_iter().filter(|f| f.0 <= AS_GOOD * least).map(|f| f.1).collect()
}

/// Corners relative to the point, spacings.
fn places(corners: Corners) -> [Point; 3] {
    corners.map(|step| step.map(f64::from))
}

/// One corner per row.
fn matrix(corners: [Point; 3]) -> Matrix3<f64> {
    Matrix3::from_fn(|row, column| corners[row][column])
}

/// Strains of a tetrahedron of cells per displacement of its other corners relative to the point, 1/m.
pub(super) fn rows_of_cells(corners: Corners, spacing: f64) -> [Mat<TENSOR, 3>; 3] {
    strain_rows(places(corners)).map(|rows| rows.map(|row| row.map(|v| v / spacing)))
}

/// Strains of a tetrahedron per displacement of its other corners relative to a point, from which they are `corners`: per unit of
/// these.
pub(in super::super) fn strain_rows(corners: [Point; 3]) -> [Mat<TENSOR, 3>; 3] {
    // The corners are independent: tetrahedra without volume are never made.
    let inverse = matrix(corners).try_inverse().unwrap_or_default();
    [0, 1, 2].map(|corner| {
        let [x, y, z] = [0, 1, 2].map(|axis| inverse[(axis, corner)]);
        [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z], [0.0, z, y], [z, 0.0, x], [y, x, 0.0]]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tetrahedron_has_the_strain_of_a_linear_field() {
        let gradient = [[0.1, 0.7, -0.2], [-0.3, 0.4, 0.5], [0.9, -0.6, 0.8]];
        for corners in [[[1, 0, 0], [0, -1, 0], [0, 0, 1]], [[1, 1, 0], [-1, 0, 1], [0, 2, 1]]] {
            let rows = rows_of_cells(corners, 0.5);
            let mut strain = [0.0; TENSOR];
            for (step, rows) in corners.iter().zip(rows) {
                let moved = gradient.map(|g| (0..3).map(|k| 0.5 * g[k] * f64::from(step[k])).sum::<f64>());
                (0..TENSOR).for_each(|q| strain[q] += (0..3).map(|c| rows[q][c] * moved[c]).sum::<f64>());
            }
            let expected = [0.1, 0.4, 0.8, 0.5 - 0.6, -0.2 + 0.9, 0.7 - 0.3];
            assert!((0..TENSOR).all(|q| (strain[q] - expected[q]).abs() < 1e-15), "{strain:?}");
        }
    }
}
