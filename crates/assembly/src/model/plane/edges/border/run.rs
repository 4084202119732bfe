//! What of a bond lies within the body.

use super::super::super::Mirrors;
use super::super::super::critical_along::PartOfPath;
use super::nodes::{Cells, Nodes, around};
use super::path::Path;
use crate::body::{Cell, SquareLattice, minus, plus};
use crate::stiffness::Place;

/// What a run ends at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::model) enum End {
    /// The point of a cell.
    Point(Cell),
    /// A place on the border of a cell, in spacings from the corner `[0, 0, 0]`.
    Border([f64; 3], Cell),
}

/// A run of cells along the path of a bond, one after the other.
pub(in crate::model) struct Run<'a> {
    path: &'a Path,
    /// Cell of the first point of the bond, whether there is one or not.
    pub(super) start: Cell,
    /// First cell, and behind the last one, by their places on the path.
    pieces: [usize; 2],
}

/// Calls `visit` with every run that is less than its whole bond, of the bonds of a path; `near` are the points within reach
/// of a border.
pub(super) fn for_each_run<const M: usize>(
    cells: &Cells<M>,
    path: &Path,
    near: &[usize],
    visit: &mut dyn FnMut(&Run),
) {
    let count = path.cells.len();
    for &point in near {
        let cell = cells.lattice.cell(point);
        for (first, step) in path.cells.iter().enumerate() {
            let start = minus(cell, *step);
            let has = |p: usize| cells.has(plus(start, path.cells[p]));
            // A run is met at its first cell.
            if first > 0 && has(first - 1) {
                continue;
            }
            let end = (first + 1..count).find(|&p| !has(p)).unwrap_or(count);
            if (first, end) != (0, count) {
                visit(&Run { path, start, pieces: [first, end] });
            }
        }
    }
}

impl Run<'_> {
    /// Its length over that of the whole bond.
    pub(in crate::model) fn share(&self) -> f64 {
        self.path.share(self.pieces[0], self.pieces[1])
    }

    /// Its cells, and the parts of the whole bond that they have.
    pub(in crate::model) fn cells(&self) -> impl Iterator<Item = (Cell, f64)> + '_ {
        (self.pieces[0]..self.pieces[1]).map(|p| (self.cell(p), self.path.share(p, p + 1)))
    }

    /// Its first and its last cell, if they are real.
    pub(in crate::model) fn ends_of(&self, mirrors: &Mirrors) -> [Option<Cell>; 2] {
        let ends = [self.cell(self.pieces[0]), self.cell(self.pieces[1] - 1)];
        ends.map(|cell| (mirrors.is_none() || mirrors.is_real(cell)).then_some(cell))
    }

    /// Whether it begins, and whether it ends, at a point of the bond.
    pub(in crate::model) fn has_points(&self) -> [bool; 2] {
        [self.pieces[0] == 0, self.pieces[1] == self.path.cells.len()]
    }

    /// Places of its first cell on the path of its bond, and of the first one behind its last.
    pub(in crate::model) fn places(&self) -> [u8; 2] {
        // Bonds that end on a border pass thirty cells at most.
        self.pieces.map(|piece| piece as u8)
    }

    /// Its cells on the path of its bond.
    pub(super) fn on_path(&self, lattice: &SquareLattice) -> Option<PartOfPath> {
        let [first, _] = self.places();
        let point = lattice.number(self.first())? as u32;
        Some(PartOfPath { pieces: self.places(), known: (first, point) })
    }

    /// Its first cell.
    pub(in crate::model) fn first(&self) -> Cell {
        self.cell(self.pieces[0])
    }

    /// The point of the bond that it begins or ends at, if it does.
    pub(super) fn point<const M: usize>(&self, cells: &Cells<M>) -> Option<u32> {
        match self.has_points() {
            [true, _] => cells.number(self.start),
            [_, true] => cells.number(self.cell(self.pieces[1] - 1)),
            _ => None,
        }
    }

    fn cell(&self, piece: usize) -> Cell {
        plus(self.start, self.path.cells[piece])
    }

    /// Whether a crack runs between two of its cells.
    pub(super) fn is_cut<const M: usize>(&self, cells: &Cells<M>) -> bool {
        let [first, end] = self.pieces;
        !cells.cuts.is_empty() && (first + 1..end).any(|p| cells.parted(self.cell(p - 1), self.cell(p)))
    }

    /// The part of it that counts: half for each end that is real. A place on a line of symmetry, or between joined sides, is
    /// so by half, as its images are.
    pub(super) fn counted(&self, mirrors: &Mirrors) -> f64 {
        if mirrors.is_none() {
            return 1.0;
        }
        let real = |piece: usize| {
            let place = self.path.place(piece);
            let along = |k: usize| {
                let at = f64::from(self.start[k]) + place[k] + 0.5;
                let [low, high] = mirrors.lines[k];
                let past =
                    low.map_or(-1.0, |l| f64::from(l) - at).max(high.map_or(-1.0, |h| at - f64::from(h)));
                match past {
                    past if past > 1e-9 => 0.0,
                    past if past > -1e-9 => 0.5,
                    _ => 1.0,
                }
            };
            along(0) * along(1) * along(2)
        };
        0.5 * self.pieces.map(real).iter().sum::<f64>()
    }

    /// What its first or its other end is, of a body of so many axes.
    pub(in crate::model) fn end(&self, side: usize, axes: usize) -> End {
        let cell = self.cell(self.pieces[side] - side);
        if self.has_points()[side] {
            return End::Point(cell);
        }
        let place = self.path.place(self.pieces[side]);
        let half = |k: usize| if k < axes { 0.5 } else { 0.0 };
        End::Border([0, 1, 2].map(|k| f64::from(self.start[k]) + place[k] + half(k)), cell)
    }

    /// How both of its ends move; none where the body is too thin to tell.
    pub(super) fn ends<const M: usize>(&self, nodes: &Nodes<M>) -> Option<[Place; 2]> {
        let number = |cell: Cell| nodes.cells.number(cell);
        let end = |side: usize| -> Option<Place> {
            match self.end(side, nodes.cells.axes()) {
                End::Point(cell) => Some(vec![(number(cell)?, 1.0)]),
                End::Border(at, cell) => nodes
                    .place(at, cell)?
                    .into_iter()
                    .map(|(cell, share)| Some((number(cell)?, share)))
                    .collect(),
            }
        };
        Some([end(0)?, end(1)?])
    }

    /// What tells it from the other runs of its path: its first piece, and behind the last one.
    pub(in crate::model) fn pieces(&self) -> [usize; 2] {
        self.pieces
    }

    /// How it turns on the mean, where that is not with both of its ends alike. A whole bond turns by half with either of its
    /// points, and so in one stress the moments of all bonds of a point cancel. A run from a point turns by as much with that
    /// one, and by the rest with the place where the end that is missing would be, mirrored in where the run leaves the body:
    /// along straight borders every point has its halves then.
    pub(super) fn mean<const M: usize>(&self, nodes: &Nodes<M>) -> Option<Place> {
        let share = self.share();
        let (own, mirrored) = match self.has_points() {
            [true, false] => (self.start, 2.0 * share - 1.0),
            [false, true] => (self.cell(self.pieces[1] - 1), 2.0 - 2.0 * share),
            _ => return None,
        };
        let own = nodes.cells.number(own)?;
        let beside = |(step, part): (Cell, f64)| Some((nodes.cells.number(plus(self.start, step))?, part));
        let rest: Place = match share > 0.5 {
            true => around(self.path.at(mirrored)).filter_map(beside).collect(),
            false => Vec::new(),
        };
        let whole: f64 = rest.iter().map(|r| r.1).sum();
        if whole == 0.0 {
            return Some(vec![(own, 1.0)]);
        }
        let rest = rest.into_iter().map(|(point, part)| (point, part / whole * (share - 0.5) / share));
        Some(std::iter::once((own, 0.5 / share)).chain(rest).collect())
    }
}
