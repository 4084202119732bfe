//! A bond of a solid that resists its elongation alone.

use super::super::plane::LatticeBond;
use super::TENSOR;
use crate::body::Cell;
use crate::bonds::{BondGeometry, BondModel, Mat, Rows};

/// Measure: elongation `e = n·(u_j − u_i)`, m. Modulus: `V/ξ²` with the volume V of a point, m³; the weight of an offset is the
/// rest of the stiffness `k = a V/ξ²`, N/m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidBond {
    /// Volume of a point, m³.
    pub volume: f64,
}

impl BondModel<3, 1> for SolidBond {
    const DIFFERENCE: [[bool; 3]; 1] = [[true; 3]];
    const MEAN: [[bool; 3]; 1] = [[false; 3]];

    fn rows(&self, bond: &BondGeometry) -> Rows<3, 1> {
        let length = bond.length();
        Rows { difference: [bond.xi.map(|x| x / length)], mean: [[0.0; 3]] }
    }

    fn moduli(&self, bond: &BondGeometry) -> [f64; 1] {
        let length = bond.length();
        [self.volume / (length * length)]
    }
}

impl LatticeBond<3, 1, TENSOR> for SolidBond {
    /// `e = ξ N·E`.
    fn in_uniform_state(&self, bond: &BondGeometry) -> Mat<1, TENSOR> {
        let ([x, y, z], length) = (bond.xi, bond.length());
        [[x * x, y * y, z * z, y * z, x * z, x * y].map(|product| product / length)]
    }

    fn stretch_per_measure(&self, bond: &BondGeometry) -> f64 {
        1.0 / bond.length()
    }

    fn coarser(&self) -> Self {
        Self { volume: 8.0 * self.volume }
    }
}

/// `N` of the direction of an offset.
pub(in super::super) fn direction_product(step: Cell) -> [f64; TENSOR] {
    let [x, y, z] = step.map(f64::from);
    let squared = x * x + y * y + z * z;
    [x * x, y * y, z * z, y * z, x * z, x * y].map(|product| product / squared)
}
