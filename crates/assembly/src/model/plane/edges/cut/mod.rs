//! Edges that run between the points as they please: slanted, round, or along rows.
//!
//! The triangles of the blocks between four points tile the plane, once by either diagonal of the blocks. One of which the part
//! v lies in the body has the energy `½ Eᵀ (v/4) C E` per volume of a block, E the strain that its corners make. Bonds that pass
//! whole triangles alone take all of that, or a share by direction; what they leave, nothing inside and all where the border
//! cuts, stays with the triangle. No part is less than zero, every uniform strain has the energy of the material in the true
//! area, and since displacements are continuous and linear in every triangle, the forces of a uniform stress are its tractions on
//! the true border.
//!
//! Corners beyond the border move as the points inside do, continued quadratically. In bodies that break, triangles are taken
//! apart into springs by the directions of bonds.

mod blocks;
mod corners;
mod fit;
mod members;
mod missing;
mod pieces;
mod section;
mod shares;
mod sides;
mod springs;
mod strains;

use super::super::Mirrors;
use super::super::bond::PlaneBond;
use super::super::geometry;
use super::super::mixture::Mixture;
use super::super::near::{at, near_points};
use super::super::neighbourhood::Neighbourhood;
use super::overlay::is_cut;
use super::{By, Completion};
use crate::body::{Cell, SquareLattice, minus, plus};
use crate::bonds::{Mat, block};
use crate::stiffness::{Exception, WideFamilies};
use blocks::{Blocks, CORNERS};
use corners::{Corners, Cracks};
use members::{corner_shares, corners_of, is_divided, members};
use missing::Missing;
use springs::springs;
use std::borrow::Cow;
use std::collections::{BTreeSet, HashMap, HashSet};
use std::sync::Arc;

pub(in super::super::super) use section::Section;
pub(in super::super) use shares::cut_shares;
pub(in super::super::super) use strains::Strains;

/// Part of what a point inside has of triangles that one must have at least.
const LEAST: f64 = 1e-4;

/// Whether all that lies in the body can be completed so: no sides are joined, every point has its part of it, and corners
/// beyond the border can be determined, none of them by both sides of a slot.
pub(super) fn can_complete(lattice: &SquareLattice, mirrors: &Mirrors) -> bool {
    if lattice.blocks().is_empty() || mirrors.joined != [false; 3] {
        return false;
    }
    let corners = Corners::new(Blocks::new(lattice, mirrors), None);
    let blocks = &corners.blocks;
    let near: BTreeSet<Cell> = near_blocks(lattice, 0);
    let mut own = HashMap::<Cell, f64>::new();
    for &at in &near {
        let parts = blocks.parts(at);
        for (k, corner) in CORNERS.iter().enumerate() {
            let cell = plus(at, *corner);
            if parts != [0.0; 4] && corners.corner(cell, cell).is_none() {
                return false;
            }
            let all: f64 = (0..4).filter(|&t| t != 3 - k).map(|t| parts[t]).sum();
            *own.entry(cell).or_default() += all / 12.0;
        }
    }
    if sides::are_bridged(blocks, near.iter().copied()) {
        return false;
    }
    let is_seen = |cell: &Cell| CORNERS.iter().all(|c| near.contains(&minus(*cell, *c)));
    // Images beyond an axis have nothing of the body.
    let is_real = |cell: &Cell| !mirrors.revolved || mirrors.is_real(*cell);
    let is_own = |cell: &Cell| lattice.number(*cell).is_some() && is_real(cell) && is_seen(cell);
    own.iter().filter(|(cell, _)| is_own(cell)).all(|(_, part)| *part > LEAST)
}

/// Blocks within some rows and columns of those that a border can cut.
fn near_blocks(lattice: &SquareLattice, reach: i32) -> BTreeSet<Cell> {
    let around = |cell: Cell, low: i32, high: i32| {
        (low..=high).flat_map(move |j| (low..=high).map(move |i| plus(cell, [i, j, 0])))
    };
    let listed = lattice.blocks().iter().flat_map(|b| around(b.0, -reach, reach));
    let near = near_points(lattice, 1).into_iter().map(|point| lattice.cell(point));
    listed.chain(near.flat_map(|cell| around(cell, -1 - reach, reach))).collect()
}

/// Builds what completes the edges: triangles or, in bodies that break, springs.
pub(super) fn completed<const D: usize, const M: usize, const S: usize, B: PlaneBond<D, M, S>>(
    (lattice, mirrors): (&SquareLattice, &Mirrors),
    (neighbourhood, bond): (&Neighbourhood<M>, &B),
    (cuts, mixture): (&HashSet<(usize, usize)>, Option<&Mixture>),
    breaks: bool,
) -> Completion<D, M, S> {
    let corners = beside_cracks(lattice, mirrors, neighbourhood, Cow::Borrowed(cuts));
    let missing = Missing::new(&corners.blocks, neighbourhood);
    let near = near_blocks(lattice, neighbourhood.reach());
    let left = near.iter().flat_map(|&at| left_to(&corners, &missing, at));
    let (by, lost) = match breaks {
        true => springs(&corners, (neighbourhood, bond), (&missing, mixture), left),
        false => triangles(&corners, (neighbourhood, bond), (&missing, mixture), left),
    };
    let mut gaps = BTreeSet::new();
    for &at in &near {
        missing.for_each_gap(at, &mut |k, from, to| {
            if let (Some(lower), Some(_)) = (lattice.number(from), lattice.number(to)) {
                gaps.insert((k, lower));
            }
        });
    }
    let gaps: Vec<Exception> =
        gaps.into_iter().map(|(offset, lower)| Exception { offset, lower, factor: 0.0 }).collect();
    let ends = gaps.iter().flat_map(|gap| ends(lattice, neighbourhood, gap));
    let mut lacking: Vec<usize> =
        near_points(lattice, neighbourhood.reach()).into_iter().chain(ends).collect();
    lacking.sort_unstable();
    lacking.dedup();
    lacking.retain(|&point| mirrors.is_none() || mirrors.is_real(lattice.cell(point)));
    let strains = Some(Box::new(Strains::new(&corners, lacking.into_iter(), mixture)));
    Completion { by, gaps, lost, strains, lacks: Vec::new() }
}

/// What bonds leave to a triangle.
struct Left {
    block: Cell,
    triangle: usize,
    /// Part of the bonds of every path, as it counts beside lines of symmetry.
    shares: Vec<f64>,
}

/// What bonds leave to the triangles of a block that no crack divides.
fn left_to(corners: &Corners, missing: &Missing, block: Cell) -> Vec<Left> {
    let (parts, counted) = (corners.blocks.parts(block), corners.blocks.counted(block));
    if counted == 0.0 {
        return Vec::new();
    }
    let of = |triangle: usize| {
        let mut shares = missing.of(block, triangle, parts[triangle]);
        shares.iter_mut().for_each(|share| *share *= counted);
        let is_left = shares.iter().any(|share| *share != 0.0) && !is_divided(corners, block, triangle);
        is_left.then_some(Left { block, triangle, shares })
    };
    (0..4).filter_map(of).collect()
}

/// What bonds leave to the triangles that complete a body, in the order of these: parts of one bond per offset that has bonds.
pub(in super::super) fn left_to_triangles<const M: usize>(
    (lattice, mirrors): (&SquareLattice, &Mirrors),
    neighbourhood: &Neighbourhood<M>,
    cuts: &HashSet<(usize, usize)>,
) -> Vec<Vec<f64>> {
    let corners = beside_cracks(lattice, mirrors, neighbourhood, Cow::Borrowed(cuts));
    let missing = Missing::new(&corners.blocks, neighbourhood);
    let near = near_blocks(lattice, neighbourhood.reach());
    let left = near.iter().flat_map(|&at| left_to(&corners, &missing, at));
    let is_told = |left: &Left| corner_shares(&corners, corners_of(left.block, left.triangle)).is_some();
    left.filter(is_told).map(|left| left.shares).collect()
}

/// Triangles with all that is left to them, and the number of those whose corners cannot be determined.
fn triangles<const D: usize, const M: usize, const S: usize, B: PlaneBond<D, M, S>>(
    corners: &Corners,
    (neighbourhood, bond): (&Neighbourhood<M>, &B),
    (missing, mixture): (&Missing, Option<&Mixture>),
    left: impl Iterator<Item = Left>,
) -> (By<D, M, S>, usize) {
    let lattice = corners.blocks.lattice;
    let of_base =
        |(k, _): &(usize, _)| modulus(lattice, bond, neighbourhood.offsets[*k], &neighbourhood.weights[*k]);
    let moduli: Vec<Mat<S, S>> = missing.paths.iter().map(of_base).collect();
    let (mut families, mut lost) = (WideFamilies::new(lattice.points()), 0);
    for Left { block, triangle, shares } in left {
        let mut own = [[0.0; S]; S];
        for ((share, of_base), (k, _)) in shares.iter().zip(&moduli).zip(&missing.paths) {
            let mixed = mixture.map(|mixture| {
                let (cells, step) = (corners_of(block, triangle), neighbourhood.offsets[*k]);
                let of = |table| *neighbourhood.weights_of(table, *k);
                modulus(lattice, bond, step, &weights_at(corners, mixture, (cells, step), of))
            });
            let modulus = mixed.as_ref().unwrap_or(of_base);
            (0..S).for_each(|r| (0..S).for_each(|c| own[r][c] += share * modulus[r][c]));
        }
        match members(corners, bond, block, triangle) {
            Some((members, common)) => families.push(&members, common, own),
            None => lost += 1,
        }
    }
    (By::Triangles(Arc::new(families)), lost)
}

/// The weights that bonds of an offset have in a triangle, of those in the tables of a mixture.
fn weights_at<const M: usize>(
    corners: &Corners,
    mixture: &Mixture,
    (cells, offset): ([Cell; 3], Cell),
    of_table: impl Fn(usize) -> [f64; M],
) -> [f64; M] {
    let [x, y, _] = offset.map(f64::from);
    mixture.of_triangle((corners.blocks.lattice, corners.blocks.mirrors), cells, [x, y], of_table)
}

/// How corners of triangles move beside some cracks.
fn beside_cracks<'a, const M: usize>(
    lattice: &'a SquareLattice,
    mirrors: &'a Mirrors,
    neighbourhood: &'a Neighbourhood<M>,
    cuts: Cow<'a, HashSet<(usize, usize)>>,
) -> Corners<'a> {
    let blocks = Blocks::new(lattice, mirrors);
    if cuts.is_empty() {
        return Corners::new(blocks, None);
    }
    let ends: Vec<Cell> = cuts.iter().map(|&(_, lower)| lattice.cell(lower)).collect();
    let parted = Box::new(move |from, to| is_cut(lattice, neighbourhood, &cuts, from, to));
    Corners::new(blocks, Some(Cracks::new(parted, ends.into_iter())))
}

/// Both points of a bond between two.
fn ends<const M: usize>(
    lattice: &SquareLattice,
    neighbourhood: &Neighbourhood<M>,
    gap: &Exception,
) -> impl Iterator<Item = usize> {
    let upper = lattice.number(at(lattice.cell(gap.lower), neighbourhood.offsets[gap.offset], true));
    [Some(gap.lower), upper].into_iter().flatten()
}

/// `Uᵀ c U` of a bond of an offset with some weights, and its measures `U E` in a uniform state E.
pub(in super::super) fn modulus<const D: usize, const M: usize, const S: usize, B: PlaneBond<D, M, S>>(
    lattice: &SquareLattice,
    bond: &B,
    offset: Cell,
    weights: &[f64; M],
) -> Mat<S, S> {
    let geometry = geometry(lattice, offset);
    let (uniform, unit) = (bond.in_uniform_state(&geometry), bond.moduli(&geometry));
    block(&uniform, &std::array::from_fn(|m| weights[m] * unit[m]), &uniform)
}
