//! Triangles of constant curvature: what bonds lack for Poisson's ratios other than 1/3.
//!
//! Each cell has four, of one of its corners and the two next ones, a quarter of its area each. They act on rotations alone, so
//! that they cannot lock.

use super::nodes::PlateNodes;
use super::{PHI_X, PHI_Y, PlateSection};
use crate::stiffness::{SharedFamilies, SharedKind};
use nalgebra::{DMatrix, RowDVector};
use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

/// The triangles of all cells, a family per cell: its lower left corner with the three others.
pub(super) fn triangles(nodes: &PlateNodes, section: &PlateSection) -> Option<SharedFamilies<3>> {
    let rest = section.rest();
    if rest.iter().all(|c| *c <= f64::EPSILON * section.bending) {
        return None;
    }
    let mut families = SharedFamilies::new(nodes.points());
    let kind = families.add_kind(SharedKind::new(3, root(nodes.spacing(), rest)));
    for cell in nodes.all_cells() {
        if let Some([first, others @ ..]) = nodes.corners(cell) {
            families.push(first, kind, 1.0, others.into_iter());
        }
    }
    Some(families)
}

/// Rows whose squares are twice the energy of the triangles of a cell, of the unknowns of three corners relative to the first.
fn root(h: f64, [trace, deviator]: [f64; 2]) -> DMatrix<f64> {
    let mut rows: Vec<RowDVector<f64>> = Vec::new();
    for (a, b) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
        let corner = |a: usize, b: usize| a + 2 * b;
        let (own, along, across) = (corner(a, b), corner(1 - a, b), corner(a, 1 - b));
        let slopes = [(along, if a == 0 { h } else { -h }), (across, if b == 0 { h } else { -h })];
        // ∂φ_c/∂x_k as a row.
        let slope = |c: usize, k: usize| {
            let mut row = RowDVector::zeros(9);
            let (other, length) = slopes[k];
            for (point, sign) in [(other, 1.0), (own, -1.0)] {
                if point > 0 {
                    row[3 * (point - 1) + c] += sign / length;
                }
            }
            row
        };
        let (xx, yy) = (slope(PHI_X, 0), slope(PHI_Y, 1));
        let xy = (slope(PHI_X, 1) + slope(PHI_Y, 0)) * 0.5;
        let [trace, deviator] = [trace, deviator].map(|c| (0.25 * h * h * c.max(0.0)).sqrt());
        rows.push((&xx + &yy) * (trace * FRAC_1_SQRT_2));
        rows.push((&xx - &yy) * (deviator * FRAC_1_SQRT_2));
        rows.push(xy * (deviator * SQRT_2));
    }
    DMatrix::from_rows(&rows)
}
