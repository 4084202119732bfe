//! Plane isotropic material as central bonds can have it.

use crate::bonds::Mat;
use serde::{Deserialize, Serialize};

/// What is zero across the plane; with it the Poisson ratio that central bonds have.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum PlaneState {
    /// No stress across the plane, ν = 1/3.
    #[default]
    Stress,
    /// No strain across the plane, ν = 1/4.
    Strain,
}

impl PlaneState {
    /// The only Poisson ratio that a body of central bonds has in this state: where C12 = C66.
    pub fn poisson_ratio(self) -> f64 {
        match self {
            Self::Stress => 1.0 / 3.0,
            Self::Strain => 0.25,
        }
    }
}

/// Isotropic material of a plate with the Poisson ratio of its state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneMaterial {
    /// Young's modulus, Pa, > 0.
    pub youngs_modulus: f64,
    /// Thickness, m, > 0.
    pub thickness: f64,
    /// Plane stress or plane strain.
    pub state: PlaneState,
}

impl PlaneMaterial {
    /// `C11`, Pa; `C12 = C66 = C11/3` in both states.
    pub fn c11(&self) -> f64 {
        self.youngs_modulus
            * match self.state {
                PlaneState::Stress => 9.0 / 8.0,
                PlaneState::Strain => 6.0 / 5.0,
            }
    }

    /// Stiffness, Pa, from strains `[ε_xx, ε_yy, γ_xy]` to stresses `[σ_xx, σ_yy, σ_xy]`.
    pub fn stiffness(&self) -> Mat<3, 3> {
        let (a, b) = (self.c11(), self.c11() / 3.0);
        [[a, b, 0.0], [b, a, 0.0], [0.0, 0.0, b]]
    }

    /// Strains `[ε_xx, ε_yy, γ_xy]` of stresses, `C⁻¹ σ`.
    pub fn strain(&self, [x, y, shear]: [f64; 3]) -> [f64; 3] {
        // With C12 = C11/3 the determinant of the upper block is 8/9 C11².
        let c = self.c11();
        [(9.0 * x - 3.0 * y) / (8.0 * c), (9.0 * y - 3.0 * x) / (8.0 * c), 3.0 * shear / c]
    }

    /// Stresses of strains `[ε_xx, ε_yy, γ_xy]`.
    pub fn stress(&self, strain: [f64; 3]) -> [f64; 3] {
        self.stiffness().map(|row| row[0] * strain[0] + row[1] * strain[1] + row[2] * strain[2])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moduli_are_those_of_the_poisson_ratio() {
        for state in [PlaneState::Stress, PlaneState::Strain] {
            let material = PlaneMaterial { youngs_modulus: 200e9, thickness: 0.01, state };
            let (e, nu) = (200e9, state.poisson_ratio());
            let (c11, c12) = match state {
                PlaneState::Stress => (e / (1.0 - nu * nu), nu * e / (1.0 - nu * nu)),
                PlaneState::Strain => {
                    let f = e / ((1.0 + nu) * (1.0 - 2.0 * nu));
                    (f * (1.0 - nu), f * nu)
                }
            };
            let c = material.stiffness();
            for (found, expected) in [(c[0][0], c11), (c[0][1], c12), (c[2][2], e / (2.0 + 2.0 * nu))] {
                assert!((found / expected - 1.0).abs() < 1e-15);
            }
            let strain = [1.0e-3, -2.0e-4, 5.0e-4];
            let back = material.strain(material.stress(strain));
            assert!((0..3).all(|k| (back[k] - strain[k]).abs() < 1e-18));
        }
    }
}
