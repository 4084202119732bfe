//! What can go wrong when a matrix is factored.

use thiserror::Error;

/// Why a matrix has no usable factor.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum FactorError {
    /// A pivot is zero or negative: the matrix is not positive definite.
    #[error(
        "the matrix is not positive definite: pivot of unknown {index} is not positive ({count} such pivots)"
    )]
    NonPositivePivot {
        /// The first unknown with such a pivot, counted as in the vectors handed
        /// to the solver, not as in the order of elimination.
        index: usize,
        /// How many pivots are not positive. The band factor counts them all, which
        /// is the number of negative eigenvalues (Sylvester) unless a pivot is
        /// exactly zero; the sparse factor stops at the first and reports 1.
        count: usize,
    },
    /// A pivot is zero: the matrix has no inverse.
    #[error("the matrix is singular: the pivot of unknown {index} is zero")]
    Singular {
        /// The first unknown with such a pivot, counted as in the vectors; of a matrix that was changed
        /// after it was factored, an unknown of the change that makes it singular.
        index: usize,
    },
    /// A pivot, or an entry of the matrix, is infinite or not a number.
    #[error("the matrix has an entry that is not finite in the row of unknown {index}")]
    NotFinite {
        /// The first unknown concerned, counted as in the vectors.
        index: usize,
    },
    /// The factor does not fit into memory.
    #[error("out of memory: the factor needs {bytes} bytes")]
    OutOfMemory {
        /// Size of the request that failed, in bytes; 0 where it is not known.
        bytes: usize,
    },
    /// The matrix has a shape that the factorisation cannot take.
    #[error("the matrix has an unusable shape: {reason}")]
    Shape {
        /// What is wrong, with the numbers.
        reason: String,
    },
}
