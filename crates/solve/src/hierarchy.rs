//! What a multigrid cycle asks of its levels.
//!
//! Every level `l` has vectors of its own length, a symmetric positive definite operator `A_l`, and a block diagonal
//! symmetric positive definite matrix `M_l` that stands in for it. Where the coarser operators come from (the same
//! problem on a coarser lattice, or products of matrices) is the business of whoever implements the trait; so are the
//! threads of its products.
//!
//! The smoother is the three-term Chebyshev iteration on `x` itself,
//!
//! ```text
//! x_2 = x_1 + keep (x_1 - x_0) + scale M^-1 (b - A x_1)
//! ```
//!
//! rather than on residuals and increments: it reads three vectors and writes one, which can all be done by the loop
//! that evaluates the product.

use peristat_vector::Real;
use peristat_vector::{extrapolate, subtract_from};

/// The coefficients of a step of the smoother.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Relaxation {
    /// How much of the last change is made again.
    pub keep: f64,
    /// How much of `M^-1 r` is added.
    pub scale: f64,
}

/// Levels of a symmetric positive definite problem; level 0 is the finest.
///
/// An unknown may be held at zero instead of being left out: `A` and `M^-1` and both transfers then write or add zero
/// there.
pub trait Hierarchy: Sync {
    /// What the numbers of its vectors are.
    type Real: Real;

    /// Number of levels, at least 1.
    fn depth(&self) -> usize;

    /// Length of the vectors of a level.
    fn size(&self, level: usize) -> usize;

    /// `Σ a·b` over the unknowns of a level.
    fn dot(&self, _level: usize, a: &[Self::Real], b: &[Self::Real]) -> f64 {
        Real::dot(a, b)
    }

    /// Writes `A x` over `y`.
    fn apply(&self, level: usize, x: &[Self::Real], y: &mut [Self::Real]);

    /// `x += scale M^-1 r`
    fn smooth(&self, level: usize, scale: f64, r: &[Self::Real], x: &mut [Self::Real]);

    /// Writes `b - A x` over `r`.
    fn residual(&self, level: usize, b: &[Self::Real], x: &[Self::Real], r: &mut [Self::Real]) {
        self.apply(level, x, r);
        subtract_from(b, r);
    }

    /// Writes `x + keep (x - previous) + scale M^-1 (b - A x)` over `previous`.
    ///
    /// The default makes one pass per operation, with `scratch` for the residual. One pass does where the entries of the
    /// product are used as they arise; `scratch` may be left alone then.
    fn relax(
        &self,
        level: usize,
        step: Relaxation,
        b: &[Self::Real],
        x: &[Self::Real],
        previous: &mut [Self::Real],
        scratch: &mut [Self::Real],
    ) {
        self.residual(level, b, x, scratch);
        extrapolate(previous, step.keep, x);
        self.smooth(level, step.scale, scratch, previous);
    }

    /// Writes over `coarse`, of the next coarser level, what `fine` of this level is there; the transpose of
    /// [`prolong_add`](Self::prolong_add), up to a positive factor.
    fn restrict(&self, level: usize, fine: &[Self::Real], coarse: &mut [Self::Real]);

    /// Adds to `fine`, of this level, the interpolation of `coarse` of the next coarser level.
    fn prolong_add(&self, level: usize, coarse: &[Self::Real], fine: &mut [Self::Real]);
}

impl<H: Hierarchy + ?Sized> Hierarchy for &H {
    type Real = H::Real;

    fn depth(&self) -> usize {
        (**self).depth()
    }
    fn size(&self, level: usize) -> usize {
        (**self).size(level)
    }
    fn dot(&self, level: usize, a: &[H::Real], b: &[H::Real]) -> f64 {
        (**self).dot(level, a, b)
    }
    fn apply(&self, level: usize, x: &[H::Real], y: &mut [H::Real]) {
        (**self).apply(level, x, y);
    }
    fn smooth(&self, level: usize, scale: f64, r: &[H::Real], x: &mut [H::Real]) {
        (**self).smooth(level, scale, r, x);
    }
    fn residual(&self, level: usize, b: &[H::Real], x: &[H::Real], r: &mut [H::Real]) {
        (**self).residual(level, b, x, r);
    }
    fn relax(
        &self,
        level: usize,
        step: Relaxation,
        b: &[H::Real],
        x: &[H::Real],
        previous: &mut [H::Real],
        scratch: &mut [H::Real],
    ) {
        (**self).relax(level, step, b, x, previous, scratch);
    }
    fn restrict(&self, level: usize, fine: &[H::Real], coarse: &mut [H::Real]) {
        (**self).restrict(level, fine, coarse);
    }
    fn prolong_add(&self, level: usize, coarse: &[H::Real], fine: &mut [H::Real]) {
        (**self).prolong_add(level, coarse, fine);
    }
}
