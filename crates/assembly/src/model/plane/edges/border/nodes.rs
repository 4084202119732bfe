//! How corners of cells on the border move: as the nearest whole blocks of four points do.

use super::super::super::Mirrors;
use super::super::super::neighbourhood::Neighbourhood;
use super::super::overlay::is_cut;
use crate::body::{Cell, SquareLattice};
use std::borrow::Cow;
use std::cell::RefCell;
use std::collections::{HashMap, HashSet};

/// Cells and their shares.
type Shares = Vec<(Cell, f64)>;

/// A corner and, where there are cracks, the cell from which a bond comes.
type Asked = (Cell, Option<Cell>);

/// The cells of a body with its images, as far as mirrors make them.
pub(super) struct Cells<'a, const M: usize> {
    pub(super) lattice: &'a SquareLattice,
    pub(super) mirrors: &'a Mirrors,
    pub(super) hood: &'a Neighbourhood<M>,
    /// Bonds that cracks cut.
    pub(super) cuts: Cow<'a, HashSet<(usize, usize)>>,
}

impl<const M: usize> Cells<'_, M> {
    /// Whether there is a cell, stored or not.
    pub(super) fn has(&self, cell: Cell) -> bool {
        let image = if self.mirrors.is_none() { cell } else { self.mirrors.image(cell).0 };
        self.lattice.number(image).is_some()
    }

    /// Number of the point of a cell.
    pub(super) fn number(&self, cell: Cell) -> Option<u32> {
        self.lattice.number(cell).map(|number| number as u32)
    }

    /// Whether a crack runs between two neighbouring cells.
    pub(super) fn parted(&self, from: Cell, to: Cell) -> bool {
        is_cut(self.lattice, self.hood, &self.cuts, from, to)
    }
}

/// The displacement of corners of cells on the border. The corner `[i, j]` is that below and to the left of the cell.
pub(super) struct Nodes<'a, const M: usize> {
    pub(super) cells: Cells<'a, M>,
    known: RefCell<HashMap<Asked, Option<Shares>>>,
}

impl<'a, const M: usize> Nodes<'a, M> {
    pub(super) fn new(cells: Cells<'a, M>) -> Self {
        Self { cells, known: RefCell::default() }
    }

    /// Cells and their shares in the displacement of a place on the border of a cell, in spacings from the corner `[0, 0]`;
    /// none where the body is too thin to tell.
    pub(super) fn place(&self, at: [f64; 2], cell: Cell) -> Option<Shares> {
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
    fn corner(&self, corner: Cell, from: Cell) -> Option<Shares> {
        let key = (corner, (!self.cells.cuts.is_empty()).then_some(from));
        if let Some(known) = self.known.borrow().get(&key) {
            return known.clone();
        }
        let found = self.extrapolated(corner, from);
        self.known.borrow_mut().insert(key, found.clone());
        found
    }

    /// From blocks beside the corner, or if there are none from those across: the mean of all, each continued linearly along
    /// both axes.
    fn extrapolated(&self, corner: Cell, from: Cell) -> Option<Shares> {
        const BESIDE: [Cell; 4] = [[-1, 0, 0], [1, 0, 0], [0, -1, 0], [0, 1, 0]];
        const ACROSS: [Cell; 4] = [[-1, -1, 0], [1, -1, 0], [-1, 1, 0], [1, 1, 0]];
        [&BESIDE, &ACROSS].into_iter().find_map(|shifts| {
            let blocks: Vec<Cell> =
                shifts.iter().copied().filter(|s| self.is_whole(corner, *s, from)).collect();
            let part = 1.0 / blocks.len() as f64;
            let all = blocks.iter().flat_map(|shift| block(corner, *shift)).map(|(cell, s)| (cell, part * s));
            (!blocks.is_empty()).then(|| all.collect())
        })
    }

    /// Whether all four cells of a block exist, and no crack runs between them nor between them and the cell that asks.
    fn is_whole(&self, corner: Cell, shift: Cell, from: Cell) -> bool {
        let cells: Vec<Cell> = block(corner, shift).map(|(cell, _)| cell).collect();
        if !cells.iter().all(|cell| self.cells.has(*cell)) {
            return false;
        }
        if self.cells.cuts.is_empty() {
            return true;
        }
        let is_one =
            cells.iter().enumerate().all(|(k, a)| cells[..k].iter().all(|b| !self.cells.parted(*a, *b)));
        let is_near = |cell: &Cell| (0..2).all(|k| (cell[k] - from[k]).abs() <= 1);
        let joins = |cell: &&Cell| **cell == from || (is_near(cell) && !self.cells.parted(from, **cell));
        is_one && cells.iter().filter(|cell| is_near(cell)).count() > 0 && cells.iter().find(joins).is_some()
    }
}

/// The whole numbers around a position and their bilinear shares, without those that are zero.
pub(super) fn around(at: [f64; 2]) -> impl Iterator<Item = (Cell, f64)> {
    /// Positions this close to a whole number are it.
    const SAME: f64 = 1e-9;
    let low = at.map(|x| (x + SAME).floor());
    let part = [0, 1].map(|k| Some(at[k] - low[k]).filter(|f| *f > SAME).unwrap_or(0.0));
    [[0, 0], [1, 0], [0, 1], [1, 1]].into_iter().filter_map(move |[dx, dy]| {
        let along = |d: i32, f: f64| if d == 0 { 1.0 - f } else { f };
        let share = along(dx, part[0]) * along(dy, part[1]);
        (share > 0.0).then_some(([low[0] as i32 + dx, low[1] as i32 + dy, 0], share))
    })
}

/// The cells of the block at a shift from a corner and their shares in its displacement: that of the middle along an axis
/// without a shift, 3/2 and −1/2 along one with.
fn block(corner: Cell, shift: Cell) -> impl Iterator<Item = (Cell, f64)> {
    let share = |shift: i32, far: i32| match shift {
        0 => 0.5,
        1 => [1.5, -0.5][far as usize],
        _ => [-0.5, 1.5][far as usize],
    };
    [[0, 0], [1, 0], [0, 1], [1, 1]].into_iter().map(move |[a, b]| {
        let cell = [corner[0] - 1 + shift[0] + a, corner[1] - 1 + shift[1] + b, corner[2]];
        (cell, share(shift[0], a) * share(shift[1], b))
    })
}
