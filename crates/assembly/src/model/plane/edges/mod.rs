//! What is done about the bonds that points near edges lack.

mod border;
mod deficit;
mod factors;
mod overlay;
mod triangle;

pub(super) use border::{BorderBonds, border_bonds, border_shares};
pub use border::{BorderShares, FARTHEST, has_border};
pub(super) use factors::{EdgeFactors, edge_factors};
pub(in super::super) use factors::{energy_factor, volume_factor};
pub(super) use overlay::{Overlay, overlay};
pub(in super::super) use triangle::strain_rows;
