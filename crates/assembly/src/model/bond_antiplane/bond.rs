//! A bond that resists the difference of displacements across the plane.

use super::super::plane::{LatticeBond, PlaneBond, strain_rows};
use crate::bonds::{BondGeometry, BondModel, Mat, Rows};

/// Measure: `e = w_j − w_i`, m. Modulus: `V/ξ²` with the volume V of a point, m³; the weight of an offset is the rest of the
/// stiffness `k = a V/ξ²`, N/m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShearBond {
    /// Volume of a point, m³.
    pub volume: f64,
}

impl BondModel<1, 1> for ShearBond {
    const DIFFERENCE: [[bool; 1]; 1] = [[true]];
    const MEAN: [[bool; 1]; 1] = [[false]];

    fn rows(&self, _bond: &BondGeometry) -> Rows<1, 1> {
        Rows { difference: [[1.0]], mean: [[0.0]] }
    }

    fn moduli(&self, bond: &BondGeometry) -> [f64; 1] {
        let length = bond.length();
        [self.volume / (length * length)]
    }
}

impl LatticeBond<1, 1, 3> for ShearBond {
    /// `e = ξ n·γ`.
    fn in_uniform_state(&self, bond: &BondGeometry) -> Mat<1, 3> {
        [[bond.xi[0], bond.xi[1], 0.0]]
    }

    fn stretch_per_measure(&self, bond: &BondGeometry) -> f64 {
        1.0 / bond.length()
    }

    fn coarser(&self) -> Self {
        Self { volume: 4.0 * self.volume }
    }
}

impl PlaneBond<1, 1, 3> for ShearBond {
    fn image_signs(signs: [f64; 2]) -> [f64; 3] {
        [signs[0], signs[1], 0.0]
    }

    /// The gradient of w: what the strains of the plane say of a displacement along x, and of one along y.
    fn triangle(&self, first: [f64; 2], second: [f64; 2]) -> ([Mat<3, 1>; 2], Mat<3, 1>) {
        let rows = strain_rows(first, second).map(|of| [[of[0][0]], [of[1][1]], [0.0]]);
        (rows, [[0.0]; 3])
    }
}
