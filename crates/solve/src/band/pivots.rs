//! The signs of the pivots.

use crate::FactorError;

/// What the pivots said.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
pub(crate) struct Pivots {
    /// The first pivot that is zero or negative.
    pub(crate) first_bad: Option<usize>,
    /// How many are.
    pub(crate) bad: usize,
    /// A pivot that is not finite; the sweep ends there.
    pub(crate) not_finite: Option<usize>,
}

impl Pivots {
    /// Takes note of a pivot that is not positive and finite.
    ///
    /// Gives a pivot to go on with, or `None` if there is no way on. A pivot that
    /// is exactly zero is replaced by a small negative one in proportion to its
    /// column, so that the sweep can go on counting.
    #[cold]
    pub(crate) fn note(&mut self, index: usize, pivot: f64, column: &[f64]) -> Option<f64> {
        if !pivot.is_finite() {
            // After a bad pivot the overflow is a consequence, not the cause.
            if self.first_bad.is_none() {
                self.not_finite = Some(index);
            }
            return None;
        }
        self.first_bad.get_or_insert(index);
        self.bad += 1;
        if pivot < 0.0 {
            return Some(pivot);
        }
        let largest = column.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        Some(-f64::EPSILON * largest.max(f64::MIN_POSITIVE / f64::EPSILON))
    }
    /// The error that the pivots amount to; `entry` is where in the vectors the
    /// unknown of a pivot is.
    pub(crate) fn verdict(&self, entry: impl Fn(usize) -> usize) -> Result<(), FactorError> {
        if let Some(index) = self.not_finite {
            return Err(FactorError::NotFinite { index: entry(index) });
        }
        match self.first_bad {
            Some(index) => Err(FactorError::NonPositivePivot { index: entry(index), count: self.bad }),
            None => Ok(()),
        }
    }
}
