//! Values at the ends of cells.

use super::BeamResult;
use crate::case::FieldName;
use crate::run::scan;
use std::borrow::Cow;

/// Values of a field along a line at both ends of every cell, seen from inside.
pub(super) enum Ends<'a> {
    /// Of one that may jump at points.
    Cells(Cow<'a, [[f64; 2]]>),
    /// Of one that has a value at every point.
    Points(Cow<'a, [f64]>),
}

impl BeamResult {
    /// Of a line; `None` where the field was not recovered or does not exist.
    pub(super) fn ends(&self, field: FieldName, line: usize) -> Option<Ends<'_>> {
        let cells = self.cells(field, line).map(Ends::Cells);
        cells.or_else(|| self.values(field, line).map(Ends::Points))
    }
}

impl Ends<'_> {
    /// Both ends of all cells.
    pub(super) fn all(&self) -> Cow<'_, [[f64; 2]]> {
        match self {
            Self::Cells(ends) => Cow::Borrowed(ends),
            Self::Points(values) => values.windows(2).map(|ends| [ends[0], ends[1]]).collect(),
        }
    }

    /// Smallest and largest value, with their points.
    pub(super) fn extremes(&self) -> Option<[(f64, usize); 2]> {
        match self {
            Self::Cells(ends) => {
                let values = ends.as_flattened();
                Some(scan::extremes(values)?.map(|k| (values[k], k / 2 + k % 2)))
            }
            Self::Points(values) => Some(scan::extremes(values)?.map(|k| (values[k], k))),
        }
    }
}
