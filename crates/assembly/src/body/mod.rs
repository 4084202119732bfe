//! Bodies in the plane and what is found on them, before any model.

mod lattice;
mod transfer;

pub use lattice::{Cell, Run, SquareLattice};
pub use transfer::Transfer;
