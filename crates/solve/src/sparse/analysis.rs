//! What the factors of one pattern have in common.

use super::{Ordering, ordering};
use crate::FactorError;
use faer::Side;
use faer::dyn_stack::{MemBuffer, StackReq};
use faer::perm::PermRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{FaerError, SparseColMatRef, SymbolicSparseColMatRef};
use sprs::CsMat;

/// For dense blocks in every factor. The constant of faer leaves out diagonal matrices, and nothing takes in that of
/// order zero.
pub(super) const ALWAYS_BLOCKS: SupernodalThreshold = SupernodalThreshold(-1.0);

/// Order of the unknowns and structure of the factor.
#[derive(Debug)]
pub(super) struct Analysis {
    pub(super) symbolic: SymbolicCholesky<usize>,
    fingerprint: u64,
}

impl Analysis {
    /// In dense blocks only where `threshold` says that they pay.
    pub(super) fn new(
        pattern: &CsMat<f64>,
        ordering: Ordering<'_>,
        threshold: SupernodalThreshold,
    ) -> Result<Self, FactorError> {
        check_square(pattern)?;
        let order = match ordering {
            Ordering::MinimumDegree => None,
            Ordering::MinimumDegreeOfPoints { components } => {
                let order = ordering::by_degree(pattern, components)?;
                Some(ordering::unknowns(pattern, &order, components)?)
            }
            Ordering::Points { order, components } => Some(ordering::unknowns(pattern, order, components)?),
        };
        Self::in_order(pattern, order.as_deref(), threshold)
    }

    /// The same order of the unknowns with dense blocks, however small they are.
    pub(super) fn blocked(&self, pattern: &CsMat<f64>) -> Result<Self, FactorError> {
        self.check(pattern);
        let order = self.symbolic.perm().map(|perm| perm.arrays().0);
        Self::in_order(pattern, order, ALWAYS_BLOCKS)
    }

    /// A given order of the unknowns, or by minimum degree.
    fn in_order(
        pattern: &CsMat<f64>,
        order: Option<&[usize]>,
        threshold: SupernodalThreshold,
    ) -> Result<Self, FactorError> {
        let mut places = vec![0; order.map_or(0, <[usize]>::len)];
        for (place, unknown) in order.into_iter().flatten().enumerate() {
            places[*unknown] = place;
        }
        let ordering = match order {
            None => SymmetricOrdering::Amd,
            Some(order) => SymmetricOrdering::Custom(PermRef::new_checked(order, &places, order.len())),
        };
        let parameters =
            CholeskySymbolicParams { supernodal_flop_ratio_threshold: threshold, ..Default::default() };
        let symbolic = with_columns(pattern, |matrix| {
            factorize_symbolic_cholesky(matrix.symbolic(), Side::Upper, ordering, parameters)
        })
        .map_err(|error| out_of_memory(&error, 0))?;
        Ok(Self { symbolic, fingerprint: fingerprint(pattern) })
    }

    /// # Panics
    ///
    /// If the matrix has another pattern.
    pub(super) fn check(&self, matrix: &CsMat<f64>) {
        assert_eq!(fingerprint(matrix), self.fingerprint, "the matrix has the analysed pattern");
    }

    /// Whether the factor consists of dense blocks.
    pub(super) fn has_blocks(&self) -> bool {
        matches!(self.symbolic.raw(), SymbolicCholeskyRaw::Supernodal(_))
    }

    /// The unknown at a position in the order of elimination.
    pub(super) fn unknown(&self, position: usize) -> usize {
        self.symbolic.perm().and_then(|perm| perm.arrays().0.get(position).copied()).unwrap_or(position)
    }
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
pub(super) fn with_columns<T>(
    matrix: &CsMat<f64>,
    then: impl FnOnce(SparseColMatRef<'_, usize, f64>) -> T,
) -> T {
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
