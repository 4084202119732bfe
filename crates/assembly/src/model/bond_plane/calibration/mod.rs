//! Stiffness of the bonds of a lattice.

pub(super) mod matched;
mod overlap;
pub(super) mod published;
