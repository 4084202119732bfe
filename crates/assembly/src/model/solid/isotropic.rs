//! Isotropic materials of solids.

use super::TENSOR;
use crate::bonds::Mat;

/// Moduli of a material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in super::super) struct Isotropic {
    /// Young's modulus E, Pa.
    pub(in super::super) youngs_modulus: f64,
    /// Poisson's ratio ν.
    pub(in super::super) poisson_ratio: f64,
}

impl Isotropic {
    /// Shear modulus G, Pa.
    pub(in super::super) fn shear_modulus(&self) -> f64 {
        0.5 * self.youngs_modulus / (1.0 + self.poisson_ratio)
    }

    /// Bulk modulus K, Pa.
    pub(in super::super) fn bulk_modulus(&self) -> f64 {
        self.youngs_modulus / (3.0 * (1.0 - 2.0 * self.poisson_ratio))
    }

    /// Stiffness of the material, Pa.
    pub(in super::super) fn stiffness(&self) -> Mat<TENSOR, TENSOR> {
        let (shear, bulk) = (self.shear_modulus(), self.bulk_modulus());
        let lame = bulk - 2.0 * shear / 3.0;
        let mut c = [[0.0; TENSOR]; TENSOR];
        (0..3).for_each(|i| (0..3).for_each(|j| c[i][j] = lame));
        (0..3).for_each(|i| c[i][i] += 2.0 * shear);
        (3..TENSOR).for_each(|i| c[i][i] = shear);
        c
    }

    /// Strains of stresses.
    pub(in super::super) fn strain(&self, stress: [f64; TENSOR]) -> [f64; TENSOR] {
        let (e, nu, shear) = (self.youngs_modulus, self.poisson_ratio, self.shear_modulus());
        let trace = stress[0] + stress[1] + stress[2];
        let of = |q: usize| if q < 3 { ((1.0 + nu) * stress[q] - nu * trace) / e } else { stress[q] / shear };
        std::array::from_fn(of)
    }

    /// Root of the ratio of the moduli of changes of volume and of shape, the larger over the smaller.
    pub(in super::super) fn contrast(&self) -> f64 {
        let (shape, volume) = (2.0 * self.shear_modulus(), 3.0 * self.bulk_modulus());
        (shape / volume).max(volume / shape).sqrt()
    }
}
