//! What can be wrong with a shell membrane.

use thiserror::Error;

/// Why a shell membrane cannot be made.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum ShellError {
    /// The bonds do not resist all motions of the lattice.
    #[error(
        "with a horizon of {horizon_ratio} spacings some patterns of the lattice cost no energy; increase the horizon \
         ratio to 2 at least"
    )]
    ShortHorizon {
        /// Horizon per spacing.
        horizon_ratio: f64,
    },
    /// A full family has no positive weights that make uniform strains exact.
    #[error(
        "bonds of at most {horizon_ratio} spacings on a cylinder of {per_radius:.3} spacings per radius cannot have the \
         moduli of the material; use a smaller spacing"
    )]
    NotRepresentable {
        /// Horizon per spacing.
        horizon_ratio: f64,
        /// Spacing over radius.
        per_radius: f64,
    },
    /// Lengths or weights of bonds that no double holds.
    #[error(
        "bonds of a spacing of {spacing:e} on a cylinder of radius {radius:e} do not fit doubles; use other units"
    )]
    OutOfRange {
        /// Spacing, m.
        spacing: f64,
        /// R, m.
        radius: f64,
    },
    /// Bonds reach around the cylinder.
    #[error("the horizon {horizon} reaches half around a cylinder of radius {radius}; use a smaller spacing")]
    Around {
        /// δ, m.
        horizon: f64,
        /// R, m.
        radius: f64,
    },
}
