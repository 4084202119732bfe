//! What can be wrong with a plate.

use thiserror::Error;

/// Why a plate cannot be made.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum PlateError {
    /// Bonds along the rows alone cannot bend alike in all directions.
    #[error(
        "bonds of at most {horizon_ratio} spacings cannot bend alike in all directions: the diagonal ones are missing; \
         give a horizon ratio of at least 1.5"
    )]
    NotIsotropic {
        /// Horizon per spacing.
        horizon_ratio: f64,
    },
    /// A shear weight would be negative.
    #[error(
        "the shear law as corrected would need a bond with the weight {weight:.4}, and a stiffness must not be negative; \
         give another horizon ratio"
    )]
    NegativeShear {
        /// The weight.
        weight: f64,
    },
    /// Rows of a plate run along x.
    #[error("a plate in bending needs a plane lattice whose rows run along x")]
    Lattice,
}
