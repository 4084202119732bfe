//! Stiffnesses of a plate, and how its bonds come by them.

use serde::{Deserialize, Serialize};

/// Stiffness of a plate per width.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlateSection {
    /// Bending stiffness `D = E t³/(12 (1 − ν²))`, N m.
    pub bending: f64,
    /// Poisson's ratio ν, −1 < ν < 1/2.
    pub poisson_ratio: f64,
    /// Shear stiffness `S = κ G t`, N/m.
    pub shear: f64,
}

impl PlateSection {
    /// Of a homogeneous plate of thickness t, m, with the shear correction factor κ.
    pub fn homogeneous(youngs_modulus: f64, poisson_ratio: f64, thickness: f64, kappa: f64) -> Self {
        let plane = youngs_modulus / (1.0 - poisson_ratio * poisson_ratio);
        let shear_modulus = youngs_modulus / (2.0 * (1.0 + poisson_ratio));
        Self {
            bending: plane * thickness.powi(3) / 12.0,
            poisson_ratio,
            shear: kappa * shear_modulus * thickness,
        }
    }

    /// Moments `[M_xx, M_yy, M_xy]`, N, of curvatures `[κ_xx, κ_yy, κ_xy]`, 1/m, the last one of the tensor.
    pub fn moments(&self, [xx, yy, xy]: [f64; 3]) -> [f64; 3] {
        let (d, nu) = (self.bending, self.poisson_ratio);
        [d * (xx + nu * yy), d * (yy + nu * xx), d * (1.0 - nu) * xy]
    }

    /// Energy of moments and shear forces per area, J/m².
    pub fn energy(&self, [xx, yy, xy]: [f64; 3], shear: [f64; 2]) -> f64 {
        let (d, nu) = (self.bending, self.poisson_ratio);
        let bending = xx * xx + yy * yy - 2.0 * nu * xx * yy + 2.0 * (1.0 + nu) * xy * xy;
        0.5 * (bending / (d * (1.0 - nu * nu)) + (shear[0].powi(2) + shear[1].powi(2)) / self.shear)
    }

    /// What trace and deviator of the curvature have in common: the eigenvalue β of the bonds for the deviator, half of that for
    /// the trace, N m.
    pub(super) fn common(&self) -> f64 {
        let (d, nu) = (self.bending, self.poisson_ratio);
        ((1.0 - nu) * d).min(0.5 * (1.0 + nu) * d)
    }

    /// What triangles have beside the bonds: stiffness against the trace and the deviator, N m; one of them is zero.
    pub(super) fn rest(&self) -> [f64; 2] {
        let (d, nu, beta) = (self.bending, self.poisson_ratio, self.common());
        [(1.0 + nu) * d - 2.0 * beta, (1.0 - nu) * d - beta]
    }
}

/// Shear stiffness of a bond.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum ShearLaw {
    /// `ω/(1/(2S) + ξ²/(32D))` with weights ω of its own: free of locking at every thickness.
    #[default]
    Corrected,
    /// `2Sω` with the weights of bending: locks where the horizon is longer than the plate is thick; for comparison.
    Published,
}

/// A plate and its neighbourhood.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlateParameters {
    /// Its stiffness.
    pub section: PlateSection,
    /// Horizon per spacing, >= √2: 1.5 are the eight next points.
    pub horizon_ratio: f64,
    /// Shear stiffness of bonds.
    pub shear_law: ShearLaw,
}

impl PlateParameters {
    /// Shear stiffness of a bond of a length, m, and a weight, N/m.
    pub(super) fn shear(&self, weight: f64, length: f64) -> f64 {
        let PlateSection { bending, shear, .. } = self.section;
        match self.shear_law {
            ShearLaw::Corrected => weight / (0.5 / shear + length * length / (32.0 * bending)),
            ShearLaw::Published => 2.0 * shear * weight,
        }
    }
}
