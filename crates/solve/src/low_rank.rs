//! Solutions with a matrix that differs from a factored one in a few terms.

mod small;

use crate::{FactorError, Preconditioner};
use peristat_vector::add;
use small::Small;

/// Inverse of `A + Σ c v v^T` by the formula of Sherman, Morrison and Woodbury, given a factor of `A`.
///
/// The columns `v` have few entries and the changes `c` either sign. Each column costs one solve with the factor
/// when it is added; its change may then be set as often as wanted. With the columns `V` whose change is not zero
/// and `Z = A^-1 V`,
///
/// ```text
/// (A + V C V^T)^-1 r = x - Z D S^-1 D V^T x,    x = A^-1 r,
/// S = D (C^-1 + V^T Z) D,    D^-2 = |C|^-1 + |diag V^T Z|
/// ```
///
/// `D` bounds what goes into `S`: its diagonal, from -1 to 1, is the sign of the change where this is small
/// and that of `v^T A^-1 v` where it is large. A factor of `S` is made when the first solve after a change needs it.
///
/// Digits are lost as far as the conditions of `A` and of the changed matrix differ, so that a factor far from the
/// matrix wanted is worth making anew.
#[derive(Debug)]
pub struct LowRank {
    order: usize,
    columns: Vec<Column>,
    /// `A^-1 v` of one column after the other.
    solved: Vec<f64>,
    /// Rows of the lower triangle of `V^T Z`, one after the other.
    products: Vec<f64>,
    small: Option<Small>,
}

#[derive(Debug)]
struct Column {
    entries: Vec<(usize, f64)>,
    change: f64,
}

impl Column {
    fn dot(&self, x: &[f64]) -> f64 {
        self.entries.iter().map(|(i, v)| v * x[*i]).sum()
    }
}

impl LowRank {
    /// No columns yet, for a matrix of the given order.
    #[must_use]
    pub fn new(order: usize) -> Self {
        Self { order, columns: Vec::new(), solved: Vec::new(), products: Vec::new(), small: None }
    }

    /// Forgets the columns, as when the factor is made anew.
    pub fn clear(&mut self) {
        self.columns.clear();
        self.solved.clear();
        self.products.clear();
        self.small = None;
    }

    /// Number of columns, those whose change is zero included.
    #[must_use]
    pub fn rank(&self) -> usize {
        self.columns.len()
    }

    /// Memory held by the columns, in bytes; that of the small factor is not counted.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let entries: usize = self.columns.iter().map(|c| c.entries.capacity()).sum();
        (self.solved.capacity() + self.products.capacity()) * size_of::<f64>()
            + entries * size_of::<(usize, f64)>()
    }

    /// Adds a column, given by its entries, with a change of zero; entries of the same unknown add up. Costs one
    /// solve with the factor.
    ///
    /// # Returns
    ///
    /// The index of the column, for [`set`](Self::set).
    ///
    /// # Panics
    ///
    /// If the factor has another order or there is no such unknown.
    pub fn push(&mut self, factor: &mut dyn Preconditioner, column: &[(usize, f64)]) -> usize {
        assert_eq!(factor.size(), self.order, "the factor has the order of the matrix");
        let mut v = vec![0.0; self.order];
        for (unknown, value) in column {
            v[*unknown] += value;
        }
        let index = self.columns.len();
        self.solved.resize((index + 1) * self.order, 0.0);
        factor.apply(&v, &mut self.solved[index * self.order..]);
        self.columns.push(Column { entries: column.to_vec(), change: 0.0 });
        let row = (0..=index).map(|j| self.columns[index].dot(self.solved(j)));
        let row: Vec<f64> = row.collect();
        self.products.extend(row);
        index
    }

    /// Sets the change of a column; zero is as if the column were not there.
    ///
    /// # Panics
    ///
    /// If there is no such column or the change is not finite.
    pub fn set(&mut self, index: usize, change: f64) {
        assert!(change.is_finite(), "a change is finite");
        let before = std::mem::replace(&mut self.columns[index].change, change);
        if before != change {
            self.small = None;
        }
    }

    /// Writes `(A + Σ c v v^T)^-1 r` over `z`; both have the order of the matrix. Costs one solve with the factor,
    /// which must be the one that the columns were added with.
    ///
    /// # Errors
    ///
    /// [`FactorError::Singular`] if the changed matrix is singular to rounding, with an unknown of one of the columns
    /// that make it so; [`FactorError::NotFinite`] likewise, if a solution or change is not finite.
    /// `z` then holds the solution without changes.
    pub fn apply(
        &mut self,
        factor: &mut dyn Preconditioner,
        r: &[f64],
        z: &mut [f64],
    ) -> Result<(), FactorError> {
        factor.apply(r, z);
        let mut small = self.small.take().unwrap_or_else(|| self.reduce());
        let outcome = small.solvable(|index| self.columns[index].entries.first().map_or(0, |(i, _)| *i));
        if outcome.is_ok() {
            small.solve(|index| self.columns[index].dot(z));
            for (index, y) in small.solution() {
                add(z, -y, self.solved(index));
            }
        }
        self.small = Some(small);
        outcome
    }

    /// Number of negative eigenvalues of the changed matrix, given that of the factored one.
    ///
    /// The inertia of `[A V; V^T -C^-1]` is the sum of those of a block and its Schur complement, from either end
    /// (Haynsworth). Hence the number grows by that of the positive eigenvalues of `S` less that of the positive
    /// changes.
    pub fn negative_eigenvalues(&mut self, of_factor: usize) -> usize {
        let small = self.small.take().unwrap_or_else(|| self.reduce());
        let raised = self.columns.iter().filter(|column| column.change > 0.0).count();
        let negative = (of_factor + small.positive()).saturating_sub(raised);
        self.small = Some(small);
        negative
    }

    fn solved(&self, index: usize) -> &[f64] {
        &self.solved[index * self.order..(index + 1) * self.order]
    }

    /// Factor of `S`.
    fn reduce(&self) -> Small {
        let active =
            |(index, column): (usize, &Column)| (column.change != 0.0).then_some((index, column.change));
        let changes: Vec<(usize, f64)> = self.columns.iter().enumerate().filter_map(active).collect();
        Small::new(&changes, |i, j| self.products[i * (i + 1) / 2 + j])
    }
}

#[cfg(test)]
mod tests;
