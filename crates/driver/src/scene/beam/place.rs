//! Where on the body a position is.

use super::frame_layout::{EndOfMember, FrameLayout};
use crate::diagnostic::{Faults, JsonPath, tidy};
use peristat_assembly::model::timoshenko_beam::Grid;
use peristat_assembly::model::timoshenko_beam::end_treatment::EndTreatment;

/// Lines with their grids, before any bond exists.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    /// The lines, from left to right as written.
    pub(super) lines: Vec<LayoutLine>,
    /// End treatment of all of them.
    pub(super) treatment: &'static EndTreatment,
    /// Joints and members, where the lines are those of a frame.
    pub(super) frame: Option<FrameLayout>,
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
    /// Horizon over spacing; on a graded grid the number of neighbours on each side.
    pub(super) horizon_ratio: f64,
    /// Distances of the points from the left end, where the grid is graded.
    pub(super) stations: Option<Vec<f64>>,
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
    /// Distance of neighbouring points; their mean distance on a graded grid.
    pub(super) fn spacing(&self) -> f64 {
        self.length / self.cells as f64
    }

    /// Length of the cell that a position is in, the first or the last one if it is beyond.
    fn cell(&self, x: f64) -> f64 {
        match &self.stations {
            None => self.spacing(),
            Some(stations) => {
                let k = self.cell_number(stations, x);
                stations[k + 1] - stations[k]
            }
        }
    }

    fn cell_number(&self, stations: &[f64], x: f64) -> usize {
        stations.partition_point(|s| *s <= x - self.from).clamp(1, self.cells) - 1
    }

    /// Number of points.
    pub(super) fn points(&self) -> usize {
        self.cells + usize::from(self.grid == Grid::Nodes)
    }

    /// Right end.
    pub(super) fn to(&self) -> f64 {
        self.from + self.length
    }

    /// Whether a position is on the line.
    pub(super) fn holds(&self, x: f64) -> bool {
        let slack = SNAP * self.cell(x);
        x >= self.from - slack && x <= self.to() + slack
    }

    /// Point number as a real number: whole on points.
    fn coordinate(&self, x: f64) -> f64 {
        if let Some(stations) = &self.stations {
            let k = self.cell_number(stations, x);
            return k as f64 + (x - self.from - stations[k]) / (stations[k + 1] - stations[k]);
        }
        let shift = if self.grid == Grid::Cells { 0.5 } else { 0.0 };
        (x - self.from) / self.spacing() - shift
    }

    /// Cells, parts of them included, between two positions.
    pub(super) fn cells_between(&self, from: f64, to: f64) -> f64 {
        self.coordinate(to) - self.coordinate(from)
    }

    /// Nearest point to a position on the line.
    pub(super) fn nearest(&self, x: f64) -> usize {
        (self.coordinate(x).round().max(0.0) as usize).min(self.points() - 1)
    }

    /// The point before a position that has points on both sides.
    pub(super) fn before(&self, x: f64) -> Option<usize> {
        let below = self.coordinate(x).floor();
        (below >= 0.0 && below + 1.0 < self.points() as f64).then_some(below as usize)
    }

    /// Position of a point.
    pub(super) fn position(&self, point: usize) -> f64 {
        if let Some(stations) = &self.stations {
            return self.from + stations[point];
        }
        let shift = if self.grid == Grid::Cells { 0.5 } else { 0.0 };
        self.from + (point as f64 + shift) * self.spacing()
    }
}

impl Layout {
    /// An end of a member as a case writes it, for hints.
    pub(super) fn example(&self, end: EndOfMember) -> String {
        let name = self.frame.as_ref().map_or("", |frame| frame.members[end.member].name.as_str());
        let x = if end.side == 0 { 0.0 } else { self.lines[end.member].length };
        format!(r#"{{ "member": "{name}", "x": {} }}"#, tidy(x))
    }

    /// Line and real point of an end of a member.
    pub(super) fn end(&self, end: EndOfMember) -> (usize, usize) {
        (end.member, if end.side == 0 { 0 } else { self.lines[end.member].points() - 1 })
    }

    /// Position in the plane of the coordinate 0 of a line.
    pub(super) fn origin(&self, chain: usize) -> [f64; 2] {
        self.frame.as_ref().map_or([0.0; 2], |frame| frame.end(&frame.members[chain], 0))
    }

    /// Direction of a line in the plane.
    pub(super) fn direction(&self, chain: usize) -> [f64; 2] {
        self.frame.as_ref().map_or([1.0, 0.0], |frame| frame.members[chain].direction)
    }

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
        Some(self.place_on(chain, x))
    }

    /// The place of a position on a line that holds it.
    pub(super) fn place_on(&self, chain: usize, x: f64) -> Place {
        let line = &self.lines[chain];
        let point = line.nearest(x);
        if (line.coordinate(x) - point as f64).abs() <= SNAP {
            return Place::Point { chain, point };
        }
        for (side, end) in [line.from, line.to()].into_iter().enumerate() {
            if (x - end).abs() <= SNAP * line.cell(x) {
                return Place::End { chain, side };
            }
        }
        Place::Between { chain, x }
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

/// How many numbers of cells are tried for a hint.
const MOST_TRIED: usize = 1_000_000;

/// The smallest number of cells, not below the present one, that puts a point at `x`.
fn cells_with_point(line: &LayoutLine, x: f64) -> Option<usize> {
    let z = (x - line.from) / line.length;
    (line.grid == Grid::Nodes && line.stations.is_none())
        .then(|| {
            (line.cells..=2 * line.cells + 100)
                .take(MOST_TRIED)
                .find(|&n| ((z * n as f64).round() - z * n as f64).abs() < 1e-9)
        })
        .flatten()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_on_a_graded_grid_are_those_of_points_within_their_own_cells() {
        let stations = Some(vec![0.0, 1e-6, 0.5, 1.0]);
        let (grid, horizon_ratio) = (Grid::Nodes, 1.0);
        let line = LayoutLine { from: 2.0, length: 1.0, cells: 3, grid, horizon_ratio, stations };
        let treatment = &peristat_assembly::model::timoshenko_beam::end_treatment::TABLE[0];
        let layout = Layout { lines: vec![line], treatment, frame: None };
        let place = |x: f64| layout.place(x, &JsonPath::default(), "it", &mut Faults::default());
        let point = |point: usize| Some(Place::Point { chain: 0, point });
        assert_eq!([2.0, 2.000001, 2.5, 3.0].map(place), [0, 1, 2, 3].map(point));
        // A millionth of the long cell beside the second point, but a tenth of the short one.
        let x = 2.000_000_9;
        assert_eq!([x, 2.2].map(place), [x, 2.2].map(|x| Some(Place::Between { chain: 0, x })));
        assert_eq!(place(1.999_999), None);
    }
}
