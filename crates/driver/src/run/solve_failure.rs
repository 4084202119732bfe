//! Why a stiffness has no factor.

use peristat_solve::FactorError;
use thiserror::Error;

/// The stiffness cannot be factored.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SolveFailure {
    /// A pivot is not positive.
    #[error(
        "the stiffness is not positive definite: {count} pivots are not positive, the first at component {component} of point {point}"
    )]
    NotPositiveDefinite {
        /// Number of pivots.
        count: usize,
        /// Component of the first.
        component: usize,
        /// Point of the first.
        point: usize,
    },
    /// The bonds of a point do not hold it.
    #[error("the bonds of point {point} do not hold it in all directions")]
    Loose {
        /// The point.
        point: usize,
    },
    /// The supports do not determine the reactions.
    #[error("the supports do not determine the reactions")]
    Supports,
    /// Nothing but a factor would do, and it would take too much memory.
    #[error(
        "a solid of {points} points that breaks needs coarser lattices, and has none: its rigid regions are free to move, or it fills little of its box; use a larger spacing"
    )]
    TooLarge {
        /// Number of points.
        points: usize,
    },
    /// Anything else.
    #[error(transparent)]
    Factor(FactorError),
}
