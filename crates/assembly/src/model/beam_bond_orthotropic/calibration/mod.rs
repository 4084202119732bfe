//! Weights of the bonds of a lattice.

mod fibres;
pub(super) mod matched;
pub(super) mod published;
mod start;

pub(super) use fibres::Fibres;
pub use published::PublishedConstants;

use super::OrthotropicMaterial;

/// Shear flexibility of a beam as high as the spacing, `β = 6E/(5G L²)`, over its length L in spacings: of the matrix
/// with E2, of fibres with E1.
fn flexibilities(material: &OrthotropicMaterial, length: f64) -> [f64; 2] {
    let of = |e: f64| 6.0 * e / (5.0 * material.shear_modulus_12 * length * length);
    [of(material.youngs_modulus_2), of(material.youngs_modulus_1)]
}
