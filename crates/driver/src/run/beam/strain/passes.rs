//! The two passes over memory that solve for strains and sum them up.

use crate::run::SolveFailure;
use peristat_assembly::model::timoshenko_beam::{
    ChainLoads, FromLeft, FromRight, PHI, Resultant, STRAIN_BLOCK, StrainAction, StrainBand, StrainChecks,
    StrainForm, W,
};
use peristat_solve::{RepeatingBand, RepeatingCholesky};

/// A factored strain form. Between the passes the planes of the displacements hold what the first one leaves.
pub(super) struct Passes<'a> {
    form: StrainForm<'a>,
    factor: RepeatingCholesky,
    block: Vec<f64>,
}

impl<'a> Passes<'a> {
    /// Factors the stiffness.
    ///
    /// # Errors
    /// [`SolveFailure`] if it has no factor.
    pub(super) fn new(form: StrainForm<'a>) -> Result<Self, SolveFailure> {
        let StrainBand { half_bandwidth, runs, values } = form.band();
        let factor = RepeatingCholesky::factor(&RepeatingBand { half_bandwidth, period: 2, runs, values })?;
        let block = vec![0.0; 2 * STRAIN_BLOCK.min(form.cells())];
        Ok(Self { form, factor, block })
    }

    /// The strain form.
    pub(super) fn form(&self) -> &StrainForm<'a> {
        &self.form
    }

    /// Memory of the factor, bytes.
    pub(super) fn bytes(&self) -> usize {
        self.factor.bytes()
    }

    /// From the right end to the left: section forces of the loads, first half of the elimination. Returns the resultant
    /// of all forces.
    pub(super) fn leftwards(
        &mut self,
        loads: Option<&ChainLoads>,
        actions: &[StrainAction],
        u: &mut [f64],
    ) -> Resultant {
        let (cells, points) = (self.form.cells(), self.form.cells() + 1);
        let (mut sums, mut forward) = (FromRight::new(&self.form, loads, actions), self.factor.forward());
        let (theta, g) = u.split_at_mut(points);
        let mut end = cells;
        while end > 0 {
            let start = end.saturating_sub(STRAIN_BLOCK);
            let block = &mut self.block[..2 * (end - start)];
            sums.sweep(block);
            forward.sweep(block);
            let pairs = block.as_chunks::<2>().0.iter().rev();
            for ((pair, theta), g) in pairs.zip(&mut theta[start..end]).zip(&mut g[start..end]) {
                [*theta, *g] = *pair;
            }
            end = start;
        }
        sums.finish()
    }

    /// From the left end to the right: second half of the elimination, displacements from `start` on.
    pub(super) fn rightwards(
        &mut self,
        loads: Option<&ChainLoads>,
        actions: &[StrainAction],
        start: [f64; 2],
        u: &mut [f64],
    ) -> StrainChecks {
        let (cells, points) = (self.form.cells(), self.form.cells() + 1);
        let (mut sums, mut backward) =
            (FromLeft::new(&self.form, loads, actions, start), self.factor.backward());
        let (w, phi) = u.split_at_mut(points);
        for start in (0..cells).step_by(STRAIN_BLOCK) {
            let end = (start + STRAIN_BLOCK).min(cells);
            let block = &mut self.block[..2 * (end - start)];
            let (w, phi) = (&mut w[start..end], &mut phi[start..end]);
            let pairs = block.as_chunks_mut::<2>().0.iter_mut().rev();
            for ((pair, theta), g) in pairs.zip(&*w).zip(&*phi) {
                *pair = [*theta, *g];
            }
            backward.sweep(block);
            sums.sweep(block, [w, phi]);
        }
        let (last, checks) = sums.finish();
        (w[cells], phi[cells]) = (last[W], last[PHI]);
        checks
    }
}
