//! A solver whose work several processes share.

use super::solver_report::SolverReport;
use peristat_solve::{PcgOptions, PcgReport, Preconditioner};

/// Conjugate gradients over several processes, of which this one has whole vectors; what they are preconditioned with is one, too.
pub(super) trait SharedSolver: Preconditioner {
    /// Adds to `x` the solution of `A d = residual`.
    fn solve(&mut self, residual: &[f64], x: &mut [f64], options: &PcgOptions) -> PcgReport;

    /// What it is.
    fn report(&self) -> SolverReport;
}
