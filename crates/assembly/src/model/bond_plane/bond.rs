//! A bond that resists its elongation alone.

use crate::bonds::{BondGeometry, BondModel, Rows};

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
