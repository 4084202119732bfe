//! Ordinary state-based bodies in the plane and of revolution, static and linear, for any Poisson ratio.
//!
//! The points are a section, with unknowns u_x and u_y; of a body of revolution x is the radius, y the axis. A point k has
//! a family of neighbours j within the horizon, at ξ with the direction n and the length |ξ|, with elongations
//! `e = n·(u_j − u_k)` and weights w. With `q = Σ w |ξ|²` it has the section's dilatation `ϑ = (2/q) Σ w |ξ| e`, the hoop
//! strain `h = u_x/x` of a body of revolution, and the energy density
//!
//! `W = ½(λ−μ) ϑ² + λ ϑ h + ½(λ+2μ) h² + (4μ/q) Σ w e²`,
//!
//! which is that of the classical body for every uniform strain if `⟨cos⁴⟩ = 3/8` and `⟨cos² sin²⟩ = 1/8` in every family
//! (`moments.rs`). It is never negative while no weight is, and while q stays that of the intact family. After Lu, Oterkus
//! and Oterkus, Procedia Structural Integrity 28 (2020) 1559–1571, whose rings count by `2π r A` ([`Measure`]).
//!
//! Where `λ = μ`, as for ν = 1/3 in plane stress, no point feels more than its bonds and no family is made.
//!
//! Not here: contact, torsion, finite rotations.

mod axis_table;
mod blocks;
mod body;
mod bordered;
mod breaking;
mod error;
mod fields;
mod ghosts;
mod materials;
mod model;
mod moments;
mod parameters;
mod plane;
mod sets;
mod term;
#[cfg(test)]
mod tests;
mod weights;
mod work;

pub use bordered::BorderedState;
pub use error::StateError;
pub use materials::StateMaterials;
pub use model::StateBased;
pub use parameters::{Axis, Dilatation, Geometry, Measure, StateEdges, StateParameters};
