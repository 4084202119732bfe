//! What can be wrong with a body of central bonds.

use thiserror::Error;

/// Why a body in the plane cannot be made.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum BondPlaneError {
    /// No non-negative stiffnesses of the bonds give the moduli of the material.
    #[error(
        "bonds of at most {horizon_ratio} spacings cannot have the moduli of the material exactly; \
         increase the horizon ratio"
    )]
    NotRepresentable {
        /// Horizon per spacing.
        horizon_ratio: f64,
        /// What remains of the moduli, relative to C11.
        residual: f64,
    },
    /// The horizon reaches no other point.
    #[error("a horizon of {horizon_ratio} spacings reaches no other point; increase the horizon ratio")]
    NoNeighbours {
        /// Horizon per spacing.
        horizon_ratio: f64,
    },
    /// The overlay adds what exact families lack.
    #[error("edges `overlay` need the calibration `matched`: bonds as published do not have exact moduli")]
    OverlayNeedsMatched,
    /// Points of a cloud have no cells.
    #[error("the volume factor `area` needs the cells of a lattice; `ramp` needs none")]
    AreaNeedsCells,
    /// Two points of a cloud coincide.
    #[error("points {first} and {second} have the same position")]
    Coincident {
        /// The lower number.
        first: usize,
        /// The other one.
        second: usize,
    },
}
