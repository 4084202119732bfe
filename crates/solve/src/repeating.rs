//! Cholesky factor of a band matrix whose columns repeat in runs.

mod eliminate;
mod sweep;
mod table;

use crate::FactorError;
use table::Table;

pub use sweep::{Backward, Forward};

/// A symmetric band matrix given by runs of equal groups of columns.
///
/// Every run says what one group of `period` columns looks like and how often it
/// comes in succession. Entries that would lie past the last row are ignored.
#[derive(Debug, Clone, PartialEq)]
pub struct RepeatingBand {
    /// Largest distance of a non-zero entry from the diagonal.
    pub half_bandwidth: usize,
    /// Columns per group, at least one.
    pub period: usize,
    /// Number of groups of each run, at least one.
    pub runs: Vec<usize>,
    /// The group of each run: `period` columns of `half_bandwidth + 1` entries of
    /// the lower triangle, the diagonal first, one run after the other.
    pub values: Vec<f64>,
}

/// The factors of `A = L D L^T` of a matrix whose columns repeat in runs.
///
/// Within a long run the columns of the factor converge, geometrically if the
/// symbol of the run (its matrix continued without end) is positive definite. Only
/// the columns before that are kept, and the sweeps over the rest of the run are
/// recurrences with constant coefficients: a million equal groups take the memory
/// of a few dozen columns and no memory traffic but that of the vectors. A run that
/// does not converge keeps all its columns, at twice the memory of a
/// [`BandCholesky`](crate::BandCholesky).
///
/// A column counts as converged once another group no longer changes `L D` by more
/// than the rounding of the matrix. Using it for the rest of the run thus amounts
/// to such a change of the matrix, whatever its condition.
///
/// The vectors are streamed: [`forward`](Self::forward) and
/// [`backward`](Self::backward) take them in blocks, so that the caller can do its
/// own work on a block while it is in the cache. How a vector is cut into blocks
/// affects the last bits of the result.
#[derive(Debug, Clone)]
pub struct RepeatingCholesky {
    order: usize,
    half_bandwidth: usize,
    period: usize,
    runs: Vec<Run>,
    /// The kept columns of all runs, each with the reciprocal pivot first.
    columns: Vec<f64>,
    /// The kept rows left of the diagonal, the oldest column first.
    rows: Vec<f64>,
}

/// Consecutive columns of the factor.
#[derive(Debug, Clone)]
struct Run {
    /// All columns of the run.
    columns: usize,
    /// Columns kept, whole groups; those after them are equal to the last group.
    kept: usize,
    /// The first of them among those kept of all runs.
    first: usize,
    /// The recurrences for many unknowns at once, if enough columns are equal.
    tables: Option<Tables>,
}

#[derive(Debug, Clone)]
struct Tables {
    forward: Table,
    backward: Table,
}

impl RepeatingCholesky {
    /// Factors a matrix.
    ///
    /// # Errors
    ///
    /// [`FactorError::NonPositivePivot`] with the number of all such pivots,
    /// [`FactorError::NotFinite`], or [`FactorError::Shape`] if the numbers of runs
    /// and values do not fit or a period or a run is zero.
    pub fn factor(matrix: &RepeatingBand) -> Result<Self, FactorError> {
        let order = check_shape(matrix)?;
        let mut factor = Self {
            order,
            half_bandwidth: matrix.half_bandwidth,
            period: matrix.period,
            runs: Vec::with_capacity(matrix.runs.len()),
            columns: Vec::new(),
            rows: Vec::new(),
        };
        eliminate::eliminate(matrix, &mut factor)?;
        factor.columns.shrink_to_fit();
        factor.rows.shrink_to_fit();
        for at in 0..factor.runs.len() {
            factor.runs[at].tables = Tables::new(&factor, &factor.runs[at]);
        }
        Ok(factor)
    }

    /// Number of unknowns.
    #[must_use]
    pub fn order(&self) -> usize {
        self.order
    }

    /// Columns of the factor that are stored.
    #[must_use]
    pub fn columns_kept(&self) -> usize {
        self.columns.len() / (self.half_bandwidth + 1)
    }

    /// Memory held by the factor, in bytes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let tables = self.runs.iter().flat_map(|run| &run.tables);
        let tables = tables.map(|t| t.forward.bytes() + t.backward.bytes()).sum::<usize>();
        let kept = (self.columns.capacity() + self.rows.capacity()) * size_of::<f64>();
        tables + kept + self.runs.capacity() * size_of::<Run>()
    }

    /// Starts the sweep `L y = r` at the first unknown.
    #[must_use]
    pub fn forward(&self) -> Forward<'_> {
        Forward::new(self)
    }

    /// Starts the sweep `L^T x = D^-1 y` at the last unknown.
    #[must_use]
    pub fn backward(&self) -> Backward<'_> {
        Backward::new(self)
    }

    /// The row of a kept column left of the diagonal, the oldest entry first.
    fn row(&self, kept: usize) -> &[f64] {
        &self.rows[kept * self.half_bandwidth..][..self.half_bandwidth]
    }

    /// A kept column.
    fn column(&self, kept: usize) -> &[f64] {
        let width = self.half_bandwidth + 1;
        &self.columns[kept * width..][..width]
    }
}

impl Run {
    /// Where column `at` of the run is among those kept of all runs.
    fn kept(&self, at: usize, period: usize) -> usize {
        self.first + if at < self.kept { at } else { self.kept - period + at % period }
    }
}

/// The order of the matrix, if its shape makes sense.
fn check_shape(matrix: &RepeatingBand) -> Result<usize, FactorError> {
    let RepeatingBand { half_bandwidth, period, runs, values } = matrix;
    let width = half_bandwidth.checked_add(1);
    let needed = width.and_then(|w| w.checked_mul(*period)).and_then(|group| group.checked_mul(runs.len()));
    if needed != Some(values.len()) {
        let (runs, values) = (runs.len(), values.len());
        let reason = format!(
            "{values} band entries for {runs} runs of period {period} and half bandwidth {half_bandwidth}"
        );
        return Err(FactorError::Shape { reason });
    }
    let groups = runs.iter().try_fold(0_usize, |sum, groups| sum.checked_add(*groups));
    let order = groups.and_then(|groups| groups.checked_mul(*period));
    match order {
        Some(order) if *period > 0 && !runs.contains(&0) => Ok(order),
        _ => Err(FactorError::Shape { reason: format!("runs of {runs:?} groups of {period} columns") }),
    }
}

#[cfg(test)]
mod tests;
