//! Blocks of cubes with parts cut out of them.

use super::super::BORDER;
use super::super::fill::{fitting, is_whole};
use super::super::lattice::{Cell, SquareLattice};
use super::cut::{Cut, CutError};
use std::cell::RefCell;
use thiserror::Error;

/// Names of the sides of a block, in the order of [`Mirrors::set_line`](crate::model::plane::Mirrors::set_line): low and high along
/// x, y and z.
pub const SIDES: [&str; 6] = ["left", "right", "bottom", "top", "back", "front"];

/// A block whose sides are along the axes, without the parts that are cut out of it.
#[derive(Clone, Debug, PartialEq)]
pub struct SolidShape {
    from: [f64; 3],
    to: [f64; 3],
    /// What is cut out, with names.
    pub(super) cuts: Vec<(Option<String>, Cut)>,
}

/// A plane that bounds a body across an axis, such as a side of a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// The axis across it.
    pub axis: usize,
    /// Whether it is the higher one of two along its axis.
    pub is_high: bool,
    /// Where it is along its axis, m.
    pub at: f64,
}

impl Face {
    /// Unit normal that points out of the body.
    pub fn normal(&self) -> [f64; 3] {
        let mut normal = [0.0; 3];
        normal[self.axis] = if self.is_high { 1.0 } else { -1.0 };
        normal
    }
}

/// Why a block cannot be made.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ShapeError {
    /// A side has no length, or is not finite.
    #[error("`size` must be greater than zero, found {found}")]
    Size {
        /// Along which axis.
        axis: usize,
        /// What was given.
        found: f64,
    },
    /// A corner is not finite.
    #[error("`from` must be finite")]
    Corner,
    /// The spacing is not above zero.
    #[error("`spacing` must be greater than zero, found {found}")]
    Spacing {
        /// What was given.
        found: f64,
    },
    /// The sides of the block are no whole numbers of cells.
    #[error("the block is {} × {} × {} cells, which are not whole numbers", .cells[0], .cells[1], .cells[2])]
    NotWhole {
        /// Cells along each side.
        cells: [f64; 3],
        /// The nearest spacings below and above that fit, m; none if the sides have no common measure nearby.
        fitting: Vec<f64>,
    },
    /// More cells than can be numbered.
    #[error("{cells:e} cells are too many to number")]
    TooManyCells {
        /// How many there are.
        cells: f64,
    },
    /// Nothing is left.
    #[error("no cell has its centre in the body")]
    NoPoints,
    /// A cut is missed by all centres, so that it would have no effect.
    #[error("no cell has its centre in this cut: it would do nothing")]
    NoCellInCut {
        /// Which cut, from zero.
        cut: usize,
    },
}

impl SolidShape {
    /// A block by its lowest corner and its size, m.
    ///
    /// # Errors
    /// [`ShapeError::Corner`], [`ShapeError::Size`].
    pub fn block(from: [f64; 3], size: [f64; 3]) -> Result<Self, ShapeError> {
        if !from.iter().all(|x| x.is_finite()) {
            return Err(ShapeError::Corner);
        }
        match (0..3).find(|&k| !(size[k] > 0.0 && size[k].is_finite())) {
            Some(axis) => Err(ShapeError::Size { axis, found: size[axis] }),
            None => Ok(Self { from, to: [0, 1, 2].map(|k| from[k] + size[k]), cuts: Vec::new() }),
        }
    }

    /// Cuts a part out of it, which may have a name.
    ///
    /// # Errors
    /// [`CutError`].
    pub fn cut(&mut self, name: Option<String>, cut: Cut) -> Result<(), CutError> {
        cut.check()?;
        self.cuts.push((name, cut));
        Ok(())
    }

    /// Lowest and highest corner of the block, m.
    pub fn bounds(&self) -> [[f64; 3]; 2] {
        [self.from, self.to]
    }

    /// Whether nothing is cut out of it.
    pub fn is_block(&self) -> bool {
        self.cuts.is_empty()
    }

    /// The sides of the block, in the order of [`SIDES`].
    pub fn faces(&self) -> [Face; 6] {
        std::array::from_fn(|side| {
            let (axis, is_high) = (side / 2, side % 2 == 1);
            Face { axis, is_high, at: if is_high { self.to[axis] } else { self.from[axis] } }
        })
    }

    /// Columns, rows and layers of cells.
    ///
    /// # Errors
    /// [`ShapeError::Spacing`], [`ShapeError::NotWhole`], [`ShapeError::TooManyCells`].
    pub fn cells(&self, spacing: f64) -> Result<[i32; 3], ShapeError> {
        if !(spacing > 0.0 && spacing.is_finite()) {
            return Err(ShapeError::Spacing { found: spacing });
        }
        let size = [0, 1, 2].map(|k| self.to[k] - self.from[k]);
        let rounding = |k: usize| 4.0 * f64::EPSILON * self.from[k].abs().max(self.to[k].abs()) / spacing;
        let cells = size.map(|s| s / spacing);
        let count: f64 = cells.iter().product();
        if count > f64::from(u32::MAX) || cells.iter().any(|c| *c > f64::from(i32::MAX)) {
            return Err(ShapeError::TooManyCells { cells: count.round() });
        }
        match (0..3).all(|k| is_whole(cells[k], rounding(k))) {
            true => Ok(cells.map(|c| c.round() as i32)),
            false => Err(ShapeError::NotWhole { cells, fitting: fitting(&size, spacing) }),
        }
    }

    /// The cells whose centres are in the body; centres on the border of a cut belong to the body.
    ///
    /// # Errors
    /// [`ShapeError`].
    pub fn fill(&self, spacing: f64) -> Result<SquareLattice, ShapeError> {
        let size = self.cells(spacing)?;
        if self.is_block() {
            return Ok(SquareLattice::cuboid(spacing, self.from, size));
        }
        let (ranges, slack) = (size.map(|n| 0..n), BORDER * spacing);
        let centre = |cell: Cell| [0, 1, 2].map(|k| self.from[k] + (f64::from(cell[k]) + 0.5) * spacing);
        let met = RefCell::new(vec![false; self.cuts.len()]);
        let is_left = |cell: Cell| {
            let at = centre(cell);
            let mut is_cut = false;
            for ((_, cut), met) in self.cuts.iter().zip(met.borrow_mut().iter_mut()) {
                let is_in = cut.contains(at, slack);
                *met |= is_in;
                is_cut |= is_in;
            }
            !is_cut
        };
        let lattice = SquareLattice::new(spacing, self.from, ranges, is_left);
        if let Some(cut) = met.into_inner().iter().position(|met| !met) {
            return Err(ShapeError::NoCellInCut { cut });
        }
        if lattice.points() == 0 { Err(ShapeError::NoPoints) } else { Ok(lattice) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_have_their_cells_and_faces() {
        let shape = SolidShape::block([1.0, 2.0, 3.0], [0.4, 0.2, 0.6]).unwrap();
        let lattice = shape.fill(0.1).unwrap();
        assert_eq!((lattice.points(), shape.cells(0.1).unwrap()), (4 * 2 * 6, [4, 2, 6]));
        let first = lattice.position(0);
        assert!([1.05, 2.05, 3.05].iter().zip(first).all(|(a, b)| (a - b).abs() < 1e-12));
        let [left, .., front] = shape.faces();
        assert_eq!((left.at, left.normal()), (1.0, [-1.0, 0.0, 0.0]));
        assert_eq!((front.at, front.normal()), (3.6, [0.0, 0.0, 1.0]));
        let Err(ShapeError::NotWhole { fitting, .. }) = shape.fill(0.15) else { panic!() };
        // 0.4, 0.2 and 0.6 are whole multiples of 0.1 and 0.2.
        assert!(fitting.iter().any(|s| (s - 0.2).abs() < 1e-12), "{fitting:?}");
        assert_eq!(shape.fill(0.0), Err(ShapeError::Spacing { found: 0.0 }));
        let flat = SolidShape::block([0.0; 3], [1.0, 0.0, 1.0]);
        assert_eq!(flat, Err(ShapeError::Size { axis: 1, found: 0.0 }));
    }

    #[test]
    fn cuts_take_the_cells_whose_centres_are_inside() {
        let block = || SolidShape::block([0.0; 3], [10.0; 3]).unwrap();
        let left = |cut: Cut| {
            let mut shape = block();
            shape.cut(None, cut).unwrap();
            shape.fill(1.0).map(|lattice| lattice.points())
        };
        assert_eq!(left(Cut::Block { from: [0.0; 3], to: [2.0, 3.0, 4.0] }), Ok(1000 - 24));
        // A bore of radius 1.5 around (5, 5) takes the four centres at √½ and the eight at √(½² + 1.5²) = 1.58 stay.
        assert_eq!(left(Cut::Bore { axis: 2, centre: [5.0; 3], radius: 1.5, outside: false }), Ok(1000 - 40));
        // A ball of radius 1.5: eight centres at √¾.
        assert_eq!(left(Cut::Ball { centre: [5.0; 3], radius: 1.5, outside: false }), Ok(992));
        let nothing = Cut::Ball { centre: [5.0; 3], radius: 0.5, outside: false };
        assert_eq!(left(nothing), Err(ShapeError::NoCellInCut { cut: 0 }));
        assert_eq!(left(Cut::Block { from: [-1.0; 3], to: [11.0; 3] }), Err(ShapeError::NoPoints));
        let wrong = Cut::Bore { axis: 0, centre: [0.0; 3], radius: -1.0, outside: false };
        assert_eq!(block().cut(None, wrong), Err(CutError::Radius { found: -1.0 }));
    }
}
