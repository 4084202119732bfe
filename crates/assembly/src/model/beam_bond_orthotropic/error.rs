//! What can be wrong with a body of beam bonds.

use thiserror::Error;

/// Why a body of beam bonds cannot be made.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum OrthotropicError {
    /// A property that must be positive is not.
    #[error("the {property} is {value}; it must be a positive number")]
    NotPositive {
        /// Its name.
        property: &'static str,
        /// Its value.
        value: f64,
    },
    /// A property is no number.
    #[error("the {property} is {value}; it must be a finite number")]
    NotFinite {
        /// Its name.
        property: &'static str,
        /// Its value.
        value: f64,
    },
    /// The fibres are not the stiffer direction.
    #[error(
        "Young's modulus along the fibres is the smaller one; direction 1 must be the stiffer: exchange the moduli, \
         turn the fibres by 90 degrees and take {exchanged:.6} as Poisson ratio 12"
    )]
    Exchanged {
        /// The Poisson ratio once the directions are exchanged, ν21.
        exchanged: f64,
    },
    /// The energy of some strain is negative.
    #[error(
        "with a Poisson ratio 12 of {poisson_ratio_12} some strains have no positive energy; its magnitude must be \
         below the root of E1/E2, {most:.6}"
    )]
    NotDefinite {
        /// ν12.
        poisson_ratio_12: f64,
        /// Limit of its magnitude.
        most: f64,
    },
    /// The shear modulus is not above C12.
    #[error(
        "bonds without negative stiffness cannot have a shear modulus of {shear_modulus_12}; it must exceed \
         nu12 E2/(1 - nu12 nu21) = {least:.6e} (in an isotropic material: a Poisson ratio below 1/3)"
    )]
    ShearTooSoft {
        /// G12, Pa.
        shear_modulus_12: f64,
        /// C12, Pa.
        least: f64,
    },
    /// The horizon reaches no other point.
    #[error("a horizon of {horizon_ratio} spacings reaches no other point; increase the horizon ratio")]
    NoNeighbours {
        /// Horizon per spacing.
        horizon_ratio: f64,
    },
    /// No non-negative stiffnesses of the bonds give the moduli of the material.
    #[error(
        "bonds of at most {horizon_ratio} spacings cannot have the moduli of the material exactly; \
         increase the horizon ratio (3.2 represents every angle)"
    )]
    NotRepresentable {
        /// Horizon per spacing.
        horizon_ratio: f64,
        /// What remains of the moduli, relative to C11.
        residual: f64,
    },
    /// No bonds lie exactly on the fibres.
    #[error(
        "no bond of at most {horizon_ratio} spacings lies on fibres at {degrees:.4} degrees to the lattice, which \
         {what} needs; turn the lattice with the fibres"
    )]
    NoFibreBonds {
        /// Horizon per spacing.
        horizon_ratio: f64,
        /// Angle from the rows of the lattice to the fibres, degrees.
        degrees: f64,
        /// What needs them.
        what: &'static str,
    },
    /// The transverse stiffness of matrix bonds would be negative.
    #[error(
        "a Poisson ratio 12 of {poisson_ratio_12} above 1/3 makes bonds of the matrix negative in {what}; {hint}"
    )]
    NegativeMatrixShear {
        /// ν12.
        poisson_ratio_12: f64,
        /// Where.
        what: &'static str,
        /// What to do.
        hint: &'static str,
    },
    /// The transverse stiffness of fibre bonds would be negative.
    #[error(
        "a shear modulus of {shear_modulus_12} below (1 - nu12) E2/(2 - 2 nu12 nu21) = {least:.6e} makes \
         bonds of the fibres negative in {what}; {hint}"
    )]
    NegativeFibreShear {
        /// G12, Pa.
        shear_modulus_12: f64,
        /// Limit, Pa.
        least: f64,
        /// Where.
        what: &'static str,
        /// What to do.
        hint: &'static str,
    },
    /// Bonds as published have no start.
    #[error(
        "bonds as published are not fitted from a start; leave `start` out or take the calibration `matched`"
    )]
    StartNeedsMatched,
    /// The overlay adds what exact families lack.
    #[error("edges `overlay` need the calibration `matched`: bonds as published do not have exact moduli")]
    OverlayNeedsMatched,
    /// Bonds of the matrix alone release more than the crack across the fibres shall.
    #[error(
        "bonds of the matrix alone release {matrix:.6e} in a crack across the fibres, not less than the \
         {required:.6e} wanted in all; increase the fibre energy release rate or decrease that of the matrix"
    )]
    FibreReleaseTooSmall {
        /// Released by bonds of the matrix, J/m².
        matrix: f64,
        /// Wanted in all, J/m².
        required: f64,
    },
}
