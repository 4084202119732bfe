//! Why a run has no result.

use super::solve_failure::SolveFailure;
use crate::diagnostic::Faults;
use crate::memory::words;
use thiserror::Error;

/// Why a run has no result.
#[derive(Debug, Error)]
pub enum RunError {
    /// The case cannot be solved as it is.
    #[error("the case cannot be solved")]
    Case(Faults),
    /// More memory would be needed than is allowed.
    #[error("about {} of memory would be needed, {} may be used", words(*needed), words(*allowed))]
    Memory {
        /// Estimated need, bytes.
        needed: u64,
        /// Limit, bytes.
        allowed: u64,
    },
    /// The stiffness has no factor.
    #[error(transparent)]
    Solve(#[from] SolveFailure),
    /// The run was asked to end before it was done.
    #[error("interrupted")]
    Interrupted,
    /// There is a restart to go on from, but the scene is not solved in events.
    #[error("only a run of a body that breaks or softens can be resumed")]
    NotResumable,
    /// There is a restart to go on from, but it is of another body.
    #[error("the restart does not fit the body")]
    Misfit,
    /// The case is none of those that several processes can share.
    #[error("{0} cannot be solved by several processes")]
    NotShared(String),
    /// A result could not be taken, for instance written.
    #[error(transparent)]
    Sink(#[from] std::io::Error),
}
