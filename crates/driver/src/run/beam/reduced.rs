//! What is made of a field along lines.

use super::BeamResult;
use crate::case::{FieldName, Reduction};
use crate::run::reducer::{Reduced, Reducer};
use std::ops::Range;

/// What is made of a field at all points of some lines, on both sides of those where it may jump; the place is a line and a
/// position on it. Along a line, the field is linear between points. None where it was not recovered.
pub(super) fn read(
    result: &BeamResult,
    field: FieldName,
    of: Reduction,
    lines: &Range<usize>,
) -> Option<Reduced<(usize, f64)>> {
    let mut reducer = Reducer::new(of);
    for line in lines.clone() {
        let x = &result.lines[line].x;
        let mut take = |cell: usize, ends: [f64; 2]| {
            let half = 0.5 * (x.at(cell + 1) - x.at(cell));
            for (side, value) in ends.into_iter().enumerate() {
                reducer.take(value, (line, x.at(cell + side)), |_| half);
            }
        };
        match result.cells(field, line) {
            Some(cells) => cells.iter().enumerate().for_each(|(cell, ends)| take(cell, *ends)),
            None => {
                let values = result.values(field, line)?;
                values.windows(2).enumerate().for_each(|(cell, ends)| take(cell, [ends[0], ends[1]]));
            }
        }
    }
    reducer.found()
}
