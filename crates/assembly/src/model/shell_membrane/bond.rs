//! A bond on a cylinder that resists its elongation.

use super::ShellKinematics;
use crate::bonds::{BondGeometry, BondModel, Rows};

/// Unknowns of a point: u along the axis, v along the circumference, w outwards, all in m.
///
/// Of a bond `ξ = (dX, dS)` the measure is its elongation. `Chord`, with `Δ = dS/R`:
/// `e = [dX (u_j − u_i) + R sin Δ (v_j − v_i) + 2R sin²(Δ/2) (w_i + w_j)]/L`, `L² = dX² + 4R² sin²(Δ/2)`, the linearised
/// change of the distance in space. `Published` (E. Oterkus et al., Procedia Structural Integrity 28 (2020), Eq. (10)):
/// `e = cos φ (u_j − u_i) + sin φ (v_j − v_i) + l sin²φ/(2R) (w_i + w_j)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShellBond {
    /// R, m.
    pub radius: f64,
    /// Elongations.
    pub kinematics: ShellKinematics,
    /// Modulus of a bond of weight one, `6 E h A` with the area A of a point, N m²; the weight is in 1/m².
    pub modulus: f64,
}

impl ShellBond {
    /// Length L of a bond that goes on by `[dX, dS]`, m.
    pub fn length(&self, [x, s]: [f64; 2]) -> f64 {
        match self.kinematics {
            ShellKinematics::Chord => x.hypot(2.0 * self.radius * (0.5 * s / self.radius).sin()),
            ShellKinematics::Published => x.hypot(s),
        }
    }

    /// Its direction `[n_x, n_s]`: the elongation in a uniform strain is `L n·ε n`.
    pub fn direction(&self, xi: [f64; 2]) -> [f64; 2] {
        let along = xi[0] / self.length(xi);
        [along, (1.0 - along * along).max(0.0).sqrt().copysign(xi[1])]
    }

    /// Coefficients of `u_j − u_i`, `v_j − v_i` and `w_i + w_j`.
    pub fn coefficients(&self, [x, s]: [f64; 2]) -> [f64; 3] {
        let (r, l) = (self.radius, self.length([x, s]));
        match self.kinematics {
            ShellKinematics::Chord => {
                [x / l, r * (s / r).sin() / l, 2.0 * r * (0.5 * s / r).sin().powi(2) / l]
            }
            ShellKinematics::Published => [x / l, s / l, s * s / (2.0 * r * l)],
        }
    }
}

impl BondModel<3, 1> for ShellBond {
    const DIFFERENCE: [[bool; 3]; 1] = [[true, true, false]];
    const MEAN: [[bool; 3]; 1] = [[false, false, true]];

    fn rows(&self, bond: &BondGeometry) -> Rows<3, 1> {
        let [u, v, w] = self.coefficients([bond.xi[0], bond.xi[1]]);
        Rows { difference: [[u, v, 0.0]], mean: [[0.0, 0.0, 2.0 * w]] }
    }

    fn moduli(&self, _: &BondGeometry) -> [f64; 1] {
        [self.modulus]
    }
}
