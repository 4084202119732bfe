//! Stiffness of the bonds of a lattice.

pub(super) mod matched;
mod overlap;
mod projection;
pub(super) mod published;

pub(super) use projection::project;
