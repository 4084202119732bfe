//! How corners of cells on the border move: as the nearest whole blocks of four points do, in solids of eight.

use super::super::super::Mirrors;
use super::super::super::neighbourhood::Neighbourhood;
use super::super::overlay::is_cut;
use crate::body::{Cell, SquareLattice};
use std::borrow::Cow;
use std::cell::RefCell;
use std::collections::{HashMap, HashSet};

/// Cells and their shares.
pub(in crate::model) type Shares = Vec<(Cell, f64)>;

/// A corner and, where there are cracks, the cell from which a bond comes.
type Asked = (Cell, Option<Cell>);

/// The cells of a body with its images, as far as mirrors make them.
pub(in crate::model) struct Cells<'a, const M: usize> {
    pub(in crate::model) lattice: &'a SquareLattice,
    pub(in crate::model) mirrors: &'a Mirrors,
    pub(in crate::model) neighbourhood: &'a Neighbourhood<M>,
    /// Bonds that cracks cut.
    pub(in crate::model) cuts: Cow<'a, HashSet<(usize, usize)>>,
}

impl<const M: usize> Cells<'_, M> {
    /// Whether there is a cell, stored or not.
    pub(super) fn has(&self, cell: Cell) -> bool {
        let image = if self.mirrors.is_none() { cell } else { self.mirrors.image(cell).0 };
        self.lattice.number(image).is_some()
    }

    /// Number of axes: those of a plane, or of a solid.
    pub(in crate::model) fn axes(&self) -> usize {
        if self.lattice.is_plane() { 2 } else { 3 }
    }

    /// Number of the point of a cell.
    pub(in crate::model) fn number(&self, cell: Cell) -> Option<u32> {
        self.lattice.number(cell).map(|number| number as u32)
    }

    /// Whether a crack runs between two neighbouring cells.
    pub(super) fn parted(&self, from: Cell, to: Cell) -> bool {
        is_cut(self.lattice, self.neighbourhood, &self.cuts, from, to)
    }
}

/// The displacement of corners of cells on the border. A corner has the indices of the cell whose lowest one it is; in a plane it
/// lies in the layer of the cells.
pub(in crate::model) struct Nodes<'a, const M: usize> {
    pub(in crate::model) cells: Cells<'a, M>,
    known: RefCell<HashMap<Asked, Option<Shares>>>,
}

impl<'a, const M: usize> Nodes<'a, M> {
    pub(in crate::model) fn new(cells: Cells<'a, M>) -> Self {
        Self { cells, known: RefCell::default() }
    }

    /// Cells and their shares in the displacement of a place on the border of a cell, in spacings from the corner `[0, 0, 0]`;
    /// none where the body is too thin to tell.
    pub(in crate::model) fn place(&self, at: [f64; 3], cell: Cell) -> Option<Shares> {
        let mut sum: Shares = Vec::new();
        for (corner, share) in around(at) {
            for (cell, own) in self.corner(corner, cell)? {
                match sum.iter_mut().find(|s| s.0 == cell) {
                    Some(known) => known.1 += share * own,
                    None => sum.push((cell, share * own)),
                }
            }
        }
        Some(sum)
    }

    /// Cells and their shares in the displacement of a corner on the border.
    pub(in crate::model) fn corner(&self, corner: Cell, from: Cell) -> Option<Shares> {
        let key = (corner, (!self.cells.cuts.is_empty()).then_some(from));
        if let Some(known) = self.known.borrow().get(&key) {
            return known.clone();
        }
        let found = self.extrapolated(corner, from);
        self.known.borrow_mut().insert(key, found.clone());
        found
    }

    /// From blocks beside the corner, or if there are none from those across an edge, or across the corner itself: the mean of all
    /// that are as near, each continued linearly along all axes.
    fn extrapolated(&self, corner: Cell, from: Cell) -> Option<Shares> {
        (1..=self.cells.axes()).find_map(|far| {
            let is_whole = |shift: &Cell| self.is_whole(corner, *shift, from);
            let blocks: Vec<Cell> = shifts(self.cells.axes(), far).into_iter().filter(is_whole).collect();
            let part = 1.0 / blocks.len() as f64;
            let cells = blocks.iter().flat_map(|shift| block(self.cells.axes(), corner, *shift));
            let all = cells.map(|(cell, s)| (cell, part * s));
            (!blocks.is_empty()).then(|| all.collect())
        })
    }

    /// Whether all cells of a block exist, and no crack runs between them nor between them and the cell that asks.
    fn is_whole(&self, corner: Cell, shift: Cell, from: Cell) -> bool {
        let cells: Vec<Cell> = block(self.cells.axes(), corner, shift).map(|(cell, _)| cell).collect();
        if !cells.iter().all(|cell| self.cells.has(*cell)) {
            return false;
        }
        if self.cells.cuts.is_empty() {
            return true;
        }
        let is_one =
            cells.iter().enumerate().all(|(k, a)| cells[..k].iter().all(|b| !self.cells.parted(*a, *b)));
        let is_near = |cell: &Cell| (0..3).all(|k| (cell[k] - from[k]).abs() <= 1);
        let joins = |cell: &&Cell| **cell == from || (is_near(cell) && !self.cells.parted(from, **cell));
        is_one && cells.iter().filter(|cell| is_near(cell)).count() > 0 && cells.iter().find(joins).is_some()
    }
}

/// Shifts of blocks from that about a corner, by one along so many axes and none along the others.
fn shifts(axes: usize, far: usize) -> Vec<Cell> {
    let mut all: Vec<Cell> = corners(axes, [-1, 0, 1]).collect();
    all.retain(|shift| shift.iter().filter(|k| **k != 0).count() == far);
    all.sort_by_key(|shift| shift.iter().position(|k| *k != 0));
    all
}

/// All choices of an index along each axis, the first one fastest; 0 along an axis that a plane has not.
fn corners<const N: usize>(axes: usize, along: [i32; N]) -> impl Iterator<Item = Cell> {
    let third = if axes > 2 { along.to_vec() } else { vec![0] };
    third.into_iter().flat_map(move |c| along.into_iter().flat_map(move |b| along.map(move |a| [a, b, c])))
}

/// The whole numbers around a position and their shares, linear along each axis, without those that are zero.
pub(in crate::model) fn around(at: [f64; 3]) -> impl Iterator<Item = (Cell, f64)> {
    /// Positions this close to a whole number are it.
    const SAME: f64 = 1e-9;
    let low = at.map(|x| (x + SAME).floor());
    let part = [0, 1, 2].map(|k| Some(at[k] - low[k]).filter(|f| *f > SAME).unwrap_or(0.0));
    (0..8).map(|k| [k & 1, k >> 1 & 1, k >> 2]).filter_map(move |step| {
        let along = |k: usize| if step[k] == 0 { 1.0 - part[k] } else { part[k] };
        let share = along(0) * along(1) * along(2);
        (share > 0.0).then_some(([0, 1, 2].map(|k| low[k] as i32 + step[k]), share))
    })
}

/// The cells of the block at a shift from a corner and their shares in its displacement: that of the middle along an axis
/// without a shift, 3/2 and −1/2 along one with.
fn block(axes: usize, corner: Cell, shift: Cell) -> impl Iterator<Item = (Cell, f64)> {
    let share = |shift: i32, far: i32| match shift {
        0 => 0.5,
        1 => [1.5, -0.5][far as usize],
        _ => [-0.5, 1.5][far as usize],
    };
    corners(axes, [0, 1]).map(move |far| {
        let mut cell = corner;
        (0..axes).for_each(|k| cell[k] += far[k] + shift[k] - 1);
        (cell, (0..axes).map(|k| share(shift[k], far[k])).product())
    })
}
