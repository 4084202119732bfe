//! Cholesky factor of a sparse symmetric matrix with a fill-reducing ordering.

mod analysis;
mod indefinite;
mod ordering;

use crate::{FactorError, Preconditioner};
use analysis::{Analysis, with_columns};
pub(crate) use analysis::{buffer, check_finite, check_square, fingerprint, out_of_memory, zeros};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltError;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::LltRef;
use faer::{Conj, MatMut, Par, Side};
pub use indefinite::SparseIndefinite;
pub use ordering::Ordering;
pub(crate) use ordering::coupled;
use sprs::CsMat;
use std::sync::Arc;

/// `A = L L^T` of a sparse matrix in a fill-reducing order.
///
/// The ordering and the structure of `L` are found once per pattern; the values
/// may be replaced as often as wanted without further allocation.
///
/// Matrices are handed over in compressed rows, either whole or only the lower
/// triangle; entries above the diagonal are not read.
pub struct SparseCholesky {
    /// Shared with the factors of other kinds that come from this one.
    analysis: Arc<Analysis>,
    values: Vec<f64>,
    factor_scratch: MemBuffer,
    solve_scratch: MemBuffer,
    /// Bytes of the two scratch buffers.
    scratch_bytes: usize,
    ready: bool,
}

impl SparseCholesky {
    /// Orders the unknowns and finds the structure of the factor. The values are
    /// not read; call [`refactor`](Self::refactor) before the first solve.
    ///
    /// # Errors
    ///
    /// [`FactorError::Shape`] if the matrix is not square or the ordering is not one of its unknowns,
    /// [`FactorError::OutOfMemory`].
    pub fn analyse(pattern: &CsMat<f64>, ordering: Ordering<'_>) -> Result<Self, FactorError> {
        let analysis = Analysis::new(pattern, ordering, SupernodalThreshold::AUTO)?;
        let symbolic = &analysis.symbolic;
        let values = zeros(symbolic.len_val())?;
        let factor_need = symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default());
        let solve_need = symbolic.solve_in_place_scratch::<f64>(1, Par::Seq);
        Ok(Self {
            values,
            factor_scratch: buffer(factor_need)?,
            solve_scratch: buffer(solve_need)?,
            scratch_bytes: factor_need.size_bytes() + solve_need.size_bytes(),
            analysis: Arc::new(analysis),
            ready: false,
        })
    }

    /// Factors a matrix of the analysed pattern.
    ///
    /// # Errors
    ///
    /// [`FactorError::NotFinite`] with the first row that has such an entry in
    /// the lower triangle, [`FactorError::NonPositivePivot`] with the unknown
    /// whose pivot is not positive.
    ///
    /// # Panics
    ///
    /// If the pattern is another one.
    pub fn refactor(&mut self, values: &CsMat<f64>) -> Result<(), FactorError> {
        self.analysis.check(values);
        self.ready = false;
        check_finite(values)?;
        let (symbolic, factor) = (&self.analysis.symbolic, &mut self.values);
        let stack = MemStack::new(&mut self.factor_scratch);
        with_columns(values, |matrix| {
            symbolic
                .factorize_numeric_llt(
                    factor,
                    matrix,
                    Side::Upper,
                    Default::default(),
                    Par::Seq,
                    stack,
                    Default::default(),
                )
                .map(|_| ())
        })
        .map_err(|error| self.explain(error))?;
        self.ready = true;
        Ok(())
    }

    /// Stored entries of `L`, the padding of its dense blocks included.
    #[must_use]
    pub fn fill(&self) -> usize {
        self.values.len()
    }

    /// Memory held by the factor and its scratch space, in bytes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.values.capacity() * size_of::<f64>() + self.scratch_bytes
    }

    /// The unknown behind a failed pivot.
    fn explain(&self, error: LltError) -> FactorError {
        let LltError::NonPositivePivot { index: position } = error;
        // The two kernels of faer count differently: the simplicial one from 1.
        let position = if self.analysis.has_blocks() { position } else { position.saturating_sub(1) };
        let index = self.analysis.unknown(position);
        FactorError::NonPositivePivot { index, count: 1 }
    }
}

impl std::fmt::Debug for SparseCholesky {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("SparseCholesky")
            .field("order", &self.analysis.symbolic.nrows())
            .field("fill", &self.fill())
            .field("ready", &self.ready)
            .finish()
    }
}

impl Preconditioner for SparseCholesky {
    fn size(&self) -> usize {
        self.analysis.symbolic.nrows()
    }

    /// # Panics
    ///
    /// If no matrix has been factored since the analysis or the last failure.
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        assert!(self.ready, "a matrix has been factored");
        z.copy_from_slice(r);
        let order = z.len();
        LltRef::new(&self.analysis.symbolic, &self.values[..]).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(z, order, 1),
            Par::Seq,
            MemStack::new(&mut self.solve_scratch),
        );
    }
}

#[cfg(test)]
mod tests;
