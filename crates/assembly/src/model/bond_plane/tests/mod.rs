//! What holds for every plate.

pub(in crate::model) mod bodies;
mod border;
mod cloud;
mod cut;
mod implementations;
mod isotropic;
mod lattice;
mod mirrors;
mod patch;
mod periodic;
mod properties;
mod slots;
mod softening;
