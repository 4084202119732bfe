//! What is done about the bonds that points near edges lack.

mod border;
mod cut;
mod deficit;
mod factors;
mod overlay;
mod triangle;

pub(super) use border::{BorderBonds, border_shares};
pub use border::{BorderShares, FARTHEST};
pub(super) use cut::{CutBorder, cut_shares, modulus};
pub(super) use factors::{EdgeFactors, edge_factors};
pub(in super::super) use factors::{energy_factor, volume_factor};
pub(super) use overlay::{Overlay, overlay};
pub(in super::super) use triangle::strain_rows;

use super::bond::PlaneBond;
use super::neighbourhood::Neighbourhood;
use super::{Edges, Mirrors};
use crate::body::SquareLattice;
use crate::stiffness::Exception;
use std::collections::HashSet;

/// Whether the border of a lattice can be completed by what moves with it: all cells are whole and belong to blocks of four, or
/// the parts of blocks that are in the body are known and every point has its part; bonds reach no farther than [`FARTHEST`].
pub fn has_border(lattice: &SquareLattice, mirrors: &Mirrors, reach: i32) -> bool {
    let can_end = || lattice.cut_cells().is_empty() && border::can_end(lattice, mirrors);
    reach <= FARTHEST && (can_end() || cut::can_complete(lattice, mirrors))
}

/// What completes the border of a lattice.
#[derive(Clone, Debug)]
pub(in super::super) enum Completion<const D: usize, const M: usize, const S: usize> {
    /// Nothing does; triangles may complete the points beside it.
    Points,
    /// Bonds that end on it.
    Ended(BorderBonds<D, M>),
    /// Triangles that it cuts.
    Cut(Box<CutBorder<D, S>>),
}

impl<const D: usize, const M: usize, const S: usize> Completion<D, M, S> {
    /// That of a body with some edges; `near` are the points within reach of its border.
    pub(super) fn new<B: PlaneBond<D, M, S>>(
        (lattice, mirrors): (&SquareLattice, &Mirrors),
        (hood, bond): (&Neighbourhood<M>, &B),
        edges: Edges,
        near: &[usize],
        cuts: &HashSet<(usize, usize)>,
    ) -> Self {
        match (edges, lattice.blocks()) {
            (Edges::Border, []) => {
                Self::Ended(border::border_bonds(lattice, mirrors, (hood, bond), near, cuts))
            }
            (Edges::Border, _) => Self::Cut(Box::new(cut::cut_border(lattice, mirrors, (hood, bond), cuts))),
            _ => Self::Points,
        }
    }

    /// The bonds that end on the border.
    pub(in super::super) fn ended(&self) -> Option<&BorderBonds<D, M>> {
        if let Self::Ended(border) = self { Some(border) } else { None }
    }

    /// The triangles that the border cuts.
    pub(in super::super) fn cut(&self) -> Option<&CutBorder<D, S>> {
        if let Self::Cut(cut) = self { Some(cut) } else { None }
    }

    /// Bonds between points that give way to something else.
    pub(in super::super) fn gaps(&self) -> &[Exception] {
        match self {
            Self::Points => &[],
            Self::Ended(border) => &border.gaps,
            Self::Cut(cut) => &cut.gaps,
        }
    }

    /// Number of its elements that are left out, because the body is too thin there.
    pub(super) fn lost(&self) -> Option<usize> {
        match self {
            Self::Points => None,
            Self::Ended(border) => Some(border.lost),
            Self::Cut(cut) => Some(cut.lost),
        }
    }
}
