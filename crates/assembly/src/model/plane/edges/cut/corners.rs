//! How corners of triangles move that lie outside of the body: as the points inside do, continued.

use super::blocks::{Blocks, CORNERS};
use super::fit::fit;
use super::sides::on_own_side;
use crate::body::{Cell, minus, plus};
use std::cell::RefCell;
use std::collections::{HashMap, HashSet};

/// Cells of points and their shares.
pub(super) type Shares = Vec<(Cell, f64)>;

/// A corner and, beside cracks, the point that asks.
type Asked = (Cell, Option<Cell>);

/// Points of a quadratic continuation, at least; equally far ones follow each other or none.
const POINTS: usize = 16;
/// Points that tell one at all.
const FEWEST: usize = 6;
/// Square of how far they may be from the corner, spacings.
const FARTHEST: i32 = 25;
/// How fast the weights of points fall with the square of their distance where they continue a corner. Of those tried on rings,
/// steeper ones make multigrid slower, and flatter ones are less accurate.
pub(super) const CLOSE: f64 = 0.25;
/// The same where they give the strain of a point; twice as steep or wider over three spacings is less accurate.
pub(super) const WIDE: f64 = 1.0 / 4.5;

/// Steps from a corner's point to those that it follows, at most.
const AROUND: i32 = 8;

/// Steps to next cells.
pub(super) const NEXT: [Cell; 8] =
    [[1, 0, 0], [1, 1, 0], [0, 1, 0], [-1, 1, 0], [-1, 0, 0], [-1, -1, 0], [0, -1, 0], [1, -1, 0]];

/// Cracks that run between points.
pub(super) struct Cracks<'a> {
    /// Whether one runs between two points.
    parted: Box<dyn Fn(Cell, Cell) -> bool + 'a>,
    /// Squares of cells, [`AROUND`] wide, with points that bonds over cracks have.
    squares: HashSet<Cell>,
}

impl<'a> Cracks<'a> {
    /// Cracks that cut bonds of some points.
    pub(super) fn new(
        parted: Box<dyn Fn(Cell, Cell) -> bool + 'a>,
        points: impl Iterator<Item = Cell>,
    ) -> Self {
        Self { parted, squares: points.map(Self::square).collect() }
    }

    fn square(cell: Cell) -> Cell {
        cell.map(|k| k.div_euclid(AROUND))
    }

    /// Whether a crack can run between a point and those around it.
    fn is_near(&self, cell: Cell) -> bool {
        let square = Self::square(cell);
        self.squares.contains(&square) || NEXT.iter().any(|step| self.squares.contains(&plus(square, *step)))
    }
}

/// Points on the same side of all cracks, where there are some.
type Near = Option<HashSet<Cell>>;

/// The displacement of corners of triangles.
pub(super) struct Corners<'a> {
    pub(super) blocks: Blocks<'a>,
    cracks: Option<Cracks<'a>>,
    known: RefCell<HashMap<Asked, Option<Shares>>>,
}

impl<'a> Corners<'a> {
    pub(super) fn new(blocks: Blocks<'a>, cracks: Option<Cracks<'a>>) -> Self {
        Self { blocks, cracks, known: RefCell::default() }
    }

    /// Whether a crack runs between two points.
    pub(super) fn parted(&self, from: Cell, to: Cell) -> bool {
        self.cracks.as_ref().is_some_and(|cracks| (cracks.parted)(from, to))
    }

    /// Points and their shares in the displacement of a corner of a triangle whose point, or next point, is `from`; none where
    /// the body is too thin to tell.
    pub(super) fn corner(&self, corner: Cell, from: Cell) -> Option<Shares> {
        if self.blocks.has(corner) {
            return Some(vec![(corner, 1.0)]);
        }
        let key = (corner, self.cracks.as_ref().filter(|cracks| cracks.is_near(from)).map(|_| from));
        if let Some(known) = self.known.borrow().get(&key) {
            return known.clone();
        }
        let found = self.straight(corner, from).or_else(|| self.fitted(corner, from));
        self.known.borrow_mut().insert(key, found.clone());
        found
    }

    /// The same, where a point on the other side of a crack is as one that is not there.
    pub(super) fn beside(&self, corner: Cell, from: Cell) -> Option<Shares> {
        match self.around(from) {
            Some(near) if self.blocks.has(corner) && !near.contains(&corner) => self.fitted(corner, from),
            _ => self.corner(corner, from),
        }
    }

    /// Beside a border half a spacing beyond rows and columns: linearly along them, so that a line of the border moves as the
    /// points beside it alone do.
    fn straight(&self, corner: Cell, from: Cell) -> Option<Shares> {
        let around = CORNERS.map(|c| minus(corner, c));
        if !around.iter().all(|block| self.is_aligned(*block)) {
            return None;
        }
        let near = self.around(from);
        let steps = [
            [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0]],
            [[1, 1, 0], [-1, 1, 0], [1, -1, 0], [-1, -1, 0]],
        ];
        steps.iter().find_map(|steps| {
            let found: Vec<Shares> =
                steps.iter().filter_map(|&step| self.along(corner, step, &near)).collect();
            let part = 1.0 / found.len() as f64;
            let all = found.iter().flatten().map(|&(cell, share)| (cell, part * share));
            (!found.is_empty()).then(|| all.collect())
        })
    }

    /// Linearly from the next two points along a row or a column, or from the next four across.
    fn along(&self, corner: Cell, step: Cell, near: &Near) -> Option<Shares> {
        let axis = |k: usize| match step[k] {
            0 => vec![(corner[k], 1.0)],
            s => vec![(corner[k] + s, 2.0), (corner[k] + 2 * s, -1.0)],
        };
        let rows = axis(1);
        let all =
            axis(0).into_iter().flat_map(|(i, p)| rows.iter().map(move |&(j, q)| ([i, j, corner[2]], p * q)));
        let shares: Shares = all.collect();
        shares.iter().all(|s| self.is_near(s.0, near)).then_some(shares)
    }

    /// Whether the borders in a block are half a spacing beyond its points: then these tell its parts.
    fn is_aligned(&self, block: Cell) -> bool {
        let there = CORNERS.map(|c| f64::from(u8::from(self.blocks.has(plus(block, c)))));
        let parts = self.blocks.parts(block);
        (0..4).all(|t| (parts[t] - 0.5 * there[t] - 0.25 * (there[t ^ 1] + there[t ^ 2])).abs() < 1e-6)
    }

    fn is_near(&self, cell: Cell, near: &Near) -> bool {
        self.blocks.has(cell) && near.as_ref().is_none_or(|near| near.contains(&cell))
    }

    /// The points around one that no crack divides from it: those to which next neighbours lead on ways that are about straight.
    /// None where there are no cracks.
    fn around(&self, from: Cell) -> Near {
        let cracks = self.cracks.as_ref().filter(|cracks| cracks.is_near(from))?;
        let far = |cell: Cell| (0..2).map(|k| (cell[k] - from[k]).abs()).max().unwrap_or(0);
        let (mut found, mut last) = (HashSet::from([from]), vec![from]);
        for step in 1..=AROUND {
            let next = last.iter().flat_map(|&cell| NEXT.map(|step| (cell, plus(cell, step))));
            let leads = |(cell, to): &(Cell, Cell)| {
                step <= far(*to) + 1
                    && self.blocks.has(*to)
                    && !found.contains(to)
                    && !(cracks.parted)(*cell, *to)
            };
            last = next.filter(leads).map(|(_, to)| to).collect::<HashSet<Cell>>().into_iter().collect();
            found.extend(&last);
        }
        Some(found)
    }

    /// The quadratic, or where that is not known linear, function that is nearest to the displacement of the next points.
    fn fitted(&self, corner: Cell, from: Cell) -> Option<Shares> {
        let all = self.fit(corner, from, CLOSE)?.into_iter();
        Some(all.map(|(cell, rows)| (cell, rows[0])).collect())
    }

    /// What points near a cell, and not parted from another one, have in its displacement and in the derivatives of that by the
    /// columns and rows of points.
    pub(super) fn fit(&self, at: Cell, from: Cell, decay: f64) -> Option<Vec<(Cell, [f64; 3])>> {
        let reach = f64::from(FARTHEST).sqrt() as i32;
        let steps = (-reach..=reach).flat_map(|j| (-reach..=reach).map(move |i| [i, j]));
        let seen = self.around(from);
        let mut near: Vec<(i32, Cell)> = steps
            .map(|[i, j]| (i * i + j * j, [i, j, 0]))
            .filter(|(d, step)| *d <= FARTHEST && self.is_near(plus(at, *step), &seen))
            .collect();
        near.sort_unstable();
        // Beside cracks that is done already, and a part of fewer points tells no quadratic function.
        if seen.is_none() {
            let own = on_own_side(&self.blocks, at, &near, 2 * POINTS);
            near = own.filter(|own| own.len() >= FEWEST).unwrap_or(near);
        }
        let at_least = |count: usize| {
            let last = near.get(count - 1).or(near.last())?.0;
            Some(near.partition_point(|n| n.0 <= last))
        };
        let fits = [(6, POINTS), (6, 2 * POINTS), (3, 4), (3, POINTS)];
        let rows =
            fits.into_iter().find_map(|(terms, count)| fit(&near[..at_least(count)?], terms, decay))?;
        let named = |(&(_, step), rows): (&(i32, Cell), [f64; 3])| (plus(at, step), rows);
        Some(near.iter().zip(rows).map(named).collect())
    }
}
