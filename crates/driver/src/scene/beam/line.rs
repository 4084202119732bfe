//! A line with its horizon and grid.

use super::grading::stations;
use super::place::LayoutLine;
use crate::case::Case;
use crate::diagnostic::{Faults, JsonPath, root};
use crate::scene::horizon::horizon_ratio;

/// Largest number of points: they are numbered by 32 bits.
pub(super) const MOST_POINTS: usize = 2_000_000_000;

/// A line with its horizon and grid; `path` is its own.
pub(super) fn layout_line(
    case: &Case,
    line: &crate::case::Line,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<LayoutLine> {
    let (from, length, cells, grid) = (line.from, line.length, line.cells, line.grid);
    let Some(grading) = &line.grading else {
        let horizon_ratio = horizon_ratio(case, length / cells as f64, 3.0, faults)?;
        return Some(LayoutLine { from, length, cells, grid, horizon_ratio, stations: None });
    };
    let horizon_ratio = neighbours(case, faults);
    let stations = stations(grading, from, length, cells, &path.key("grading"), faults)?;
    let horizon_ratio = horizon_ratio?;
    Some(LayoutLine { from, length, cells, grid, horizon_ratio, stations: Some(stations) })
}

/// The horizon ratio on a graded grid: the number of neighbours on each side.
fn neighbours(case: &Case, faults: &mut Faults) -> Option<f64> {
    if case.horizon.is_some() {
        faults
            .error(
                root("horizon"),
                "`horizon` is a length, and families of a graded grid have a number of neighbours",
            )
            .hint("give `horizon_ratio`, the number of neighbours on each side");
        return None;
    }
    let ratio = horizon_ratio(case, 1.0, 3.0, faults)?;
    if ratio.fract() != 0.0 {
        faults
            .error(
                root("horizon_ratio"),
                format!("`horizon_ratio` must be whole on a graded grid, found {ratio}"),
            )
            .hint("it is the number of neighbours on each side");
        return None;
    }
    Some(ratio)
}
