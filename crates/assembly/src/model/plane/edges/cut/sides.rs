//! Sides of slots: points that lie close to each other and that only a long way joins.

use super::blocks::{Blocks, CORNERS};
use crate::body::{Cell, minus, plus};
use std::collections::{HashMap, HashSet};

/// Steps by which a way between two points may be longer than the straight one, as that of a bond may: ways around the end of a slot
/// are longer, and ways around corners and small holes are not.
pub(super) const DETOUR: i32 = 1;
/// The same of ways around a slot that a corner lies in: those around a sharp tip are no slots.
const AROUND_TIP: i32 = 4;
/// Rows and columns around a place that are looked at: as far as what it follows, and around that.
const AROUND: i32 = 9;
/// Steps to next cells.
pub(super) const NEXT: [Cell; 8] =
    [[1, 0, 0], [1, 1, 0], [0, 1, 0], [-1, 1, 0], [-1, 0, 0], [-1, -1, 0], [0, -1, 0], [1, -1, 0]];

/// Whether some corner beyond the border, of the triangles in blocks, lies between both sides of a slot: it would weld them.
pub(super) fn are_bridged(blocks: &Blocks, near: impl Iterator<Item = Cell>) -> bool {
    let cut = near.filter(|at| blocks.parts(*at) != [0.0; 4]);
    let corners: HashSet<Cell> =
        cut.flat_map(|at| CORNERS.map(|c| plus(at, c))).filter(|cell| !blocks.has(*cell)).collect();
    corners.into_iter().any(|corner| {
        let mut beside = NEXT.iter().map(|step| plus(corner, *step)).filter(|cell| blocks.has(*cell));
        let Some(first) = beside.next() else { return false };
        let unseen: Vec<Cell> = beside.filter(|cell| !is_seen(blocks, first, *cell)).collect();
        !unseen.is_empty() && {
            let ways = Ways::new(blocks, first, corner);
            unseen.iter().any(|cell| !ways.lead_to(*cell, AROUND_TIP))
        }
    })
}

/// The point beside a place from which its side is seen: itself, if it is one.
pub(super) fn beside(blocks: &Blocks, at: Cell) -> Option<Cell> {
    let mut next = NEXT.iter().map(|step| plus(at, *step));
    if blocks.has(at) { Some(at) } else { next.find(|cell| blocks.has(*cell)) }
}

/// Whether all cells along the straight way between two points are there.
pub(super) fn is_seen(blocks: &Blocks, from: Cell, to: Cell) -> bool {
    let d = minus(to, from);
    let far = d[0].abs().max(d[1].abs());
    (1..far).all(|k| {
        let along = |axis: usize| (f64::from(d[axis] * k) / f64::from(far)).round() as i32;
        blocks.has(plus(from, [along(0), along(1), 0]))
    })
}

/// Ways along next points from one of them.
pub(super) struct Ways {
    from: Cell,
    /// Steps to points around a place.
    steps: HashMap<Cell, i32>,
}

impl Ways {
    pub(super) fn new(blocks: &Blocks, from: Cell, around: Cell) -> Self {
        let is_around = |cell: &Cell| (0..2).all(|k| (cell[k] - around[k]).abs() <= AROUND);
        let (mut steps, mut last) = (HashMap::from([(from, 0)]), vec![from]);
        for count in 1..=2 * AROUND {
            let mut next = Vec::new();
            for cell in last.iter().flat_map(|cell| NEXT.map(|step| plus(*cell, step))) {
                if is_around(&cell) && !steps.contains_key(&cell) && blocks.has(cell) {
                    steps.insert(cell, count);
                    next.push(cell);
                }
            }
            last = next;
        }
        Self { from, steps }
    }

    /// Whether a way leads to a point that is no longer than the straight one and a detour.
    pub(super) fn lead_to(&self, to: Cell, detour: i32) -> bool {
        let d = minus(to, self.from);
        let straight = d[0].abs().max(d[1].abs());
        self.steps.get(&to).is_some_and(|steps| *steps <= straight + detour)
    }
}
