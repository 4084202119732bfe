//! What is done about the bonds that points near edges lack.

mod border;
mod cut;
mod deficit;
mod factors;
mod overlay;
mod triangle;

pub(super) use border::{BorderBonds, border_bonds, border_shares};
pub use border::{BorderShares, FARTHEST};
pub(super) use cut::{CutBorder, cut_border, cut_shares, modulus};
pub(super) use factors::{EdgeFactors, edge_factors};
pub(in super::super) use factors::{energy_factor, volume_factor};
pub(super) use overlay::{Overlay, overlay};
pub(in super::super) use triangle::strain_rows;

use super::Mirrors;
use crate::body::SquareLattice;

/// Whether the border of a lattice can be completed by what moves with it: all cells are whole and belong to blocks of four, or
/// the parts of blocks that are in the body are known and every point has its part; bonds reach no farther than [`FARTHEST`].
pub fn has_border(lattice: &SquareLattice, mirrors: &Mirrors, reach: i32) -> bool {
    let can_end = || lattice.cut_cells().is_empty() && border::can_end(lattice, mirrors);
    reach <= FARTHEST && (can_end() || cut::can_complete(lattice, mirrors))
}
