//! Bodies in the plane and what is found on them, before any model.

mod lattice;

pub use lattice::{Cell, Run, SquareLattice};
