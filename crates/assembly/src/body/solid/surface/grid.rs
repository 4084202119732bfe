//! Cells around a surface, and those inside it.

use super::super::super::fill::fitting;
use super::super::super::lattice::SquareLattice;
use super::facets::Surface;
use super::rows;
use thiserror::Error;

/// Sides of the box around a surface are whole numbers of cells within so many cells: files hold coordinates in single precision.
const WHOLE: f64 = 1e-4;

/// A box of cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    /// Side of a cell, m.
    pub spacing: f64,
    /// Its lowest corner, m.
    pub corner: [f64; 3],
    /// Columns, rows and layers.
    pub cells: [i32; 3],
    /// How many cells the box around the surface is along each axis.
    pub exact: [f64; 3],
}

/// The cells inside a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Filled {
    /// Their centres.
    pub lattice: SquareLattice,
    /// Where shells are inside out: a cell that a surface encloses which looks inwards, m.
    pub inside_out: Option<[f64; 3]>,
}

/// Why there are no cells.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum GridError {
    /// The spacing is not above zero.
    #[error("`spacing` must be greater than zero, found {found}")]
    Spacing {
        /// What was given.
        found: f64,
    },
    /// More cells than can be numbered.
    #[error("the box around the body has {cells:e} cells, too many to number")]
    TooManyCells {
        /// How many there are.
        cells: f64,
    },
}

impl Surface {
    /// The cells of the box around it: its sides are on those of the box where these are whole numbers of cells; elsewhere as many as
    /// come nearest are in the middle.
    ///
    /// # Errors
    /// [`GridError`].
    pub fn grid(&self, spacing: f64) -> Result<Grid, GridError> {
        if !(spacing > 0.0 && spacing.is_finite()) {
            return Err(GridError::Spacing { found: spacing });
        }
        let [low, high] = self.bounds();
        let exact = [0, 1, 2].map(|k| (high[k] - low[k]) / spacing);
        let cells = exact.map(|cells| cells.round().max(1.0));
        let count: f64 = cells.iter().product();
        if count > f64::from(u32::MAX) || cells.iter().any(|c| *c > 1e9) {
            return Err(GridError::TooManyCells { cells: count });
        }
        let corner = |k: usize| match (exact[k] - cells[k]).abs() <= WHOLE {
            true => low[k],
            false => 0.5 * (low[k] + high[k] - cells[k] * spacing),
        };
        Ok(Grid { spacing, corner: [0, 1, 2].map(corner), cells: cells.map(|c| c as i32), exact })
    }

    /// The cells of a box whose centres are inside; centres on the surface are.
    pub fn fill(&self, grid: &Grid) -> Filled {
        rows::fill(self, grid)
    }
}

impl Grid {
    /// Axes along which the box around the surface is no whole number of cells.
    pub fn is_off(&self) -> [bool; 3] {
        [0, 1, 2].map(|k| (self.exact[k] - f64::from(self.cells[k])).abs() > WHOLE)
    }

    /// The nearest spacings below and above of which the sides of the box are whole multiples, m; there may be none.
    pub fn fitting(&self) -> Vec<f64> {
        // What single precision leaves of a whole number is none of a ratio.
        let tidy = |cells: f64| (cells * 1e6).round() / 1e6 * self.spacing;
        fitting(&self.exact.map(tidy), self.spacing)
    }

    /// Position of a side of the box, m: low and high along x, y and z.
    pub fn side(&self, side: usize) -> f64 {
        let cells = if side.is_multiple_of(2) { 0 } else { self.cells[side / 2] };
        self.corner[side / 2] + f64::from(cells) * self.spacing
    }

    /// Rows of cells along x.
    pub fn lines(&self) -> f64 {
        f64::from(self.cells[1]) * f64::from(self.cells[2])
    }

    /// The centre of a cell along an axis, m.
    pub(super) fn centre(&self, axis: usize, cell: i32) -> f64 {
        self.corner[axis] + (f64::from(cell) + 0.5) * self.spacing
    }

    /// The cells whose centres are between two coordinates along an axis, m.
    pub(super) fn between(&self, axis: usize, from: f64, to: f64) -> std::ops::Range<i32> {
        let place = |x: f64| (x - self.corner[axis]) / self.spacing - 0.5;
        let most = f64::from(self.cells[axis]);
        let first = place(from).ceil().clamp(0.0, most) as i32;
        let end = (place(to).floor() + 1.0).clamp(0.0, most) as i32;
        first..end.max(first)
    }
}
