//! Cholesky factor of a sparse symmetric matrix with a fill-reducing ordering.

mod ordering;

use crate::{FactorError, Preconditioner};
use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::linalg::cholesky::llt::factor::LltError;
use faer::perm::PermRef;
use faer::sparse::linalg::cholesky::{
    LltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering, factorize_symbolic_cholesky,
};
use faer::sparse::{FaerError, SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side};
pub use ordering::Ordering;
pub(crate) use ordering::coupled;
use sprs::CsMat;

/// `A = L L^T` of a sparse matrix in a fill-reducing order.
///
/// The ordering and the structure of `L` are found once per pattern; the values
/// may be replaced as often as wanted without further allocation.
///
/// Matrices are handed over in compressed rows, either whole or only the lower
/// triangle; entries above the diagonal are not read.
pub struct SparseCholesky {
    symbolic: SymbolicCholesky<usize>,
    fingerprint: u64,
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
        check_square(pattern)?;
        let order = match ordering {
            Ordering::MinimumDegree => None,
            Ordering::Points { order, components } => Some(ordering::unknowns(pattern, order, components)?),
        };
        let symbolic = symbolic(pattern, order.as_deref())?;
        let values = zeros(symbolic.len_val())?;
        let factor_need = symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default());
        let solve_need = symbolic.solve_in_place_scratch::<f64>(1, Par::Seq);
        Ok(Self {
            fingerprint: fingerprint(pattern),
            values,
            factor_scratch: buffer(factor_need)?,
            solve_scratch: buffer(solve_need)?,
            scratch_bytes: factor_need.size_bytes() + solve_need.size_bytes(),
            symbolic,
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
        assert_eq!(fingerprint(values), self.fingerprint, "the matrix has the analysed pattern");
        self.ready = false;
        check_finite(values)?;
        let (symbolic, factor) = (&self.symbolic, &mut self.values);
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
        let position = match self.symbolic.raw() {
            SymbolicCholeskyRaw::Simplicial(_) => position.saturating_sub(1),
            SymbolicCholeskyRaw::Supernodal(_) => position,
        };
        let index =
            self.symbolic.perm().and_then(|perm| perm.arrays().0.get(position).copied()).unwrap_or(position);
        FactorError::NonPositivePivot { index, count: 1 }
    }
}

impl std::fmt::Debug for SparseCholesky {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("SparseCholesky")
            .field("order", &self.symbolic.nrows())
            .field("fill", &self.fill())
            .field("ready", &self.ready)
            .finish()
    }
}

impl Preconditioner for SparseCholesky {
    fn size(&self) -> usize {
        self.symbolic.nrows()
    }

    /// # Panics
    ///
    /// If no matrix has been factored since the analysis or the last failure.
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        assert!(self.ready, "a matrix has been factored");
        z.copy_from_slice(r);
        let order = z.len();
        LltRef::new(&self.symbolic, &self.values[..]).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(z, order, 1),
            Par::Seq,
            MemStack::new(&mut self.solve_scratch),
        );
    }
}

/// Structure of the factor in a given order of the unknowns, or by minimum degree.
fn symbolic(pattern: &CsMat<f64>, order: Option<&[usize]>) -> Result<SymbolicCholesky<usize>, FactorError> {
    let mut places = vec![0; order.map_or(0, <[usize]>::len)];
    for (place, unknown) in order.into_iter().flatten().enumerate() {
        places[*unknown] = place;
    }
    let ordering = match order {
        None => SymmetricOrdering::Amd,
        Some(order) => SymmetricOrdering::Custom(PermRef::new_checked(order, &places, order.len())),
    };
    with_columns(pattern, |matrix| {
        factorize_symbolic_cholesky(matrix.symbolic(), Side::Upper, ordering, Default::default())
    })
    .map_err(|error| out_of_memory(&error, 0))
}

pub(crate) fn check_square(pattern: &CsMat<f64>) -> Result<(), FactorError> {
    let (rows, columns) = pattern.shape();
    if rows == columns {
        return Ok(());
    }
    Err(FactorError::Shape { reason: format!("{rows} rows and {columns} columns") })
}

/// Zeros, if there is memory for them; it is taken when they are first written.
pub(crate) fn zeros(count: usize) -> Result<Vec<f64>, FactorError> {
    let bytes = count.saturating_mul(size_of::<f64>());
    let mut values: Vec<f64> = Vec::new();
    values.try_reserve_exact(count).map_err(|_| FactorError::OutOfMemory { bytes })?;
    drop(values);
    Ok(vec![0.0; count])
}

pub(crate) fn buffer(need: StackReq) -> Result<MemBuffer, FactorError> {
    MemBuffer::try_new(need).map_err(|_| FactorError::OutOfMemory { bytes: need.size_bytes() })
}

/// Compressed rows of the lower triangle are compressed columns of the upper one.
fn with_columns<T>(matrix: &CsMat<f64>, then: impl FnOnce(SparseColMatRef<'_, usize, f64>) -> T) -> T {
    let starts = matrix.proper_indptr();
    let order = matrix.outer_dims();
    let pattern = SymbolicSparseColMatRef::new_checked(order, order, &starts, None, matrix.indices());
    then(SparseColMatRef::new(pattern, matrix.data()))
}

pub(crate) fn check_finite(matrix: &CsMat<f64>) -> Result<(), FactorError> {
    for (index, row) in matrix.outer_iterator().enumerate() {
        let mut lower = row.iter().take_while(|(column, _)| *column <= index);
        if lower.any(|(_, value)| !value.is_finite()) {
            return Err(FactorError::NotFinite { index });
        }
    }
    Ok(())
}

/// A number that tells patterns apart, cheaper to keep than the pattern.
pub(crate) fn fingerprint(matrix: &CsMat<f64>) -> u64 {
    // Multiplication by an odd number and a rotation: no entry is lost.
    let mix =
        |sum: u64, value: usize| (sum ^ value as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(29);
    let starts = matrix.proper_indptr();
    let sum = starts.iter().fold(starts.len() as u64, |s, v| mix(s, *v));
    matrix.indices().iter().fold(sum, |s, v| mix(s, *v))
}

pub(crate) fn out_of_memory(error: &FaerError, bytes: usize) -> FactorError {
    match error {
        FaerError::OutOfMemory => FactorError::OutOfMemory { bytes },
        other => FactorError::Shape { reason: format!("{other:?}") },
    }
}

#[cfg(test)]
mod tests;
