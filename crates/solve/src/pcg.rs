//! Conjugate gradients for one right-hand side, preconditioned with a factor.
//!
//! The intended use is the finish of a direct solve whose matrix was rounded when
//! it was assembled. The operator evaluates the products without that rounding,
//! the factor of the rounded matrix is the preconditioner, and the iteration
//! converges to the solution of the operator even where the factor alone has no
//! correct digit.
//!
//! Two details concern rounding:
//!
//! * a substitution with a badly conditioned factor is not quite a fixed linear
//!   map, so the new direction is made conjugate to the last one explicitly,
//!   `beta = -(z . q) / (p . q)`, which needs no extra vector. The residual is
//!   only ever updated: evaluating it afresh from a rounded `x` would lose what
//!   the iteration gained;
//! * `r . z` may end by wandering about a floor, or turn negative there. Below
//!   1e-24 of its first value this counts as converged.

mod report;

use crate::sums::{dot, dot_pair};
use crate::{LinearOperator, Preconditioner};
use pulp::Arch;
use report::Watch;
pub use report::{PcgOptions, PcgReport, PcgStatus};

/// The vectors of the iteration, kept from one right-hand side to the next.
#[derive(Debug, Clone)]
pub struct Pcg {
    residual: Vec<f64>,
    preconditioned: Vec<f64>,
    direction: Vec<f64>,
    image: Vec<f64>,
}

impl Pcg {
    /// Vectors of length `size`, four of them.
    #[must_use]
    pub fn new(size: usize) -> Self {
        Self {
            residual: vec![0.0; size],
            preconditioned: vec![0.0; size],
            direction: vec![0.0; size],
            image: vec![0.0; size],
        }
    }

    /// Solves `A x = b` from `x = 0`; `x` is overwritten.
    ///
    /// The last iterate is returned whatever the status: every step lowers the
    /// energy `x . A x / 2 - b . x`, so no earlier one is better. A zero
    /// right-hand side gives `x = 0` after no iterations.
    ///
    /// # Panics
    ///
    /// If the lengths differ.
    pub fn solve(
        &mut self,
        op: &dyn LinearOperator,
        m: &mut dyn Preconditioner,
        b: &[f64],
        x: &mut [f64],
        options: &PcgOptions,
    ) -> PcgReport {
        let size = self.residual.len();
        let lengths = [op.size(), m.size(), b.len(), x.len()];
        assert!(lengths.iter().all(|l| *l == size), "vectors of one length");
        x.fill(0.0);
        let mut watch = Watch::new(options);
        if b.iter().all(|v| *v == 0.0) {
            return watch.report(PcgStatus::Converged);
        }
        self.residual.copy_from_slice(b);
        m.apply(&self.residual, &mut self.preconditioned);
        let mut rz = dot(&self.residual, &self.preconditioned);
        if let Some(status) = watch.start(rz) {
            return watch.report(status);
        }
        std::mem::swap(&mut self.direction, &mut self.preconditioned);
        loop {
            op.apply(&self.direction, &mut self.image);
            let curvature = dot(&self.direction, &self.image);
            if let Some(status) = watch.curvature(curvature) {
                return watch.report(status);
            }
            let step = rz / curvature;
            subtract(&mut self.residual, step, &self.image);
            m.apply(&self.residual, &mut self.preconditioned);
            let (next, overlap) = dot_pair(&self.preconditioned, &self.residual, &self.image);
            if let Some(status) = watch.step(step, rz, next) {
                add(x, step, &self.direction);
                return watch.report(status);
            }
            let beta = -overlap / curvature;
            advance(x, step, &mut self.direction, beta, &self.preconditioned);
            rz = next;
        }
    }
}

/// `y -= a x`
fn subtract(y: &mut [f64], a: f64, x: &[f64]) {
    add(y, -a, x);
}

/// `y += a x`
fn add(y: &mut [f64], a: f64, x: &[f64]) {
    Arch::new().dispatch(
        #[inline(always)]
        || {
            for (y, x) in y.iter_mut().zip(x) {
                *y += a * x;
            }
        },
    );
}

/// `x += step p` and `p = z + beta p`, in one pass over `p`.
fn advance(x: &mut [f64], step: f64, p: &mut [f64], beta: f64, z: &[f64]) {
    Arch::new().dispatch(
        #[inline(always)]
        || {
            for ((x, p), z) in x.iter_mut().zip(p.iter_mut()).zip(z) {
                *x += step * *p;
                *p = z + beta * *p;
            }
        },
    );
}

#[cfg(test)]
mod tests;
