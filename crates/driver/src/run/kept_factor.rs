//! A factor that is kept while its system changes, and made anew of values alone.

use super::factor::{self, SparseFactor, lifted};
use super::solve_failure::SolveFailure;
use super::{Counters, Problem, Timing};
use peristat_assembly::system::System;
use peristat_solve::{DissectedCholesky, Preconditioner};
use sprs::{CsMat, TriMat};
use std::time::Instant;

/// Lifts of the diagonal over its largest entry: parts that have nearly come off are held by next to nothing.
const LIFTS: [f64; 5] = [0.0, f64::EPSILON, 8.0 * f64::EPSILON, 1e-12, 1e-8];

/// A sparse factor and the matrix that it was made of; later matrices have no entries where this one has none.
pub(super) struct KeptFactor {
    matrix: CsMat<f64>,
    factor: SparseFactor,
    /// Positions of points that spread in a plane.
    positions: Option<Vec<[f64; 2]>>,
}

impl KeptFactor {
    /// Analyses and factors a system.
    ///
    /// # Errors
    /// [`SolveFailure`] if it has no factor.
    pub(super) fn new<const D: usize>(
        problem: &dyn Problem<D>,
        system: &System<D>,
        timing: &mut Timing,
        counters: &mut Counters,
    ) -> Result<Self, SolveFailure> {
        Self::analyse(problem.positions(), system, timing, counters)
    }

    fn analyse<const D: usize>(
        positions: Option<Vec<[f64; 2]>>,
        system: &System<D>,
        timing: &mut Timing,
        counters: &mut Counters,
    ) -> Result<Self, SolveFailure> {
        let begin = Instant::now();
        let matrix = whole_blocks::<D>(&system.assemble_sparse());
        timing.assemble += begin.elapsed().as_secs_f64();
        let begin = Instant::now();
        counters.analyses += 1;
        let factor =
            SparseFactor::analyse::<D>(&matrix, positions.as_deref()).map_err(SolveFailure::Factor)?;
        let mut kept = Self { matrix, factor, positions };
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
            match self.matrix.get_mut(row, column) {
                Some(entry) => *entry = value,
                None if value == 0.0 => {}
                // Constraints that came later may tie unknowns to others than before.
                None => {
                    *self = Self::analyse(self.positions.take(), system, timing, counters)?;
                    return Ok(());
                }
            }
        }
        timing.assemble += begin.elapsed().as_secs_f64();
        let begin = Instant::now();
        let done = self.refactor(system, counters);
        timing.factor += begin.elapsed().as_secs_f64();
        done
    }

    /// The factor if it is one by halves.
    pub(super) fn dissected(&mut self) -> Option<&mut DissectedCholesky> {
        match &mut self.factor {
            SparseFactor::Dissected(factor) => Some(factor),
            SparseFactor::Whole(_) => None,
        }
    }

    fn refactor<const D: usize>(
        &mut self,
        system: &System<D>,
        counters: &mut Counters,
    ) -> Result<(), SolveFailure> {
        let diagonal = self.matrix.diag();
        // A point that hangs on a single bond has next to nothing, of which no part lifts it.
        let largest = diagonal.iter().fold(0.0, |largest: f64, (_, value)| largest.max(*value));
        let done = lifted(&LIFTS, counters, |lift| {
            diagonal.iter().for_each(|(k, value)| self.matrix.set(k, k, value + lift * largest));
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

/// The lower triangle of a matrix with all entries of the blocks of points that it has entries of: where contributions of
/// bonds cancel, they no longer do when some of these break.
fn whole_blocks<const D: usize>(matrix: &CsMat<f64>) -> CsMat<f64> {
    let points = matrix.rows() / D;
    let mut pairs: Vec<[usize; 2]> =
        matrix.iter().map(|(_, (row, column))| [row % points, column % points]).collect();
    pairs.iter_mut().for_each(|pair| pair.sort_unstable());
    pairs.sort_unstable();
    pairs.dedup();
    let mut whole = TriMat::with_capacity(matrix.shape(), matrix.nnz() + pairs.len() * D * D);
    for [i, j] in pairs {
        for (a, b) in (0..D).flat_map(|r| (0..D).map(move |c| (r * points + i, c * points + j))) {
            whole.add_triplet(a.max(b), a.min(b), 0.0);
        }
    }
    matrix.iter().for_each(|(&value, (row, column))| whole.add_triplet(row, column, value));
    whole.to_csr()
}
