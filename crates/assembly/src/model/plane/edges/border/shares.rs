//! How places on the border move, for what acts on them or is read there.

use super::super::super::Mirrors;
use super::super::super::neighbourhood::Neighbourhood;
use super::nodes::{Cells, Nodes};
use crate::body::SquareLattice;
use crate::bonds::Point;
use std::borrow::Cow;
use std::collections::HashSet;

/// How places on the border move: from a position on a flat side of the cells, m, and its outward normal to points and
/// their shares, which sum to one; none where there is no such side, or the body is too thin to tell.
pub type BorderShares<'a> = Box<dyn Fn(Point, Point) -> Option<Vec<(usize, f64)>> + 'a>;

/// Positions are those of sides up to this part of a spacing.
const SLACK: f64 = 1e-6;

/// How places on the border of a lattice move whose bonds end on it.
pub(in crate::model) fn border_shares<'a, const M: usize>(
    lattice: &'a SquareLattice,
    mirrors: &'a Mirrors,
    neighbourhood: &'a Neighbourhood<M>,
    cuts: HashSet<(usize, usize)>,
) -> BorderShares<'a> {
    let nodes = Nodes::new(Cells { lattice, mirrors, neighbourhood, cuts: Cow::Owned(cuts) });
    Box::new(move |at, normal| {
        let axis = normal.iter().position(|n| n.abs() > 1.0 - 1e-9).filter(|_| !lattice.is_turned())?;
        let mut corner = [0, 1, 2].map(|k| (at[k] - lattice.corner()[k]) / lattice.spacing());
        if lattice.is_plane() {
            corner[2] = 0.0;
        }
        let side = corner[axis].round();
        if (corner[axis] - side).abs() > SLACK {
            return None;
        }
        corner[axis] = side;
        let mut cell = corner.map(|at| at.floor() as i32);
        cell[axis] = side as i32 - i32::from(normal[axis] > 0.0);
        let mut beyond = cell;
        beyond[axis] = 2 * side as i32 - 1 - cell[axis];
        if !nodes.cells.has(cell) || nodes.cells.has(beyond) {
            return None;
        }
        let numbered = |(cell, share)| Some((nodes.cells.number(cell)? as usize, share));
        nodes.place(corner, cell)?.into_iter().map(numbered).collect()
    })
}
