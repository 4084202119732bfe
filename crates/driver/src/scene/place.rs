//! Where on the body a position is.

use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::model::timoshenko_beam::Grid;
use peristat_assembly::model::timoshenko_beam::end_treatment::EndTreatment;

/// Lines with their grids, before any bond exists.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    /// The lines, from left to right as written.
    pub(super) lines: Vec<LayoutLine>,
    /// End treatment of all of them.
    pub(super) treatment: &'static EndTreatment,
}

/// One line of a layout.
#[derive(Clone, Debug)]
pub(super) struct LayoutLine {
    /// Position of the left end.
    pub(super) from: f64,
    /// Length.
    pub(super) length: f64,
    /// Cells.
    pub(super) cells: usize,
    /// Where the points are.
    pub(super) grid: Grid,
    /// Horizon over spacing.
    pub(super) horizon_ratio: f64,
}

/// A place on a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// On a point of the grid.
    Point {
        /// Line.
        chain: usize,
        /// Real point of the line, from its left end.
        point: usize,
    },
    /// On an end of the line that carries no point.
    End {
        /// Line.
        chain: usize,
        /// 0 left, 1 right.
        side: usize,
    },
    /// Between points.
    Between {
        /// Line.
        chain: usize,
        /// Position, snapped to the line.
        x: f64,
    },
}

impl Place {
    /// The line.
    pub fn chain(&self) -> usize {
        match *self {
            Self::Point { chain, .. } | Self::End { chain, .. } | Self::Between { chain, .. } => chain,
        }
    }
}

/// Part of a spacing within which a position counts as that of a point.
const SNAP: f64 = 1e-6;

impl LayoutLine {
    /// Distance of neighbouring points.
    pub(super) fn spacing(&self) -> f64 {
        self.length / self.cells as f64
    }

    /// Number of points.
    pub(super) fn points(&self) -> usize {
        self.cells + usize::from(self.grid == Grid::Nodes)
    }

    /// Right end.
    pub(super) fn to(&self) -> f64 {
        self.from + self.length
    }

    fn holds(&self, x: f64) -> bool {
        let slack = SNAP * self.spacing();
        x >= self.from - slack && x <= self.to() + slack
    }

    /// Point number as a real number: whole on points.
    fn coordinate(&self, x: f64) -> f64 {
        let shift = if self.grid == Grid::Cells { 0.5 } else { 0.0 };
        (x - self.from) / self.spacing() - shift
    }

    /// Nearest point to a position on the line.
    pub(super) fn nearest(&self, x: f64) -> usize {
        (self.coordinate(x).round().max(0.0) as usize).min(self.points() - 1)
    }

    /// Position of a point.
    pub(super) fn position(&self, point: usize) -> f64 {
        let shift = if self.grid == Grid::Cells { 0.5 } else { 0.0 };
        self.from + (point as f64 + shift) * self.spacing()
    }
}

impl Layout {
    /// The place of a position, with a fault at `path` if it is off the body.
    pub(super) fn place(&self, x: f64, path: &JsonPath, what: &str, faults: &mut Faults) -> Option<Place> {
        let Some(chain) = self.lines.iter().position(|l| l.holds(x)) else {
            let extent: Vec<String> =
                self.lines.iter().map(|l| format!("x = {} to {}", tidy(l.from), tidy(l.to()))).collect();
            faults
                .error(path.clone(), format!("{what} at x = {} is off the beam", tidy(x)))
                .hint(format!("the beam is at {}", extent.join(" and at ")));
            return None;
        };
        let line = &self.lines[chain];
        let point = line.nearest(x);
        if (line.coordinate(x) - point as f64).abs() <= SNAP {
            return Some(Place::Point { chain, point });
        }
        for (side, end) in [line.from, line.to()].into_iter().enumerate() {
            if (x - end).abs() <= SNAP * line.spacing() {
                return Some(Place::End { chain, side });
            }
        }
        Some(Place::Between { chain, x })
    }

    /// A fault for something that needs a point and is between two.
    pub(super) fn needs_point(&self, chain: usize, x: f64, path: &JsonPath, what: &str, faults: &mut Faults) {
        let line = &self.lines[chain];
        let below = (line.coordinate(x).floor().max(0.0) as usize).min(line.points() - 1);
        let above = (below + 1).min(line.points() - 1);
        let near = [below, above].map(|p| tidy(line.position(p)));
        let mut hint = format!("the nearest points are at x = {} and {}", near[0], near[1]);
        if let Some(cells) = cells_with_point(line, x) {
            hint += &format!("; with {cells} cells there is one at {x}");
        }
        faults.error(path.clone(), format!("{what} at x = {x} is between two points")).hint(hint);
    }
}

/// A number for a message: without the last digits, which rounding left, and not longer than it must be.
pub(super) fn tidy(value: f64) -> String {
    let rounded: f64 = format!("{value:.11e}").parse().unwrap_or(value);
    let (plain, scientific) = (rounded.to_string(), format!("{rounded:e}"));
    if plain.len() <= scientific.len() + 6 { plain } else { scientific }
}

/// The smallest number of cells, not below the present one, that puts a point at `x`.
fn cells_with_point(line: &LayoutLine, x: f64) -> Option<usize> {
    let z = (x - line.from) / line.length;
    (line.grid == Grid::Nodes)
        .then(|| {
            (line.cells..=2 * line.cells + 100)
                .find(|&n| ((z * n as f64).round() - z * n as f64).abs() < 1e-9)
        })
        .flatten()
}

#[cfg(test)]
mod tests {
    use super::tidy;

    #[test]
    fn a_number_in_a_message_has_no_rounding_digits_and_no_row_of_zeros() {
        assert_eq!(tidy(0.1 + 0.2), "0.3");
        assert_eq!(tidy(20.0 * 0.05 - 0.05), "0.95");
        assert_eq!(tidy(1e100), "1e100");
        assert_eq!(tidy(-1e-100), "-1e-100");
        assert_eq!(tidy(12_345.678_9), "12345.6789");
    }
}
