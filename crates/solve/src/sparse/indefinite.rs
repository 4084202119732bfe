//! Factor of a sparse symmetric matrix that need not be positive definite.

use super::analysis::{ALWAYS_BLOCKS, Analysis, buffer, check_finite, with_columns, zeros};
use super::{Ordering, SparseCholesky};
use crate::blocks::blocks;
use crate::{FactorError, Preconditioner};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::lblt::factor::LbltParams;
use faer::perm::PermRef;
use faer::sparse::linalg::cholesky::{IntranodeLbltRef, SymbolicCholeskyRaw, supernodal};
use faer::{Auto, Conj, MatMut, Par, Side, Spec};
use sprs::CsMat;
use std::sync::Arc;

/// `A = L B L^T` of a sparse symmetric matrix of either sign in a fill-reducing order.
///
/// `L` has the structure of the Cholesky factor: unknowns change places only within its dense blocks, such that
/// the pivots, one or two rows of the block diagonal `B` at a time (Bunch and Kaufman), are the large entries of
/// their block. Unlike a search through the whole matrix this does not bound the growth of the entries: where the
/// diagonal is small and a block has no partner for an unknown, digits are lost. Check the residual, and refine.
///
/// The signs of `B` are those of the eigenvalues of `A` (Sylvester), see
/// [`negative_pivots`](Self::negative_pivots).
///
/// Matrices are handed over in compressed rows, either whole or only the lower triangle; entries above the
/// diagonal are not read.
pub struct SparseIndefinite {
    analysis: Arc<Analysis>,
    values: Vec<f64>,
    /// Diagonal of `B` and the entries below it, in the order of elimination.
    diagonal: Vec<f64>,
    below: Vec<f64>,
    /// Positions before the exchange of unknowns, and their inverse.
    forward: Vec<usize>,
    inverse: Vec<usize>,
    factor_scratch: MemBuffer,
    solve_scratch: MemBuffer,
    negative_pivots: usize,
    ready: bool,
}

impl SparseIndefinite {
    /// Orders the unknowns and finds the structure of the factor. The values are not read; call
    /// [`refactor`](Self::refactor) before the first solve.
    ///
    /// # Errors
    ///
    /// [`FactorError::Shape`] if the matrix is not square or the ordering is not one of its unknowns,
    /// [`FactorError::OutOfMemory`].
    pub fn analyse(pattern: &CsMat<f64>, ordering: Ordering<'_>) -> Result<Self, FactorError> {
        let analysis = Analysis::new(pattern, ordering, ALWAYS_BLOCKS)?;
        Self::new(Arc::new(analysis))
    }

    /// Takes over the analysis of a Cholesky factor, such as one whose matrix turned out not to be positive
    /// definite. Only a factor without dense blocks, that is a small or thin one, is analysed anew, in the order
    /// it has.
    ///
    /// # Errors
    ///
    /// [`FactorError::OutOfMemory`].
    ///
    /// # Panics
    ///
    /// If the pattern is not that of the factor.
    pub fn of(cholesky: &SparseCholesky, pattern: &CsMat<f64>) -> Result<Self, FactorError> {
        let analysis = &cholesky.analysis;
        analysis.check(pattern);
        if analysis.has_blocks() {
            return Self::new(Arc::clone(analysis));
        }
        Self::new(Arc::new(analysis.blocked(pattern)?))
    }

    fn new(analysis: Arc<Analysis>) -> Result<Self, FactorError> {
        let symbolic = &analysis.symbolic;
        let order = symbolic.nrows();
        let need = symbolic.factorize_numeric_intranode_lblt_scratch::<f64>(Par::Seq, parameters());
        Ok(Self {
            values: zeros(symbolic.len_val())?,
            diagonal: zeros(order)?,
            below: zeros(order)?,
            forward: (0..order).collect(),
            inverse: (0..order).collect(),
            factor_scratch: buffer(need)?,
            solve_scratch: buffer(symbolic.solve_in_place_scratch::<f64>(1, Par::Seq))?,
            negative_pivots: 0,
            ready: false,
            analysis,
        })
    }

    /// Factors a matrix of the analysed pattern.
    ///
    /// # Errors
    ///
    /// [`FactorError::NotFinite`] with the first row that has such an entry in the lower triangle or such a pivot,
    /// [`FactorError::Singular`] with the unknown whose pivot is exactly zero. Most singular matrices have pivots
    /// of the size of the rounding instead, and solutions that are as large as these are small; and a regular
    /// matrix has such a pivot where the diagonal is zero and the block has no partner for the unknown.
    ///
    /// # Panics
    ///
    /// If the pattern is another one.
    pub fn refactor(&mut self, values: &CsMat<f64>) -> Result<(), FactorError> {
        self.analysis.check(values);
        self.ready = false;
        check_finite(values)?;
        // faer leaves some of the entries that are zero as they are.
        self.below.fill(0.0);
        let stack = MemStack::new(&mut self.factor_scratch);
        with_columns(values, |matrix| {
            self.analysis.symbolic.factorize_numeric_intranode_lblt(
                &mut self.values,
                &mut self.below,
                &mut self.forward,
                &mut self.inverse,
                matrix,
                Side::Upper,
                Par::Seq,
                stack,
                parameters(),
            );
        });
        self.read_diagonal();
        self.negative_pivots = self.count_negative()?;
        self.ready = true;
        Ok(())
    }

    /// Number of negative eigenvalues of the factored matrix.
    ///
    /// # Panics
    ///
    /// If no matrix has been factored since the analysis or the last failure.
    #[must_use]
    pub fn negative_pivots(&self) -> usize {
        assert!(self.ready, "a matrix has been factored");
        self.negative_pivots
    }

    /// Stored entries of `L`, the padding of its dense blocks included.
    #[must_use]
    pub fn fill(&self) -> usize {
        self.values.len()
    }

    /// Memory held by the factor and its scratch space, in bytes; the analysis is not counted.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let numbers = self.values.capacity() + 4 * self.diagonal.len();
        numbers * size_of::<f64>() + self.factor_scratch.len() + self.solve_scratch.len()
    }

    fn read_diagonal(&mut self) {
        let SymbolicCholeskyRaw::Supernodal(symbolic) = self.analysis.symbolic.raw() else {
            return; // There are no unknowns.
        };
        // No more than a reader of the blocks, for which any factor does.
        let factor = supernodal::SupernodalLltRef::new(symbolic, &self.values[..]);
        for s in 0..symbolic.n_supernodes() {
            let block = factor.supernode(s);
            let width = symbolic.supernode_end()[s] - block.start();
            for j in 0..width {
                self.diagonal[block.start() + j] = block.val()[(j, j)];
            }
        }
    }

    fn count_negative(&self) -> Result<usize, FactorError> {
        let mut negative = 0;
        for block in blocks(&self.diagonal, &self.below) {
            let index = self.analysis.unknown(self.forward[block.first]);
            if !block.pivot.is_finite() {
                return Err(FactorError::NotFinite { index });
            }
            if !block.pivot.recip().is_finite() {
                return Err(FactorError::Singular { index });
            }
            negative += block.negative;
        }
        Ok(negative)
    }
}

impl std::fmt::Debug for SparseIndefinite {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("SparseIndefinite")
            .field("order", &self.diagonal.len())
            .field("fill", &self.fill())
            .field("ready", &self.ready)
            .finish()
    }
}

impl Preconditioner for SparseIndefinite {
    fn size(&self) -> usize {
        self.diagonal.len()
    }

    /// # Panics
    ///
    /// If no matrix has been factored since the analysis or the last failure.
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        assert!(self.ready, "a matrix has been factored");
        z.copy_from_slice(r);
        let order = z.len();
        let exchange = PermRef::new_checked(&self.forward, &self.inverse, order);
        IntranodeLbltRef::new(&self.analysis.symbolic, &self.values, &self.below, exchange)
            .solve_in_place_with_conj(
                Conj::No,
                MatMut::from_column_major_slice_mut(z, order, 1),
                Par::Seq,
                MemStack::new(&mut self.solve_scratch),
            );
    }
}

/// Column by column within a block of the factor: in panels of columns faer 0.24 keeps what stood in a column that
/// becomes exactly zero below its pivot.
fn parameters() -> Spec<LbltParams, f64> {
    let mut parameters = <LbltParams as Auto<f64>>::auto();
    parameters.block_size = 0;
    parameters.into()
}

#[cfg(test)]
mod tests;
