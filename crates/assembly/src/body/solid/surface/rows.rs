//! Cells inside a surface, row by row.

use super::super::super::BORDER;
use super::super::super::lattice::SquareLattice;
use super::crossings::{Crossing, Shadow};
use super::distance;
use super::facets::Surface;
use super::grid::{Filled, Grid};
use super::nearest;
use std::ops::Range;

/// The cells inside: along every row the surface is entered and left, and centres on it are inside.
pub(super) fn fill(surface: &Surface, grid: &Grid) -> Filled {
    let slack = BORDER * grid.spacing + surface.rounding();
    let mut crossings = crossings(surface, grid);
    let mut on_border = on_border(surface, grid, slack);
    crossings.sort_unstable_by(|a, b| {
        (a.0, a.1.x).partial_cmp(&(b.0, b.1.x)).unwrap_or(std::cmp::Ordering::Equal)
    });
    on_border.sort_unstable();
    on_border.dedup();
    let (mut crossings, mut on_border) = (&crossings[..], &on_border[..]);
    let mut inside_out = None;
    let lattice =
        SquareLattice::of_lines(grid.spacing, grid.corner, [grid.cells[1], grid.cells[2]], |[row, layer]| {
            let line = grid.line([row, layer]);
            let own = take(&mut crossings, |crossing| crossing.0 == line);
            let mut columns = inside(own, grid, slack, |column| {
                let at = [grid.centre(0, column), grid.centre(1, row), grid.centre(2, layer)];
                inside_out.get_or_insert(at);
            });
            let extra = take(&mut on_border, |cell| cell.0 == line);
            columns.extend(extra.iter().map(|&(_, column)| column..column + 1));
            joined(columns)
        });
    Filled { lattice, inside_out }
}

/// What of a list belongs together at its start, which is taken from it.
fn take<'a, T>(list: &mut &'a [T], is_own: impl Fn(&T) -> bool) -> &'a [T] {
    let count = list.iter().take_while(|item| is_own(item)).count();
    let (own, rest) = list.split_at(count);
    *list = rest;
    own
}

impl Grid {
    /// Number of a row of a layer.
    fn line(&self, [row, layer]: [i32; 2]) -> u32 {
        layer as u32 * self.cells[1] as u32 + row as u32
    }
}

/// All crossings of all rows.
fn crossings(surface: &Surface, grid: &Grid) -> Vec<(u32, Crossing)> {
    let mut found = Vec::new();
    for facet in &surface.facets {
        let Some(shadow) = Shadow::new(facet) else { continue };
        let [low, high] = facet.range(2);
        // One more on both sides: rounding must not lose a row that runs through a corner.
        let around =
            |axis: usize, low: f64, high: f64| grid.between(axis, low - grid.spacing, high + grid.spacing);
        for layer in around(2, low, high) {
            let z = grid.centre(2, layer);
            let Some([low, high]) = nearest::span(facet, z, z) else { continue };
            for row in around(1, low, high) {
                let y = grid.centre(1, row);
                found.extend(shadow.crossing(y, z).map(|crossing| (grid.line([row, layer]), crossing)));
            }
        }
    }
    found
}

/// Cells whose centres are on the surface.
fn on_border(surface: &Surface, grid: &Grid, slack: f64) -> Vec<(u32, i32)> {
    let mut found = Vec::new();
    for facet in &surface.facets {
        grid.near(facet, slack, |[row, layer], columns| {
            for column in columns {
                let at = [grid.centre(0, column), grid.centre(1, row), grid.centre(2, layer)];
                if distance::squared(at, facet.corners) <= slack * slack {
                    found.push((grid.line([row, layer]), column));
                }
            }
        });
    }
    found
}

/// Columns of a row where it is inside: where it has entered more often than left. `is_outside` takes columns where it has left more
/// often.
fn inside(
    crossings: &[(u32, Crossing)],
    grid: &Grid,
    slack: f64,
    mut is_outside: impl FnMut(i32),
) -> Vec<Range<i32>> {
    let mut columns = Vec::new();
    let mut winding = 0;
    for (k, (_, crossing)) in crossings.iter().enumerate() {
        winding += crossing.turn;
        let Some((_, next)) = crossings.get(k + 1) else { break };
        let by = slack * f64::from(winding.signum());
        let between = grid.between(0, crossing.x - by, next.x + by);
        if winding > 0 {
            columns.push(between);
        } else if winding < 0 && !between.is_empty() {
            is_outside(between.start);
        }
    }
    columns
}

/// Ranges in order, with those that meet made one.
fn joined(mut columns: Vec<Range<i32>>) -> Vec<Range<i32>> {
    columns.retain(|range| !range.is_empty());
    columns.sort_unstable_by_key(|range| range.start);
    let mut all: Vec<Range<i32>> = Vec::new();
    for range in columns {
        match all.last_mut() {
            Some(last) if range.start <= last.end => last.end = last.end.max(range.end),
            _ => all.push(range),
        }
    }
    all
}
