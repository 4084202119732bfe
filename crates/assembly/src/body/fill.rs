//! Filling outlines with the cells of a square lattice.

use super::BORDER;
use super::convex::Convex;
use super::geometry::Point;
use super::lattice::SquareLattice;
use super::outline::Outline;
use super::rows::Rows;
use super::turn::Turn;
use thiserror::Error;

/// Why an outline cannot be filled with cells of a size.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum FillError {
    /// The spacing is not above zero.
    #[error("the spacing must be above zero, found {found}")]
    Spacing {
        /// What was given.
        found: f64,
    },
    /// The sides of a rectangle are no whole numbers of cells.
    #[error(
        "the rectangle is {} × {} cells, which are not whole numbers{}", .cells[0], .cells[1],
        fitting_text(.fitting)
    )]
    NotWhole {
        /// Cells along each side.
        cells: [f64; 2],
        /// The nearest spacings below and above that fit, m; none if the sides have no common measure nearby.
        fitting: Vec<f64>,
    },
    /// More cells than can be numbered.
    #[error("the box around the body has {cells:e} cells, more than {} can be numbered", u32::MAX)]
    TooManyCells {
        /// How many there are.
        cells: f64,
    },
    /// No cell has its centre in the body.
    #[error("no cell has its centre in the body: the spacing is too large")]
    NoPoints,
    /// A hole is missed by all centres and parts no points, so it would have no effect.
    #[error("no centre of a cell is in hole {hole}: the spacing is too large for it")]
    NoCellInHole {
        /// Which hole, from zero, in the order in which they were cut.
        hole: usize,
    },
}

fn fitting_text(fitting: &[f64]) -> String {
    let numbers: Vec<String> = fitting.iter().map(f64::to_string).collect();
    if numbers.is_empty() {
        String::new()
    } else {
        format!("; nearest spacings that fit: {}", numbers.join(", "))
    }
}

/// Sides of rectangles are whole numbers of cells to this relative error.
const WHOLE: f64 = 1e-9;

/// Where the cells of an outline are.
struct Grid {
    /// Lower left corner of cell `[0, 0]`, m.
    corner: Point,
    /// Columns and rows.
    size: [i32; 2],
}

impl Outline {
    /// Columns and rows of cells that cover the box around it, in axes turned by an angle, rad.
    ///
    /// # Errors
    /// [`FillError::Spacing`], [`FillError::NotWhole`] for a rectangle that is not turned, [`FillError::TooManyCells`].
    pub fn cells(&self, spacing: f64, angle: f64) -> Result<[i32; 2], FillError> {
        match Turn::new(angle, self.middle()) {
            None => Ok(self.grid(spacing)?.size),
            Some(axes) => Ok(self.seen_from(&axes).centred_grid(spacing)?.size),
        }
    }

    /// Middle of the box around it.
    fn middle(&self) -> Point {
        let [low, high] = self.bounds();
        [0, 1].map(|k| low[k] + 0.5 * (high[k] - low[k]))
    }

    /// Cells from the lower left corner of the box.
    fn grid(&self, spacing: f64) -> Result<Grid, FillError> {
        let [low, high] = self.bounds();
        let size = [0, 1].map(|k| high[k] - low[k]);
        // Rounding of the corners of a body far from the origin is no fault of its size.
        let rounding = [0, 1].map(|k| 4.0 * f64::EPSILON * low[k].abs().max(high[k].abs()) / spacing);
        let cells = size.map(|s| s / spacing);
        let whole = [0, 1].map(|k| is_whole(cells[k], rounding[k]));
        countable(cells, spacing)?;
        if self.is_rectangle() && whole != [true; 2] {
            return Err(FillError::NotWhole { cells, fitting: fitting(&size, spacing) });
        }
        let size = [0, 1].map(|k| if whole[k] { cells[k].round() as i32 } else { cells[k].ceil() as i32 });
        Ok(Grid { corner: low, size })
    }

    /// Cells of which one has its centre at the origin.
    fn centred_grid(&self, spacing: f64) -> Result<Grid, FillError> {
        let [low, high] = self.bounds();
        countable([0, 1].map(|k| (high[k] - low[k]) / spacing + 1.0), spacing)?;
        // Halves of cells beside the one in the middle, which rounding shall not begin.
        let beyond = |length: f64| (length / spacing - 0.5 - WHOLE).ceil().max(0.0);
        let before = low.map(|x| beyond(-x));
        Ok(Grid {
            corner: before.map(|n| -(n + 0.5) * spacing),
            size: [0, 1].map(|k| (before[k] + beyond(high[k])) as i32 + 1),
        })
    }

    /// The cells whose centres are in the body; the lower left corner of the first one is that of the box around the body.
    ///
    /// Centres within [`BORDER`] of a border are on it, and borders belong to the body, those of holes as well: bodies that
    /// are symmetric about lines of the lattice have symmetric cells, whatever the rounding of their coordinates. Cells that
    /// a border cuts have the area of the body in them and in next cells whose centres are outside.
    ///
    /// # Errors
    /// [`FillError`].
    pub fn fill(&self, spacing: f64) -> Result<SquareLattice, FillError> {
        let grid = self.grid(spacing)?;
        if self.is_rectangle() && self.holes().is_empty() {
            return Ok(SquareLattice::rectangle(spacing, grid.corner, grid.size));
        }
        self.fill_grid(spacing, &grid)
    }

    /// As [`fill`](Self::fill), with rows turned by an angle, rad, counter-clockwise from x. The centre of a cell is in the
    /// middle of the box around the body, and rectangles are of any size. Multiples of a right angle turn nothing.
    ///
    /// # Errors
    /// [`FillError`].
    pub fn fill_turned(&self, spacing: f64, angle: f64) -> Result<SquareLattice, FillError> {
        let middle = self.middle();
        let Some(axes) = Turn::new(angle, middle) else { return self.fill(spacing) };
        // In its own axes the lattice is as any other.
        let inner = self.seen_from(&axes);
        let lattice = inner.fill_grid(spacing, &inner.centred_grid(spacing)?)?;
        Ok(lattice.turned(angle, middle))
    }

    fn fill_grid(&self, spacing: f64, &Grid { corner, size }: &Grid) -> Result<SquareLattice, FillError> {
        let in_cells = |[x, y]: Point| [(x - corner[0]) / spacing - 0.5, (y - corner[1]) / spacing - 0.5];
        let closed: Vec<Point> = self.border().vertices().iter().map(|v| in_cells(*v)).collect();
        let solid = Rows::inside(size, &closed).or(Rows::border(size, &closed, BORDER));
        let (mut rows, mut missed) = (solid.clone(), Vec::new());
        for (hole, cut) in self.holes().iter().enumerate() {
            let removed = match (cut.shape.polygon(), cut.shape.stadium()) {
                (_, Some((from, to, radius))) => {
                    let radius = radius / spacing - BORDER;
                    Rows::within(size, &Convex::Stadium { from: in_cells(from), to: in_cells(to), radius })
                }
                (Some(polygon), _) => {
                    let vertices: Vec<Point> = polygon.vertices().iter().map(|v| in_cells(*v)).collect();
                    Rows::inside(size, &vertices).without(&Rows::border(size, &vertices, BORDER))
                }
                _ => continue,
            };
            if !removed.meets(&solid) {
                missed.push(hole);
            }
            rows = rows.without(&removed);
        }
        if rows.is_empty() {
            return Err(FillError::NoPoints);
        }
        let lattice =
            SquareLattice::plane(spacing, corner, 0..size[0], 0..size[1], |cell| rows.contains(cell));
        let lattice = self.with_thin_slots(lattice, &missed)?;
        let areas = self.areas(&lattice, size);
        let lattice = lattice.with_areas(&areas);
        let blocks = if lattice.cut_cells().is_empty() { Vec::new() } else { self.blocks(&lattice, size) };
        Ok(lattice.with_blocks(blocks))
    }
}

/// Whether a number of cells is a whole one.
pub(super) fn is_whole(cells: f64, rounding: f64) -> bool {
    let nearest = cells.round();
    nearest >= 1.0 && (cells - nearest).abs() <= WHOLE * nearest + rounding
}

/// # Errors
/// The spacing is none, or there are more cells than can be numbered.
fn countable(cells: [f64; 2], spacing: f64) -> Result<(), FillError> {
    if !(spacing > 0.0 && spacing.is_finite()) {
        return Err(FillError::Spacing { found: spacing });
    }
    let all = cells[0].ceil() * cells[1].ceil();
    if all > f64::from(u32::MAX) || cells.iter().any(|c| *c > 1e9) {
        return Err(FillError::TooManyCells { cells: all });
    }
    Ok(())
}

/// The nearest spacings below and above one of which all sides are whole multiples: one that is such counts as below, and
/// there may be none.
pub fn fitting_spacings(size: &[f64], spacing: f64) -> [Option<f64>; 2] {
    let short = size.iter().copied().fold(f64::INFINITY, f64::min);
    let fits = |n: &f64| {
        size.iter().all(|side| {
            let cells = side / (short / n);
            (cells - cells.round()).abs() <= WHOLE * cells
        })
    };
    let number = short / spacing;
    let first = (number * (1.0 - WHOLE)).ceil().max(1.0);
    let finer = (0..1000).map(|k| first + f64::from(k)).find(fits);
    let coarser = (1..=1000).map(|k| first - f64::from(k)).take_while(|n| *n >= 1.0).find(fits);
    [finer, coarser].map(|number| number.map(|n| short / n))
}

/// The same as a list.
pub(super) fn fitting(size: &[f64], spacing: f64) -> Vec<f64> {
    fitting_spacings(size, spacing).into_iter().flatten().collect()
}

#[cfg(test)]
mod tests;
