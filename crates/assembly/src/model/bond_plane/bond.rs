//! A bond that resists its elongation alone.

use super::super::plane::{LatticeBond, PlaneBond, strain_rows};
use crate::bonds::{BondGeometry, BondModel, Mat, Rows};

/// Measure: elongation `e = n·(u_j − u_i)`, m. Modulus: `V/ξ²` with the volume V of a point, m³; the weight of an offset
/// is the rest of the stiffness `k = a V/ξ²`, N/m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CentralBond {
    /// Volume of a point, m³.
    pub volume: f64,
}

impl BondModel<2, 1> for CentralBond {
    const DIFFERENCE: [[bool; 2]; 1] = [[true, true]];
    const MEAN: [[bool; 2]; 1] = [[false, false]];

    fn rows(&self, bond: &BondGeometry) -> Rows<2, 1> {
        let length = bond.length();
        Rows { difference: [[bond.xi[0] / length, bond.xi[1] / length]], mean: [[0.0; 2]] }
    }

    fn moduli(&self, bond: &BondGeometry) -> [f64; 1] {
        let length = bond.length();
        [self.volume / (length * length)]
    }
}

impl LatticeBond<2, 1, 3> for CentralBond {
    /// `e = ξ N·ε`.
    fn in_uniform_state(&self, bond: &BondGeometry) -> Mat<1, 3> {
        let ([x, y, _], length) = (bond.xi, bond.length());
        [[x * x / length, y * y / length, x * y / length]]
    }

    fn stretch_per_measure(&self, bond: &BondGeometry) -> f64 {
        1.0 / bond.length()
    }

    fn coarser(&self) -> Self {
        Self { volume: 4.0 * self.volume }
    }
}

impl PlaneBond<2, 1, 3> for CentralBond {
    fn triangle(&self, first: [f64; 2], second: [f64; 2]) -> ([Mat<3, 2>; 2], Mat<3, 2>) {
        (strain_rows(first, second), [[0.0; 2]; 3])
    }
}
