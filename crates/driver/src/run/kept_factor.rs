//! A factor that is kept while its system changes, and made anew of values alone.

use super::factor::{self, SolveFailure, SparseFactor, lifted};
use super::{Counters, Problem, Timing};
use peristat_assembly::system::System;
use peristat_solve::Preconditioner;
use sprs::CsMat;
use std::time::Instant;

/// Relative lifts of the diagonal: parts that have nearly come off are held by next to nothing.
const LIFTS: [f64; 5] = [0.0, f64::EPSILON, 8.0 * f64::EPSILON, 1e-12, 1e-8];

/// A sparse factor and the matrix that it was made of; later matrices have no entries where this one has none.
pub(super) struct KeptFactor {
    matrix: CsMat<f64>,
    factor: SparseFactor,
}

impl KeptFactor {
    /// Analyses and factors a system.
    ///
    /// # Errors
    /// [`SolveFailure`] if it has no factor.
    pub(super) fn new<const D: usize, P: Problem<D>>(
        problem: &P,
        system: &System<D>,
        timing: &mut Timing,
        counters: &mut Counters,
    ) -> Result<Self, SolveFailure> {
        let begin = Instant::now();
        let matrix = system.assemble_sparse();
        timing.assemble += begin.elapsed().as_secs_f64();
        let begin = Instant::now();
        counters.analyses += 1;
        let positions = problem.positions();
        let factor =
            SparseFactor::analyse::<D>(&matrix, positions.as_deref()).map_err(SolveFailure::Factor)?;
        let mut kept = Self { matrix, factor };
        kept.refactor(system, counters)?;
        timing.factor += begin.elapsed().as_secs_f64();
        Ok(kept)
    }

    /// Factors the system as it is now: bonds that broke leave zeros behind.
    ///
    /// # Errors
    /// [`SolveFailure`] if it has no factor.
    pub(super) fn refill<const D: usize>(
        &mut self,
        system: &System<D>,
        timing: &mut Timing,
        counters: &mut Counters,
    ) -> Result<(), SolveFailure> {
        let begin = Instant::now();
        self.matrix.data_mut().fill(0.0);
        for (&value, (row, column)) in &system.assemble_sparse() {
            // Constraints that came later only take entries away.
            if let Some(entry) = self.matrix.get_mut(row, column) {
                *entry = value;
            }
        }
        timing.assemble += begin.elapsed().as_secs_f64();
        let begin = Instant::now();
        let done = self.refactor(system, counters);
        timing.factor += begin.elapsed().as_secs_f64();
        done
    }

    fn refactor<const D: usize>(
        &mut self,
        system: &System<D>,
        counters: &mut Counters,
    ) -> Result<(), SolveFailure> {
        let diagonal = self.matrix.diag();
        let done = lifted(&LIFTS, counters, |lift| {
            diagonal.iter().for_each(|(k, value)| self.matrix.set(k, k, value * (1.0 + lift)));
            self.factor.refactor(&self.matrix)
        });
        counters.factor_bytes = self.factor.bytes();
        done.map_err(|e| factor::failure(system, e))
    }
}

impl Preconditioner for KeptFactor {
    fn size(&self) -> usize {
        self.matrix.rows()
    }

    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        self.factor.apply(r, z);
    }
}
