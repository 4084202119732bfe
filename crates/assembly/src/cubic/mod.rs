//! Solids on cubic lattices with one stencil, in 32 bits: what stands in for their stiffness in a multigrid cycle.
//!
//! Cells of a box, with a rim of cells at rest around it, have the same bonds everywhere, so that a product is the same few
//! numbers at every point:
//!
//! `(Â v)_p = D̂_p v_p − Σ_d K_d (v_{p+d} + v_{p−d})`, `K_d = k_d n nᵀ`
//!
//! over half of the offsets d. Cells that are not of the body rest, too. What bodies differ in is D̂, the blocks of the points
//! beside their faces. Points that lack bonds there are too soft; instead of what completes their families in the model, their
//! bonds are stiffer: those of points p and q by `s_p s_q`, which is a scaling of the unknowns, `v = s u`, and leaves the stencil
//! alone. Only the finest level has the bonds of the model on its border, where there are such. A spacing twice as large doubles all stiffnesses.
//!
//! A preconditioner needs neither more digits nor the exact operator: conjugate gradients correct both.

mod across;
mod border;
mod border_rows;
mod build;
mod cells;
mod coarsest;
mod finish;
mod followers;
mod gaps;
mod grid;
mod kernel;
mod level;
mod levels;
mod stencil;
#[cfg(test)]
mod tests;
mod transfer;

pub use coarsest::CoarsestMatrix;
pub use level::CubicLevel;
pub use levels::{CubicFaces, CubicLevels, CubicSolid, Follower};
pub use stencil::Stencil;

/// Numbers of a vector: three component planes.
type Planes<'a> = [&'a [f32]; 3];
