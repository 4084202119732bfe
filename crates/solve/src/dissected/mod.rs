//! Cholesky factor of a dissected matrix, its halves side by side where there are two threads.

mod part;
mod reach;
mod structure;

use crate::sparse::{buffer, check_finite, check_square, coupled, fingerprint};
use crate::{Dissection, FactorError, Preconditioner};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{LltError, cholesky_in_place, cholesky_in_place_scratch};
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Mat, MatMut, Par};
use part::Part;
pub use reach::Reach;
use sprs::CsMat;

/// `A = L L^T` of a matrix whose unknowns are dissected: with halves 1 and 2 and their separator S,
///
/// ```text
///     [ A1       B1 ]
/// A = [      A2  B2 ]
///     [ B1'  B2' C  ]
/// ```
///
/// The halves are the principal submatrices `[Ai Bi; Bi' C]`, positive definite as `A` is, with
/// S last. The last columns `Gi` of these factors give `Gi Gi' = C - Bi' Ai^-1 Bi`, and the Schur
/// complement of S in `A` is `G1 G1' + G2 G2' - C`, which is factored densely. Solves go through
/// the halves side by side, to S and back.
///
/// The results depend neither on timing nor on the number of threads. On one,
/// [`SparseCholesky`](crate::SparseCholesky) in the order of the dissection does a little less work.
pub struct DissectedCholesky {
    parts: [Part; 2],
    /// Unknowns of the separator.
    separator: Vec<u32>,
    /// Entries of `C` in the lower triangle: row, column, place in the values of the matrix.
    couplings: Vec<[u32; 3]>,
    schur: Mat<f64>,
    scratch: MemBuffer,
    order: usize,
    fingerprint: u64,
    ready: bool,
}

impl DissectedCholesky {
    /// Finds the structure of the factor. The values are not read; call
    /// [`refactor`](Self::refactor) before the first solve.
    ///
    /// The points of the dissection have `components` unknowns each, numbered in component planes:
    /// unknown = component · points + point. The matrix comes in compressed rows, whole or only the
    /// lower triangle; entries above the diagonal are not read.
    ///
    /// # Errors
    ///
    /// [`FactorError::Shape`] if the matrix is not square, has other unknowns than the points, has
    /// more than 2^32 entries or couples the halves; [`FactorError::OutOfMemory`].
    pub fn analyse(
        pattern: &CsMat<f64>,
        dissection: &Dissection,
        components: usize,
    ) -> Result<Self, FactorError> {
        check_square(pattern)?;
        let (order, points) = (pattern.rows(), dissection.order().len());
        let wrong = |reason| Err(FactorError::Shape { reason });
        if order != points * components {
            return wrong(format!("{order} rows, but {points} points of {components} components"));
        }
        if pattern.nnz().max(order) > u32::MAX as usize {
            return wrong(format!("{order} rows and {} entries", pattern.nnz()));
        }
        let unknowns = |points: &[usize]| -> Vec<u32> {
            points
                .iter()
                .flat_map(|p| (0..components).map(|c| (c * dissection.order().len() + *p) as u32))
                .collect()
        };
        let [first, second] = dissection.halves();
        let (first, rest) = dissection.order().split_at(first);
        let (second, separator) = rest.split_at(second);
        let separator = unknowns(separator);
        let coupled = coupled(pattern);
        let part = |half: &[usize]| Part::analyse(pattern, unknowns(half), &separator, &coupled);
        let (first, second) = both(|| part(first), || part(second));
        let (first, second) = (first?, second?);
        let size = separator.len();
        if !structure::covers(pattern, [first.structure(), second.structure()], size) {
            return wrong("the halves of the dissection are coupled".to_string());
        }
        Ok(Self {
            couplings: first.structure().last(size),
            schur: Mat::zeros(size, size),
            scratch: buffer(cholesky_in_place_scratch::<f64>(size, Par::Seq, Default::default()))?,
            parts: [first, second],
            separator,
            order,
            fingerprint: fingerprint(pattern),
            ready: false,
        })
    }

    /// Factors a matrix of the analysed pattern.
    ///
    /// # Errors
    ///
    /// [`FactorError::NotFinite`] with the first row that has such an entry in the lower triangle,
    /// [`FactorError::NonPositivePivot`] with the unknown whose pivot is not positive.
    ///
    /// # Panics
    ///
    /// If the pattern is another one.
    pub fn refactor(&mut self, values: &CsMat<f64>) -> Result<(), FactorError> {
        assert_eq!(fingerprint(values), self.fingerprint, "the matrix has the analysed pattern");
        self.ready = false;
        check_finite(values)?;
        let [first, second] = &mut self.parts;
        let (one, two) = both(|| first.factor(values.data()), || second.factor(values.data()));
        one?;
        two?;
        let (one, two) = (first.complement(), second.complement());
        for j in 0..self.separator.len() {
            let sums = one.col(j).iter().zip(two.col(j).iter()).map(|(a, b)| a + b);
            self.schur.col_mut(j).iter_mut().zip(sums).for_each(|(to, sum)| *to = sum);
        }
        for [row, column, entry] in &self.couplings {
            self.schur[(*row as usize, *column as usize)] -= values.data()[*entry as usize];
        }
        let stack = MemStack::new(&mut self.scratch);
        cholesky_in_place(self.schur.as_mut(), Default::default(), Par::Seq, stack, Default::default())
            .map_err(|LltError::NonPositivePivot { index }| FactorError::NonPositivePivot {
                index: self.separator[index] as usize,
                count: 1,
            })?;
        self.ready = true;
        Ok(())
    }

    /// What solves need whose right-hand sides are zero beside some unknowns, each given once.
    ///
    /// # Panics
    ///
    /// If an unknown is none of the matrix.
    #[must_use]
    pub fn reach(&self, unknowns: Vec<usize>) -> Reach {
        let [first, second] = &self.parts;
        Reach::new(self.order, [first, second], &self.separator, unknowns)
    }

    /// Solves for the unknowns of `reach`, with a right-hand side that is zero beside them: both have entries for these alone.
    ///
    /// # Panics
    ///
    /// If no matrix has been factored since the analysis or the last failure, or a vector is shorter.
    pub fn apply_within(&mut self, reach: &Reach, r: &[f64], z: &mut [f64]) {
        let x = self.eliminated(reach, r);
        let ([first, second], [one, two]) = (&mut self.parts, &reach.parts);
        both(|| first.backward_to(one, &x), || second.backward_to(two, &x));
        first.gather(one, z);
        second.gather(two, z);
        reach.separator.iter().for_each(|place| z[place.among as usize] = x[place.own as usize]);
    }

    /// Solves for all unknowns `z`, with a right-hand side that is zero beside those of `reach` and has entries for these alone.
    ///
    /// # Panics
    ///
    /// As [`apply_within`](Self::apply_within).
    pub fn apply_from(&mut self, reach: &Reach, r: &[f64], z: &mut [f64]) {
        let x = self.eliminated(reach, r);
        self.finish(&x, z);
    }

    /// The separator of a solution, with the halves ready to be substituted.
    fn eliminated(&mut self, reach: &Reach, r: &[f64]) -> Vec<f64> {
        assert!(self.ready, "a matrix has been factored");
        let ([first, second], [one, two]) = (&mut self.parts, &reach.parts);
        both(|| first.forward_from(one, r), || second.forward_from(two, r));
        let mut own = vec![0.0; self.separator.len()];
        reach.separator.iter().for_each(|place| own[place.own as usize] = r[place.among as usize]);
        self.separated(own)
    }

    /// The separator of a solution, from its right-hand side after the halves were eliminated.
    fn separated(&self, mut x: Vec<f64>) -> Vec<f64> {
        let left = self.parts[0].last().iter().zip(self.parts[1].last());
        x.iter_mut().zip(left).for_each(|(x, (one, two))| *x = *x + one + two);
        let size = x.len();
        let mut column = MatMut::from_column_major_slice_mut(&mut x, size, 1);
        solve_lower_triangular_in_place(self.schur.as_ref(), column.as_mut(), Par::Seq);
        solve_upper_triangular_in_place(self.schur.transpose(), column.as_mut(), Par::Seq);
        x
    }

    /// Substitutes the halves, and writes the whole solution.
    fn finish(&mut self, separator: &[f64], z: &mut [f64]) {
        let [first, second] = &mut self.parts;
        both(|| first.backward(separator), || second.backward(separator));
        for (unknown, value) in self.separator.iter().zip(separator) {
            z[*unknown as usize] = *value;
        }
        first.scatter(z);
        second.scatter(z);
    }

    /// Stored entries of the factors, the padding of dense blocks and what the separator has twice
    /// included.
    #[must_use]
    pub fn fill(&self) -> usize {
        let size = self.separator.len();
        self.parts.iter().map(Part::fill).sum::<usize>() + size * size
    }

    /// Memory held by the factors and their scratch space, in bytes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let size = self.separator.len();
        self.parts.iter().map(Part::bytes).sum::<usize>() + 8 * size * size
    }
}

impl std::fmt::Debug for DissectedCholesky {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("DissectedCholesky")
            .field("order", &self.order)
            .field("separator", &self.separator.len())
            .field("fill", &self.fill())
            .field("ready", &self.ready)
            .finish()
    }
}

impl Preconditioner for DissectedCholesky {
    fn size(&self) -> usize {
        self.order
    }

    /// # Panics
    ///
    /// If no matrix has been factored since the analysis or the last failure.
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        assert!(self.ready, "a matrix has been factored");
        assert_eq!((r.len(), z.len()), (self.order, self.order), "vectors of the order of the matrix");
        let [first, second] = &mut self.parts;
        both(|| first.forward(r), || second.forward(r));
        let x = self.separated(self.separator.iter().map(|i| r[*i as usize]).collect());
        self.finish(&x, z);
    }
}

/// Two tasks, side by side where there are threads for both.
fn both<A: Send, B>(first: impl FnOnce() -> A + Send, second: impl FnOnce() -> B) -> (A, B) {
    if rayon::current_num_threads() < 2 {
        return (first(), second());
    }
    std::thread::scope(|scope| {
        let first = scope.spawn(first);
        let second = second();
        (first.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)), second)
    })
}

#[cfg(test)]
mod tests;
