//! Sides of slots: points that lie close to each other and that only a long way joins.

use super::blocks::{Blocks, CORNERS};
use super::corners::NEXT;
use crate::body::{Cell, Chains, minus, plus};
use std::collections::HashSet;

/// Cells by which a way may go around what lies between points beside a corner: ways around sharp tips do, ways around the end of a
/// slot do a few cells from it only.
const AROUND_TIP: i32 = 4;

/// Whether some corner beyond the border, of the triangles in blocks, lies between both sides of a slot: it would weld them.
pub(super) fn are_bridged(blocks: &Blocks, near: impl Iterator<Item = Cell>) -> bool {
    let cut = near.filter(|at| blocks.parts(*at) != [0.0; 4]);
    let corners: HashSet<Cell> =
        cut.flat_map(|at| CORNERS.map(|c| plus(at, c))).filter(|cell| !blocks.has(*cell)).collect();
    let has = |cell: Cell| blocks.has(cell);
    let chains = Chains { has: &has, is_open: &|_, _| true };
    corners.into_iter().any(|corner| {
        let mut beside = NEXT.iter().map(|step| plus(corner, *step)).filter(|cell| blocks.has(*cell));
        let Some(first) = beside.next() else { return false };
        beside.any(|cell| !chains.join_around(first, minus(cell, first), 2, AROUND_TIP))
    })
}

/// The points of a list that are on the side of a place, by their distances and steps from it, the next ones first: chains of cells, as
/// of bonds, join them to the place or, where it is no point, to the first one beside it. None where that are all of the first
/// `enough`.
pub(super) fn on_own_side(
    blocks: &Blocks,
    at: Cell,
    near: &[(i32, Cell)],
    enough: usize,
) -> Option<Vec<(i32, Cell)>> {
    let has = |cell: Cell| blocks.has(cell);
    let chains = Chains { has: &has, is_open: &|_, _| true };
    let mut next = [[0; 3]].into_iter().chain(NEXT).map(|step| plus(at, step));
    let start = next.find(|cell| blocks.has(*cell))?;
    let is_own = |(_, step): &&(i32, Cell)| {
        let offset = minus(plus(at, *step), start);
        offset == [0; 3] || chains.join(start, offset, 2)
    };
    let are_all = near.iter().take(enough).all(|point| is_own(&point));
    (!are_all).then(|| near.iter().filter(is_own).copied().collect())
}
