//! Conjugate gradients for one right-hand side, preconditioned with a factor or a multigrid cycle.
//!
//! One use is the finish of a direct solve whose matrix was rounded when
//! it was assembled. The operator evaluates the products without that rounding,
//! the factor of the rounded matrix is the preconditioner, and the iteration
//! converges to the solution of the operator even where the factor alone has no
//! correct digit. The other is the whole solve where the matrix is too large to factor; a step
//! leaves a tenth to a hundredth of `r . z` then, and a wanted number of digits is asked for by [`PcgOptions::energy_drop`] or
//! [`PcgOptions::residual_drop`].
//!
//! Two details concern rounding:
//!
//! * the residual is only ever updated: evaluating it afresh from a rounded `x` would lose what the iteration gained.
//!   Making every direction conjugate to the last explicitly, `beta = -(z . q) / (p . q)`, costs one more vector, gains no
//!   digit on beams of a million points, and breaks down where one step reaches the solution;
//! * `r . z` may end by wandering about a floor, or turn negative there. Below 1e-24 of the energy of the solution this
//!   counts as converged.

mod lanczos;
mod reduced;
mod report;

use crate::{LinearOperator, Preconditioner};
use peristat_vector::{add, advance, dot, subtract};
pub use reduced::ReducedPcg;
use report::Watch;
pub use report::{PcgOptions, PcgReport, PcgStatus};

/// The vectors of the iteration, kept from one right-hand side to the next.
#[derive(Debug, Clone)]
pub struct Pcg {
    direction: Vec<f64>,
    /// `A p` until the residual has taken it, then `M^-1 r`.
    image: Vec<f64>,
}

impl Pcg {
    /// Vectors of length `size`, two of them.
    #[must_use]
    pub fn new(size: usize) -> Self {
        Self { direction: vec![0.0; size], image: vec![0.0; size] }
    }

    /// `M^-1 r` in a vector of the iteration, valid until the next call: the correction that the preconditioner alone
    /// would make.
    pub fn precondition(&mut self, m: &mut dyn Preconditioner, r: &[f64]) -> &mut [f64] {
        m.apply(r, &mut self.image);
        &mut self.image
    }

    /// The vectors of the iteration, to be written over between two solutions.
    pub fn scratch(&mut self) -> [&mut [f64]; 2] {
        [&mut self.direction, &mut self.image]
    }

    /// Adds to `x` the solution `d` of `A d = residual` and leaves the residual of the sum in `residual`.
    ///
    /// With `x = 0` and the right-hand side as `residual` this solves `A x = b`. The last iterate is returned whatever
    /// the status: every step lowers the energy `d . A d / 2 - residual . d`, so no earlier one is better. A zero
    /// residual adds nothing after no iterations.
    ///
    /// # Panics
    ///
    /// If the lengths differ.
    pub fn solve(
        &mut self,
        op: &dyn LinearOperator,
        m: &mut dyn Preconditioner,
        residual: &mut [f64],
        x: &mut [f64],
        options: &PcgOptions,
    ) -> PcgReport {
        let size = self.direction.len();
        let lengths = [op.size(), m.size(), residual.len(), x.len()];
        assert!(lengths.iter().all(|l| *l == size), "vectors of one length");
        let mut watch = Watch::new(options);
        if residual.iter().all(|v| *v == 0.0) {
            return watch.report(PcgStatus::Converged);
        }
        m.apply(residual, &mut self.direction);
        let mut rz = dot(residual, &self.direction);
        if let Some(status) = watch.start(rz, || dot(residual, residual)) {
            return watch.report(status);
        }
        loop {
            op.apply(&self.direction, &mut self.image);
            let curvature = dot(&self.direction, &self.image);
            if let Some(status) = watch.curvature(curvature) {
                return watch.report(status);
            }
            let step = rz / curvature;
            subtract(residual, step, &self.image);
            let next = watch.foretell(|| dot(residual, residual)).unwrap_or_else(|| {
                m.apply(residual, &mut self.image);
                dot(residual, &self.image)
            });
            if let Some(status) = watch.step(step, rz, next) {
                add(x, step, &self.direction);
                return watch.report(status);
            }
            advance(x, step, &mut self.direction, next / rz, &self.image);
            rz = next;
        }
    }
}

#[cfg(test)]
mod tests;
