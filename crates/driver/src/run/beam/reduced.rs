//! What is made of a field along lines.

use super::BeamResult;
use super::between::Between;
use crate::case::{FieldName, Reduction};
use crate::run::reducer::{Reduced, Reducer};
use crate::scene::beam::BeamScene;
use std::ops::Range;

/// What is made of a field along some lines, at their points and between them; the place is a line and a position on it. None
/// where it was not recovered.
pub(super) fn read(
    scene: &BeamScene,
    result: &BeamResult,
    (field, of): (FieldName, Reduction),
    lines: &Range<usize>,
) -> Option<Reduced<(usize, f64)>> {
    let mut reducer = Reducer::new(of);
    for line in lines.clone() {
        let between = Between::new(scene, result, line);
        for cell in (0..between.cells()).map(|number| between.cell(number)) {
            for part in cell.parts(field)? {
                let ([a, b], [start, end]) = (part.ends, part.values);
                reducer.take(start, (line, a), |_| (b - a) / 6.0);
                reducer.take(end, (line, b), |_| (b - a) / 6.0);
                let value = |x| cell.value(field, x, true);
                if !of.is_extreme() {
                    // Simpson's rule.
                    let x = part.at(0.5);
                    reducer.take(value(x)?, (line, x), |_| 2.0 * (b - a) / 3.0);
                } else if !cell.is_straight(field) {
                    part.peaks(value)?.into_iter().for_each(|(v, x)| reducer.take(v, (line, x), |_| 0.0));
                }
            }
        }
    }
    reducer.found()
}
