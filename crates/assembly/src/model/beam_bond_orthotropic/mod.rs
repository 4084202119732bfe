//! Orthotropic plates of beam bonds, static and linear.
//!
//! Points have displacements and a rotation θ of their own. A bond resists its stretch, its shear and the difference of
//! the rotations of its ends ([`BeamBond`]) with three weights a, b, q, Pa, per half offset. A uniform strain ε with
//! `r = ω − θ`, ω the rotation of the body, has the energy density `½ (εᵀ C ε + 2 r h·ε + H r²)` of [`Moments`]. In
//! equilibrium r is free, so the stiffness is `C − h hᵀ/H`: only bonds with `h = 0` have the moduli that C says. Those of
//! the calibration `matched` do; those as published are too soft in shear.
//!
//! A crack runs right only if the bonds that carry the fibres lie exactly along them: fracture needs a lattice with such
//! bonds, turned with the fibres if need be. Exact moduli alone are not enough.

mod body;
mod bond;
mod calibration;
mod error;
mod laminae;
mod material;
mod moments;
mod neighbourhood;
mod parameters;
#[cfg(test)]
mod tests;
mod toughness;

pub use body::BeamBondOrthotropic;
pub use bond::BeamBond;
pub use calibration::PublishedConstants;
pub use error::OrthotropicError;
pub use laminae::Laminae;
pub use material::OrthotropicMaterial;
pub use moments::Moments;
pub use neighbourhood::BeamNeighbourhood;
pub use parameters::{OrthotropicParameters, Start};
pub use toughness::{CriticalStretches, ReleaseRates, crossing_bonds};
