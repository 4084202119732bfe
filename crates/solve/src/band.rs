//! Cholesky factor of a symmetric band matrix, in place.

mod blocked;
mod factor;
mod general;
mod pivots;
mod substitute;
mod window;

use crate::{FactorError, Preconditioner};

pub(crate) use pivots::Pivots;

/// The lower triangle of a symmetric band matrix by columns.
///
/// `values[j * (half_bandwidth + 1) + k]` is `A[j + k, j]`: LAPACK's lower band
/// layout with `ldab = half_bandwidth + 1`. Entries that would lie past the last
/// row are zero.
#[derive(Debug, Clone, PartialEq)]
pub struct BandMatrix {
    /// Number of rows.
    pub order: usize,
    /// Largest distance of a non-zero entry from the diagonal.
    pub half_bandwidth: usize,
    /// `order * (half_bandwidth + 1)` entries.
    pub values: Vec<f64>,
}

impl BandMatrix {
    /// Multiplies the diagonal by `1 + relative`.
    ///
    /// Rounding the entries of a matrix whose condition exceeds 1e16 can push its
    /// smallest eigenvalues below zero. A lift by a few units of rounding (4 times
    /// [`f64::EPSILON`]) makes it positive definite again, and the factor is then
    /// as good a preconditioner for [`Pcg`](crate::Pcg) as any other with that
    /// precision.
    pub fn lift_diagonal(&mut self, relative: f64) {
        for column in self.values.chunks_exact_mut(self.half_bandwidth + 1) {
            column[0] *= 1.0 + relative;
        }
    }
}

/// The factors of `A = L D L^T` of a band matrix, held where the matrix was.
///
/// The vectors of the solve may be stored as `P` component planes while the band
/// interleaves the components: unknown `k` of the matrix is entry
/// `(k % P) * (order / P) + k / P` of a vector. The sweeps read and write the
/// planes directly.
#[derive(Debug, Clone)]
pub struct BandCholesky {
    order: usize,
    half_bandwidth: usize,
    planes: usize,
    /// Column `j` starts with the reciprocal pivot; the entries of `L` follow.
    values: Vec<f64>,
    /// Interleaved vector for the sweeps of a wide band, empty for a narrow one.
    scratch: Vec<f64>,
}

impl BandCholesky {
    /// Factors a matrix; its storage becomes the factor's.
    ///
    /// # Errors
    ///
    /// [`FactorError::NonPositivePivot`] with the number of all such pivots,
    /// [`FactorError::NotFinite`], or [`FactorError::Shape`] if the length of the
    /// values does not fit or `planes` does not divide the order.
    pub fn factor(matrix: BandMatrix, planes: usize) -> Result<Self, FactorError> {
        let mut factor =
            Self { order: 0, half_bandwidth: 0, planes, values: Vec::new(), scratch: Vec::new() };
        factor.refactor(matrix)?;
        Ok(factor)
    }

    /// Replaces the factor by that of another matrix, of any shape.
    ///
    /// # Errors
    ///
    /// As [`factor`](Self::factor); the factor is unusable (of order 0) afterwards.
    pub fn refactor(&mut self, matrix: BandMatrix) -> Result<(), FactorError> {
        self.order = 0;
        self.values = Vec::new();
        check_shape(&matrix, self.planes)?;
        let BandMatrix { order, half_bandwidth, mut values } = matrix;
        let pivots = factor::factor(&mut values, half_bandwidth);
        pivots.verdict(|k| (k % self.planes) * (order / self.planes) + k / self.planes)?;
        self.order = order;
        self.half_bandwidth = half_bandwidth;
        self.values = values;
        if substitute::needs_scratch(half_bandwidth) {
            self.scratch.resize(order, 0.0);
        } else {
            self.scratch = Vec::new();
        }
        Ok(())
    }

    /// Gives the storage back, for the next matrix to be assembled into.
    #[must_use]
    pub fn into_values(self) -> Vec<f64> {
        self.values
    }

    /// Memory held by the factor, in bytes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        (self.values.capacity() + self.scratch.capacity()) * size_of::<f64>()
    }
}

impl Preconditioner for BandCholesky {
    fn size(&self) -> usize {
        self.order
    }

    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        assert_eq!(r.len(), self.order, "one entry per unknown");
        assert_eq!(z.len(), self.order, "one entry per unknown");
        substitute::solve(&self.values, self.half_bandwidth, self.planes, &mut self.scratch, r, z);
    }
}

fn check_shape(matrix: &BandMatrix, planes: usize) -> Result<(), FactorError> {
    let needed = matrix.half_bandwidth.checked_add(1).and_then(|width| width.checked_mul(matrix.order));
    if needed != Some(matrix.values.len()) {
        return Err(FactorError::Shape {
            reason: format!(
                "{} band entries for order {} and half bandwidth {}",
                matrix.values.len(),
                matrix.order,
                matrix.half_bandwidth
            ),
        });
    }
    if planes == 0 || !matrix.order.is_multiple_of(planes) {
        return Err(FactorError::Shape { reason: format!("order {} in {planes} planes", matrix.order) });
    }
    Ok(())
}

#[cfg(test)]
pub(crate) mod tests;
