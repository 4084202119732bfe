//! A bond that resists elongation, shear and the difference of the rotations of its ends.

use super::super::plane::{LatticeBond, PlaneBond, strain_rows};
use crate::bonds::{BondGeometry, BondModel, Mat, Rows};

/// Unknowns of a point: `u`, `v` and `hθ`, all in m, with a length h of about the spacing.
///
/// Measures of a bond of length ξ, direction n and transverse direction t, with `d = u_j − u_i`: the stretch `n·d/ξ`, the
/// shear `t·d/ξ − (θ_i + θ_j)/2`, the bend `θ_j − θ_i`. Modulus of each: the volume V of a point, m³; the three weights of
/// an offset, Pa, are the rest. Together these are a beam with shear: with its stiffness densities c and d, and
/// `β = 6EΔ²/(5Gξ²)`, the weights are `c ξ V`, `12 d V/((1 + β) ξ)` and `d V/ξ`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeamBond {
    /// Volume of a point, m³.
    pub volume: f64,
    /// h, m: what multiplies rotations to make unknowns of the size of displacements.
    pub turning: f64,
}

impl BondModel<3, 3> for BeamBond {
    const DIFFERENCE: [[bool; 3]; 3] = [[true, true, false], [true, true, false], [false, false, true]];
    const MEAN: [[bool; 3]; 3] = [[false; 3], [false, false, true], [false; 3]];

    fn rows(&self, bond: &BondGeometry) -> Rows<3, 3> {
        let squared = bond.xi[0] * bond.xi[0] + bond.xi[1] * bond.xi[1];
        let (x, y) = (bond.xi[0] / squared, bond.xi[1] / squared);
        let turn = 1.0 / self.turning;
        Rows {
            difference: [[x, y, 0.0], [-y, x, 0.0], [0.0, 0.0, turn]],
            mean: [[0.0; 3], [0.0, 0.0, -turn], [0.0; 3]],
        }
    }

    fn moduli(&self, _: &BondGeometry) -> [f64; 3] {
        [self.volume; 3]
    }
}

impl LatticeBond<3, 3, 4> for BeamBond {
    /// `N·ε` and `T·ε + r` with `N = (n_x², n_y², n_x n_y)`, `T = (−n_x n_y, n_x n_y, (n_x² − n_y²)/2)`; nothing bends.
    fn in_uniform_state(&self, bond: &BondGeometry) -> Mat<3, 4> {
        let ([x, y, _], squared) = (bond.xi, bond.length().powi(2));
        let [xx, yy, xy] = [x * x / squared, y * y / squared, x * y / squared];
        [[xx, yy, xy, 0.0], [-xy, xy, 0.5 * (xx - yy), 1.0], [0.0; 4]]
    }

    fn part_moduli(&self, _: &BondGeometry, share: f64) -> [f64; 3] {
        // The bend of a part is that part of the whole one.
        [share * self.volume, share * self.volume, self.volume / share]
    }

    fn stretch_per_measure(&self, _: &BondGeometry) -> f64 {
        1.0
    }

    fn coarser(&self) -> Self {
        Self { volume: 4.0 * self.volume, ..*self }
    }
}

impl PlaneBond<3, 3, 4> for BeamBond {
    fn triangle(&self, first: [f64; 2], second: [f64; 2]) -> ([Mat<4, 3>; 2], Mat<4, 3>) {
        // ω = (∂v/∂x − ∂u/∂y)/2; a strain row of u along x is the derivative by x, that of v along y the one by y.
        let with_rotation = |rows: Mat<3, 2>| {
            let (by_x, by_y) = (rows[0][0], rows[1][1]);
            let strain = |k: usize| [rows[k][0], rows[k][1], 0.0];
            [strain(0), strain(1), strain(2), [-0.5 * by_y, 0.5 * by_x, 0.0]]
        };
        let mut own = [[0.0; 3]; 4];
        own[3][2] = -1.0 / self.turning;
        (strain_rows(first, second).map(with_rotation), own)
    }
}
