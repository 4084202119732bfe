//! Terms of the energy and the matrix they are assembled into. Nothing here knows a model.

mod block_matrix;
mod block_rows;
mod bonds;
mod families;
mod grid_bonds;
mod grid_families;
mod history_bonds;
mod lattice_bonds;
mod noded_bonds;
mod parts;
mod placed_bonds;
pub(crate) mod planes;
mod shared_families;
mod springs;
mod term;
mod twofold;
mod wide_families;

pub use block_matrix::BlockMatrix;
pub use block_rows::BlockRows;
pub use bonds::{Bond, Bonds};
pub use families::{Families, Family};
pub use grid_bonds::{Between, Exception, GridBonds, Offset, Tables};
pub use grid_families::{FamilyRows, GridFamilies, GridFamily};
pub use history_bonds::{Answer, BondAnswers, EndedBond, HistoryBond, HistoryBonds, Kinematics};
pub use lattice_bonds::{Lattice, LatticeBonds, Override, Weights};
pub use noded_bonds::{BondPoints, NodedBonds, NodedBondsBuilder, NodedKind};
pub use parts::{ConnectedParts, NumberedParts};
pub use placed_bonds::{Place, PlacedBond, PlacedBonds};
pub use shared_families::{SharedFamilies, SharedKind};
pub use springs::{Spring, Springs};
pub use term::{Share, Survey, TakeForces, Term};
pub use twofold::Twofold;
pub use wide_families::{WideFamilies, WideMember};
