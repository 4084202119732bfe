//! What is made of a field along lines.

use super::BeamResult;
use super::between::Between;
use crate::case::{FieldName, Reduction};
use crate::run::reducer::{Reduced, Reducer};
use crate::scene::beam::BeamScene;
use peristat_assembly::quadrature::GAUSS;
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
                let value = |x| cell.value(field, x, true);
                if !of.is_extreme() {
                    let [a, b] = part.ends;
                    // Exact for the energy density under straight loads, of the sixth degree, and to rounding under waves.
                    for (q, share) in GAUSS {
                        let x = part.at(q);
                        reducer.take(value(x)?, (line, x), |_| share * (b - a));
                    }
                    continue;
                }
                let mut take = |(value, x): (f64, f64)| reducer.take(value, (line, x), |_| 0.0);
                part.corners().into_iter().for_each(&mut take);
                if !cell.is_straight(field) {
                    part.peaks(value)?.into_iter().for_each(take);
                }
            }
        }
    }
    reducer.found()
}
