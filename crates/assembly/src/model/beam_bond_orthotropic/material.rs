//! Orthotropic material of a plate in plane stress.

use super::OrthotropicError;
use crate::bonds::Mat;
use std::array::from_fn;

/// Excess of C66 over C12, per C11, that is not rounding.
const EXCESS: f64 = 1e-12;

/// Unidirectional material in plane stress; direction 1 is that of the fibres. An isotropic material has equal moduli.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrthotropicMaterial {
    /// E1, Pa, >= E2.
    pub youngs_modulus_1: f64,
    /// E2, Pa, > 0.
    pub youngs_modulus_2: f64,
    /// ν12: contraction along 2 per stretch along 1.
    pub poisson_ratio_12: f64,
    /// G12, Pa, above `ν12 E2/(1 − ν12 ν21)`.
    pub shear_modulus_12: f64,
    /// Thickness, m, > 0.
    pub thickness: f64,
}

impl OrthotropicMaterial {
    /// An isotropic material.
    pub fn isotropic(youngs_modulus: f64, poisson_ratio: f64, thickness: f64) -> Self {
        Self {
            youngs_modulus_1: youngs_modulus,
            youngs_modulus_2: youngs_modulus,
            poisson_ratio_12: poisson_ratio,
            shear_modulus_12: 0.5 * youngs_modulus / (1.0 + poisson_ratio),
            thickness,
        }
    }

    /// Checks that some bonds without negative stiffness can have this material.
    ///
    /// # Errors
    /// A modulus or the thickness is not positive, direction 1 is the softer one, `ν12² >= E1/E2`, or `C66 <= C12`: the
    /// transverse stiffnesses b of all bonds add up to `4 (C66 − C12)`, whatever the bonds.
    pub fn check(&self) -> Result<(), OrthotropicError> {
        let (e1, e2, nu) = (self.youngs_modulus_1, self.youngs_modulus_2, self.poisson_ratio_12);
        let positive = [
            ("Young's modulus along the fibres", e1),
            ("Young's modulus across the fibres", e2),
            ("shear modulus", self.shear_modulus_12),
            ("thickness", self.thickness),
        ];
        if let Some(&(property, value)) = positive.iter().find(|(_, v)| !v.is_finite() || *v <= 0.0) {
            return Err(OrthotropicError::NotPositive { property, value });
        }
        if !nu.is_finite() {
            return Err(OrthotropicError::NotFinite { property: "Poisson ratio 12", value: nu });
        }
        if e1 < e2 {
            return Err(OrthotropicError::Exchanged { exchanged: nu * e2 / e1 });
        }
        if nu * nu >= e1 / e2 {
            return Err(OrthotropicError::NotDefinite { poisson_ratio_12: nu, most: (e1 / e2).sqrt() });
        }
        let [[c11, c12, _], _, [_, _, c66]] = self.stiffness();
        if c66 - c12 <= EXCESS * c11 {
            return Err(OrthotropicError::ShearTooSoft { shear_modulus_12: c66, least: c12 });
        }
        Ok(())
    }

    /// `1 − ν12 ν21`.
    pub fn determinant(&self) -> f64 {
        1.0 - self.poisson_ratio_12 * self.poisson_ratio_12 * self.youngs_modulus_2 / self.youngs_modulus_1
    }

    /// Stiffness C, Pa, from strains `[ε_11, ε_22, γ_12]` to stresses in the axes of the fibres.
    pub fn stiffness(&self) -> Mat<3, 3> {
        let q = self.determinant();
        let c12 = self.poisson_ratio_12 * self.youngs_modulus_2 / q;
        [
            [self.youngs_modulus_1 / q, c12, 0.0],
            [c12, self.youngs_modulus_2 / q, 0.0],
            [0.0, 0.0, self.shear_modulus_12],
        ]
    }

    /// Stiffness, Pa, from strains `[ε_xx, ε_yy, γ_xy]` to stresses in axes from which the fibres are turned by an angle,
    /// rad, counter-clockwise.
    pub fn stiffness_at(&self, angle: f64) -> Mat<3, 3> {
        turned(&self.stiffness(), [angle.cos(), angle.sin()])
    }

    /// Compliance, 1/Pa: the inverse of [`stiffness_at`](Self::stiffness_at).
    pub fn compliance_at(&self, angle: f64) -> Mat<3, 3> {
        let (e1, e2) = (self.youngs_modulus_1, self.youngs_modulus_2);
        let s12 = -self.poisson_ratio_12 / e1;
        let own = [[1.0 / e1, s12, 0.0], [s12, 1.0 / e2, 0.0], [0.0, 0.0, 1.0 / self.shear_modulus_12]];
        // Stresses turn as strains do, but for the factor 2 of the engineering shear.
        let back = strain_turn([angle.cos(), -angle.sin()]);
        from_fn(|r| from_fn(|c| (0..9).map(|k| back[r][k / 3] * own[k / 3][k % 3] * back[c][k % 3]).sum()))
    }
}

/// `Tᵀ C T`: a stiffness in axes from which its own are turned, with the direction `[cos, sin]` of its first axis.
pub(super) fn turned(stiffness: &Mat<3, 3>, direction: [f64; 2]) -> Mat<3, 3> {
    let t = strain_turn(direction);
    from_fn(|r| from_fn(|c| (0..9).map(|k| t[k / 3][r] * stiffness[k / 3][k % 3] * t[k % 3][c]).sum()))
}

/// T: strains `[ε_xx, ε_yy, γ_xy]` seen in axes whose first has the direction `[c, s]`.
fn strain_turn([c, s]: [f64; 2]) -> Mat<3, 3> {
    [[c * c, s * s, s * c], [s * s, c * c, -s * c], [-2.0 * s * c, 2.0 * s * c, c * c - s * s]]
}
