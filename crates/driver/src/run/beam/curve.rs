//! Fields along lines as they are drawn.

use super::between::{Between, Cell};
use crate::case::FieldName;

/// Straight pieces that make a curve of a line, at least.
const PIECES: usize = 48;

impl Between<'_> {
    /// A field along the line: both ends of every cell, the extremes, and values between points where these are few. None where it
    /// was not recovered or does not exist.
    pub(super) fn curve(&self, field: FieldName) -> Option<Vec<(f64, f64)>> {
        let ends = self.ends(field)?;
        let mut high = self.high_cells(field, &ends, ends.extremes()?).into_iter().peekable();
        let pieces = PIECES.div_ceil(self.cells());
        let ends = ends.all();
        let mut points = Vec::with_capacity(2 * ends.len());
        for (number, [left, right]) in ends.iter().enumerate() {
            let is_high = high.next_if_eq(&number).is_some();
            if is_high || pieces > 1 {
                self.cell(number).draw(field, (pieces, is_high), &mut points)?;
            } else {
                points.extend([(self.position(number), *left), (self.position(number + 1), *right)]);
            }
        }
        Some(points)
    }
}

impl Cell<'_> {
    /// Adds the parts of a cell in pieces, with their extremes where it may have some.
    fn draw(
        &self,
        field: FieldName,
        (pieces, is_high): (usize, bool),
        points: &mut Vec<(f64, f64)>,
    ) -> Option<()> {
        for part in self.parts(field)? {
            let [(left, from), (right, to)] = part.corners();
            points.push((from, left));
            if !self.is_straight(field) {
                let value = |x: f64| self.value(field, x, true);
                let first = points.len();
                for piece in 1..pieces {
                    let x = part.at(piece as f64 / pieces as f64);
                    points.push((x, value(x)?));
                }
                let peaks = if is_high { part.peaks(value)? } else { Vec::new() };
                points.extend(peaks.into_iter().map(|(value, x)| (x, value)));
                points[first..].sort_by(|a, b| a.0.total_cmp(&b.0));
            }
            points.push((to, right));
        }
        Some(())
    }
}
