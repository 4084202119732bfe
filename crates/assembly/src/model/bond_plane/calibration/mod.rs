//! Stiffness of the bonds of a lattice.

pub(super) mod matched;
pub(super) mod overlap;
pub(super) mod published;
