//! How places on the border move, for what acts on them or is read there.

use super::super::super::Mirrors;
use super::super::super::neighbourhood::Neighbourhood;
use super::super::BorderShares;
use super::beside_cracks;
use super::blocks::CORNERS;
use super::corners::Shares;
use super::members::{corners_of, next_point};
use super::pieces::triangle_at;
use crate::body::SquareLattice;
use std::borrow::Cow;
use std::collections::HashSet;

/// How places on the border of a lattice move: as those of both triangles there do.
pub(in super::super::super) fn cut_shares<'a, const M: usize>(
    lattice: &'a SquareLattice,
    mirrors: &'a Mirrors,
    neighbourhood: &'a Neighbourhood<M>,
    cuts: HashSet<(usize, usize)>,
) -> BorderShares<'a> {
    let corners = beside_cracks(lattice, mirrors, neighbourhood, Cow::Owned(cuts));
    Box::new(move |[x, y, _], _| {
        let at = lattice.in_cells([x, y]).map(|x| x - 0.5);
        let mut sum: Vec<(usize, f64)> = Vec::new();
        for (cell, share) in [true, false].into_iter().flat_map(|rises| linear(at, rises)) {
            let from = if corners.blocks.has(cell) { cell } else { next_point(&corners, cell)? };
            for (cell, own) in corners.corner(cell, from)? {
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
