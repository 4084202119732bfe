//! What is done about the bonds that points near edges lack.

mod border;
mod cut;
mod deficit;
mod factors;
mod overlay;
mod triangle;

pub(in super::super) use border::Path;
pub(in crate::model) use border::border_shares;
pub(in super::super) use border::{BorderBonds, Cells, End, Nodes, Run, around, can_end, for_each_part};
pub use border::{BorderShares, FARTHEST};
pub(in super::super) use cut::{Section, Strains};
pub(super) use cut::{cut_shares, left_to_triangles, modulus};
pub(super) use factors::{EdgeFactors, edge_factors};
pub(in super::super) use factors::{energy_factor, volume_factor};
pub(in super::super) use overlay::is_cut;
pub(super) use overlay::{Overlay, overlay, triangles_of};
pub(in super::super) use triangle::strain_rows;

use super::bond::PlaneBond;
use super::mixture::Mixture;
use super::neighbourhood::Neighbourhood;
use super::{Edges, Mirrors};
use crate::body::SquareLattice;
use crate::stiffness::{Exception, WideFamilies};
use std::collections::HashSet;
use std::sync::Arc;

/// Whether the border of a lattice can be completed by what moves with it: all cells are whole and belong to blocks of four, or
/// the parts of blocks that are in the body are known and every point has its part; bonds reach no farther than [`FARTHEST`].
pub fn has_border(lattice: &SquareLattice, mirrors: &Mirrors, reach: i32) -> bool {
    let can_end = || lattice.cut_cells().is_empty() && border::can_end(lattice, mirrors);
    reach <= FARTHEST && (can_end() || cut::can_complete(lattice, mirrors))
}

/// What completes the border of a lattice.
#[derive(Clone, Debug)]
pub(in super::super) struct Completion<const D: usize, const M: usize, const S: usize> {
    pub(in super::super) by: By<D, M, S>,
    /// Bonds between points that give way to it.
    pub(in super::super) gaps: Vec<Exception>,
    /// Number of its elements that are left out, because the body is too thin there to tell how they move.
    pub(in super::super) lost: usize,
    /// Strains of the points that lack bonds, where the border cuts cells.
    pub(in super::super) strains: Option<Box<Strains>>,
    /// What bonds of several materials that end on the border leave to points: these, offsets, and weights.
    pub(in super::super) lacks: Vec<(usize, usize, [f64; M])>,
}

/// What takes the place of bonds that a border cuts off.
#[derive(Clone, Debug)]
pub(in super::super) enum By<const D: usize, const M: usize, const S: usize> {
    /// Nothing on the border; triangles may complete the points beside it.
    Points,
    /// Bonds that end on the border, or springs in the triangles that it cuts.
    Bonds(BorderBonds<D, M>),
    /// Triangles that it cuts.
    Triangles(Arc<WideFamilies<D, S>>),
}

impl<const D: usize, const M: usize, const S: usize> Completion<D, M, S> {
    /// That of a body with some edges; `near` are the points within reach of its border.
    pub(super) fn new<B: PlaneBond<D, M, S>>(
        body: (&SquareLattice, &Mirrors),
        bonds: (&Neighbourhood<M>, &B),
        edges: Edges,
        near: &[usize],
        (cuts, mixture): (&HashSet<(usize, usize)>, Option<&Mixture>),
    ) -> Self {
        match (edges, body.0.blocks()) {
            (Edges::Border, []) => border::completed(body, bonds, near, (cuts, mixture)),
            (Edges::Border, _) => cut::completed(body, bonds, (cuts, mixture), false),
            _ => Self { by: By::Points, gaps: Vec::new(), lost: 0, strains: None, lacks: Vec::new() },
        }
    }

    /// The same where bodies break: what the border cuts is taken apart into springs by the directions of bonds.
    pub(super) fn breaking<B: PlaneBond<D, M, S>>(
        body: (&SquareLattice, &Mirrors),
        bonds: (&Neighbourhood<M>, &B),
        known: (&HashSet<(usize, usize)>, Option<&Mixture>),
    ) -> Self {
        cut::completed(body, bonds, known, true)
    }

    /// Whether the border cuts cells, and the body ends on it.
    pub(in super::super) fn is_cut(&self) -> bool {
        self.strains.is_some()
    }

    /// Whether nothing on the border takes the place of bonds.
    pub(in super::super) fn is_none(&self) -> bool {
        matches!(self.by, By::Points)
    }

    /// The bonds that end on the border.
    pub(in super::super) fn bonds(&self) -> Option<&BorderBonds<D, M>> {
        if let By::Bonds(bonds) = &self.by { Some(bonds) } else { None }
    }
}
