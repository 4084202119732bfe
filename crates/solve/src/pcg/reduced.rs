//! Conjugate gradients where a matrix differs from a factored one among a few unknowns.

use super::report::{PcgOptions, PcgReport, PcgStatus, Watch};
use crate::{DissectedCholesky, Reach};
use peristat_vector::{add, dot, subtract};

/// Solves `(M - G) x = b`, where `M` is factored, and `G` and `b` are zero beside the unknowns of a [`Reach`].
///
/// These are the iterates of [`Pcg`](super::Pcg) with `M^-1` as the preconditioner. As `M M^-1 r = r`, the product with a direction
/// `p = z + beta p'` is `q - G p`, with `q = r + beta q'`: residuals stay among those unknowns, and no step needs the others. They
/// follow at the end from `x = M^-1 s`, where `s` is the sum of the steps along `q`.
#[derive(Debug)]
pub struct ReducedPcg<'a> {
    factor: &'a mut DissectedCholesky,
    reach: &'a Reach,
}

impl<'a> ReducedPcg<'a> {
    /// With a factor of `M` and the reach in it of the unknowns that `G` has entries of.
    pub fn new(factor: &'a mut DissectedCholesky, reach: &'a Reach) -> Self {
        Self { factor, reach }
    }

    /// Writes the solution of all unknowns to `x`, and leaves the residual among those of the reach in `residual`, which begins as the
    /// right-hand side. `lost` writes `G p` over its second vector; it and `residual` have entries for the unknowns of the reach alone.
    ///
    /// # Panics
    ///
    /// If the lengths differ.
    pub fn solve(
        &mut self,
        lost: &mut dyn FnMut(&[f64], &mut [f64]),
        residual: &mut [f64],
        x: &mut [f64],
        options: &PcgOptions,
    ) -> PcgReport {
        let size = self.reach.unknowns().len();
        assert_eq!(residual.len(), size, "vectors of the unknowns of the reach");
        let mut sum = vec![0.0; size];
        let report = self.iterate(lost, residual, &mut sum, options);
        self.factor.apply_from(self.reach, &sum, x);
        report
    }

    fn iterate(
        &mut self,
        lost: &mut dyn FnMut(&[f64], &mut [f64]),
        residual: &mut [f64],
        sum: &mut [f64],
        options: &PcgOptions,
    ) -> PcgReport {
        let mut watch = Watch::new(options);
        if residual.iter().all(|v| *v == 0.0) {
            return watch.report(PcgStatus::Converged);
        }
        let [mut direction, mut corrected, mut gone] = [0; 3].map(|_| vec![0.0; residual.len()]);
        let mut preimage = residual.to_vec();
        self.factor.apply_within(self.reach, residual, &mut direction);
        let mut rz = dot(residual, &direction);
        if let Some(status) = watch.start(rz, || dot(residual, residual)) {
            return watch.report(status);
        }
        loop {
            lost(&direction, &mut gone);
            let curvature = dot(&direction, &preimage) - dot(&direction, &gone);
            if let Some(status) = watch.curvature(curvature) {
                return watch.report(status);
            }
            let step = rz / curvature;
            subtract(residual, step, &preimage);
            add(residual, step, &gone);
            add(sum, step, &preimage);
            let next = watch.foretell(|| dot(residual, residual)).unwrap_or_else(|| {
                self.factor.apply_within(self.reach, residual, &mut corrected);
                dot(residual, &corrected)
            });
            if let Some(status) = watch.step(step, rz, next) {
                return watch.report(status);
            }
            let ratio = next / rz;
            direction.iter_mut().zip(&corrected).for_each(|(p, z)| *p = z + ratio * *p);
            preimage.iter_mut().zip(&*residual).for_each(|(q, r)| *q = r + ratio * *q);
            rz = next;
        }
    }
}

#[cfg(test)]
mod tests;
