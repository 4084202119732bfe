//! How places on the border move, for what acts on them or is read there.

use super::super::super::Mirrors;
use super::super::super::neighbourhood::Neighbourhood;
use super::super::BorderShares;
use super::beside_cracks;
use super::blocks::CORNERS;
use super::corners::{Corners, Shares};
use super::members::{corners_of, next_point};
use super::pieces::triangle_at;
use crate::body::{Cell, SquareLattice};
use std::borrow::Cow;
use std::collections::HashSet;

/// How places on the border of a lattice move: as those of both triangles there do.
pub(in super::super::super) fn cut_shares<'a, const M: usize>(
    lattice: &'a SquareLattice,
    mirrors: &'a Mirrors,
    neighbourhood: &'a Neighbourhood<M>,
    (cuts, has_slots): (HashSet<(usize, usize)>, bool),
) -> BorderShares<'a> {
    let corners = beside_cracks(lattice, mirrors, neighbourhood, Cow::Owned(cuts));
    Box::new(move |[x, y, _], normal| {
        let at = lattice.in_cells([x, y]).map(|x| x - 0.5);
        // The sides of a slot move with the points behind them alone.
        let behind = [0, 1].map(|k| [x, y][k] - 0.5 * lattice.spacing() * normal[k]);
        let behind = if has_slots { Some(point_in(&corners, lattice.cell_at(behind))?) } else { None };
        let mut sum: Vec<(usize, f64)> = Vec::new();
        for (cell, share) in [true, false].into_iter().flat_map(|rises| linear(at, rises)) {
            let found = match behind {
                Some(from) => corners.beside(cell, from),
                None => corners.corner(cell, point_in(&corners, cell)?),
            };
            for (cell, own) in found? {
                let point = lattice.number(cell)?;
                match sum.iter_mut().find(|s| s.0 == point) {
                    Some(known) => known.1 += 0.5 * share * own,
                    None => sum.push((point, 0.5 * share * own)),
                }
            }
        }
        Some(sum)
    })
}

/// The cell of a point, or the next one that has one.
fn point_in(corners: &Corners, cell: Cell) -> Option<Cell> {
    if corners.blocks.has(cell) { Some(cell) } else { next_point(corners, cell) }
}

/// The corners of the triangle of a place that one of the diagonals makes, and their shares in its displacement, which are not
/// zero. Positions are in spacings from the point of cell `[0, 0]`.
fn linear(at: [f64; 2], rises: bool) -> Shares {
    let (block, triangle) = triangle_at(at, rises);
    let own = CORNERS[triangle];
    // How far the place is from the corner with the right angle, along its sides.
    let far = [0, 1].map(|k| (at[k] - f64::from(block[k] + own[k])).abs());
    let shares = [1.0 - far[0] - far[1], far[0], far[1]];
    corners_of(block, triangle).into_iter().zip(shares).filter(|s| s.1 != 0.0).collect()
}
