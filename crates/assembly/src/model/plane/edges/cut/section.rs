//! What lies around points of a section: whole blocks, and parts of others with the place where each is.

use super::super::super::Mirrors;
use super::blocks::{Blocks, CORNERS};
use super::corners::Corners;
use super::members::{corner_shares, corners_of};
use crate::body::{Cell, SquareLattice, minus};
use crate::stiffness::Place;
use std::collections::BTreeSet;

/// A part of a triangle that lies in a body.
#[derive(Clone, Debug)]
pub(in super::super::super::super) struct SectionPart {
    /// Its centre, in cells from the point of cell `[0, 0]`.
    pub(in super::super::super::super) at: [f64; 2],
    /// Its area, cells; over both ways to divide a block into triangles they sum to that in the body.
    pub(in super::super::super::super) area: f64,
    /// Its area times what it counts by, in a body of revolution its radius in spacings.
    pub(in super::super::super::super) volume: f64,
    /// Points and their shares in the displacement of its centre.
    pub(in super::super::super::super) shares: Place,
}

/// What lies around some points.
#[derive(Clone, Debug)]
pub(in super::super::super::super) struct Section {
    /// Number of whole blocks around every point.
    pub(in super::super::super::super) whole: Vec<u8>,
    /// Parts of the other blocks around them.
    pub(in super::super::super::super) parts: Vec<SectionPart>,
}

impl Section {
    /// That around some cells of a body; triangles whose corners cannot be determined are left out.
    pub(in super::super::super) fn new(lattice: &SquareLattice, mirrors: &Mirrors, cells: &[Cell]) -> Self {
        let corners = Corners::new(Blocks::new(lattice, mirrors), None);
        let around = |cell: &Cell| CORNERS.map(|c| minus(*cell, c));
        let is_whole = |block: &Cell| corners.blocks.is_whole(*block);
        let count = |cell: &Cell| around(cell).iter().filter(|block| is_whole(block)).count() as u8;
        let cut: BTreeSet<Cell> = cells.iter().flat_map(around).filter(|block| !is_whole(block)).collect();
        let parts = cut.iter().flat_map(|&block| (0..4).map(move |triangle| (block, triangle)));
        let parts = parts.filter_map(|(block, triangle)| part(&corners, block, triangle)).collect();
        Self { whole: cells.iter().map(count).collect(), parts }
    }
}

/// The part of a triangle of a block that counts.
fn part(corners: &Corners, block: Cell, triangle: usize) -> Option<SectionPart> {
    let blocks = &corners.blocks;
    let area = 0.25 * blocks.counted(block) * blocks.parts(block)[triangle];
    if area == 0.0 {
        return None;
    }
    let centre = blocks.centre(block, triangle);
    let far = [0, 1].map(|k| (centre[k] - f64::from(CORNERS[triangle][k])).abs());
    let places = corner_shares(corners, corners_of(block, triangle))?;
    let of = |(place, part): (Place, f64)| place.into_iter().map(move |(point, share)| (point, part * share));
    let shares = places.into_iter().zip([1.0 - far[0] - far[1], far[0], far[1]]).flat_map(of).collect();
    let at = [0, 1].map(|k| f64::from(block[k]) + centre[k]);
    Some(SectionPart { at, area, volume: area * blocks.weight(at[0]), shares })
}
