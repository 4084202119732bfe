//! One body on several processes.
//!
//! Every process reads the case, so that names, loads, supports and messages are those of the whole body, as exact as in one
//! process. Each builds the model of its own box of the lattice, widened by a halo that is deep enough for the rows of its own
//! points to be those of the whole body: what the cut spoils are rows that another process owns. Products and the finest level of
//! the multigrid cycle are shared by boxes; coarser levels, together a seventh of the points in space and a third in the plane,
//! every process has whole. The first process leads: it has the vectors of the whole body, certifies the solution with the
//! operator of the whole body, and writes the results.

mod agree;
mod boxes;
mod crew;
mod lead;
mod levels;
mod order;
mod part;
mod refuse;

pub(super) use agree::agree;
pub(super) use crew::Crew;
pub(super) use lead::begin;
pub use lead::{follow, lead};
