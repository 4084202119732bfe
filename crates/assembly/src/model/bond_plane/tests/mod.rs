//! What holds for every plate.

mod bodies;
mod border;
mod cloud;
mod cut;
mod implementations;
mod lattice;
mod mirrors;
mod patch;
mod periodic;
mod properties;
mod softening;
