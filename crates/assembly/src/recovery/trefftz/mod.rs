//! Displacement and stress at any place, from displacements of points around it and from what is known of a border nearby.
//!
//! Without body forces the displacement is nearly a polynomial within a few spacings, and a polynomial that is in equilibrium
//! there (Trefftz 1926): of all of degree p, 4p + 2 are. These are fitted to the displacements of the points around a place, and
//! to the tractions or the displacements that the border near it is known to have, by least squares.

mod basis;
mod fit;
#[cfg(test)]
mod tests;

pub use basis::Basis;
pub use fit::{Known, LocalFit};
