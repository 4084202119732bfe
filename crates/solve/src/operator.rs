//! The two roles a matrix plays in an iterative solve.

/// A symmetric linear map from vectors of length `size` to such vectors.
pub trait LinearOperator {
    /// Length of the vectors.
    fn size(&self) -> usize;

    /// Writes `A x` over `y`; both have length [`size`](Self::size).
    fn apply(&self, x: &[f64], y: &mut [f64]);
}

/// An approximate inverse of a [`LinearOperator`], symmetric; conjugate gradients need a positive definite one.
pub trait Preconditioner<R = f64> {
    /// Length of the vectors.
    fn size(&self) -> usize;

    /// Writes `M^-1 r` over `z`; both have length [`size`](Self::size).
    ///
    /// The receiver is mutable so that it may keep scratch space.
    fn apply(&mut self, r: &[R], z: &mut [R]);
}
