//! The points that move a triangle.

use super::super::super::bond::PlaneBond;
use super::super::super::geometry;
use super::blocks::CORNERS;
use super::corners::Corners;
use crate::body::{Cell, minus, plus};
use crate::bonds::Mat;
use crate::stiffness::{Place, WideMember};

/// Corners of a triangle, that with its right angle first.
pub(super) fn corners_of(at: Cell, triangle: usize) -> [Cell; 3] {
    [triangle, triangle ^ 1, triangle ^ 2].map(|k| plus(at, CORNERS[k]))
}

/// Whether a crack runs between the points of a triangle: then it resists nothing, as the bonds between them.
pub(super) fn is_divided(corners: &Corners, at: Cell, triangle: usize) -> bool {
    let cells = corners_of(at, triangle);
    let there = |cell: &Cell| corners.blocks.has(*cell);
    let inside: Vec<Cell> = cells.into_iter().filter(there).collect();
    (1..inside.len()).any(|k| inside[..k].iter().any(|b| corners.parted(inside[k], *b)))
}

/// Points that move a triangle and what a common motion of them makes; none if a corner cannot be determined.
pub(super) fn members<const D: usize, const M: usize, const S: usize, B: PlaneBond<D, M, S>>(
    corners: &Corners,
    bond: &B,
    at: Cell,
    triangle: usize,
) -> Option<(Vec<WideMember<D, S>>, Mat<S, D>)> {
    let lattice = corners.blocks.lattice;
    let cells = corners_of(at, triangle);
    let vector = |to: Cell| {
        let [x, y, _] = geometry(lattice, minus(to, cells[0])).xi;
        [x, y]
    };
    let (others, own) = bond.triangle(vector(cells[1]), vector(cells[2]));
    // What the point itself would make by its own unknowns, a third of it at every corner.
    let third = own.map(|row| row.map(|x| x / 3.0));
    let sum: Mat<S, D> = combined(&others[0], &others[1], 1.0);
    let rows =
        [combined(&third, &sum, -1.0), combined(&third, &others[0], 1.0), combined(&third, &others[1], 1.0)];
    let mut members: Vec<WideMember<D, S>> = Vec::new();
    for (shares, rows) in corner_shares(corners, cells)?.iter().zip(rows) {
        for &(point, share) in shares {
            let index = members.iter().position(|m| m.point == point).unwrap_or_else(|| {
                members.push(WideMember { point, share: 0.0, rows: [[0.0; D]; S] });
                members.len() - 1
            });
            members[index].share += share / 3.0;
            members[index].rows = combined(&members[index].rows, &rows, share);
        }
    }
    Some((members, own))
}

/// Points and their shares in the displacement of every corner of a triangle; none if one cannot be determined.
pub(super) fn corner_shares(corners: &Corners, cells: [Cell; 3]) -> Option<[Place; 3]> {
    let inside = cells.into_iter().find(|cell| corners.blocks.has(*cell));
    let from = inside.or_else(|| next_point(corners, cells[0]))?;
    let named = |(cell, share): (Cell, f64)| Some((corners.blocks.lattice.number(cell)? as u32, share));
    let of = |cell: Cell| corners.corner(cell, from)?.into_iter().map(named).collect::<Option<Place>>();
    let [a, b, c] = cells.map(of);
    Some([a?, b?, c?])
}

/// A sum of rows, the second ones times a factor.
fn combined<const D: usize, const S: usize>(a: &Mat<S, D>, b: &Mat<S, D>, factor: f64) -> Mat<S, D> {
    std::array::from_fn(|r| std::array::from_fn(|c| a[r][c] + factor * b[r][c]))
}

/// The point nearest to a cell outside.
pub(super) fn next_point(corners: &Corners, cell: Cell) -> Option<Cell> {
    let steps = (-3..=3).flat_map(|j| (-3..=3).map(move |i| [i, j, 0]));
    let there = steps.filter(|step| corners.blocks.has(plus(cell, *step)));
    Some(plus(cell, there.min_by_key(|[i, j, _]| i * i + j * j)?))
}
