//! What holds for every plate.

mod bodies;
mod cloud;
mod lattice;
mod mirrors;
mod patch;
mod periodic;
mod properties;
mod prototypes;
mod softening;
