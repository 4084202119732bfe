//! Peridynamic Mindlin-Reissner plates in bending: deflection and two rotations per point, static and linear.
//!
//! A bond of length ξ and direction n between points i and j has the two measures of a Timoshenko beam,
//!
//! ```text
//! κ_b = n·(φ_j − φ_i)/ξ          γ_b = (w_j − w_i)/ξ − n·(φ_i + φ_j)/2
//! ```
//!
//! and the energy `½ h² f (a κ_b² + s γ_b²)` with the spacing h and the part f of it that lies in the body. This is the plate of
//! Diyaroglu, Oterkus, Oterkus and Madenci, International Journal of Solids and Structures 69-70 (2015) 152-168, with other
//! moduli, because theirs are bound to ν = 1/3, do not tend to those of the plate with the spacing, and lock:
//!
//! * bending: the bonds have what trace and deviator of the curvature have in common, `Σ a n⊗n⊗n⊗n` with `Σ a = 4β`,
//!   `β = min((1 − ν) D, (1 + ν) D/2)`; triangles of constant curvature have the rest, which is positive for all −1 < ν < 1/2;
//! * shear: `s = ω/(1/(2S) + ξ²/(32D))`. A bond sees `γ_b = n·γ − ξ² (n·∇)²(φ·n)/12`, which bonds of different directions cannot
//!   all make zero: with `s = 2Sω` a thin plate locks. In the law as corrected their penalty does not grow with S. Their weights ω
//!   are those for which a linear moment is in equilibrium with its constant shear force.
//!
//! Points lie on the edges, and a body is a union of square cells. A bond that leaves the body goes on inside it in pieces, with
//! the law of their own length, and half of a bond along an edge is in the body: the lengths of all bonds add up to the area, so
//! that every uniform curvature is exact, at edges and corners as well, and a clamped or free edge needs no points beyond it.
//!
//! Cells may differ in their sections: see `part`.
//!
//! Signs: w and pressure are positive alike, along z; `φ = ∇w` where shear is rigid; `M = D [(1 − ν) κ + ν tr(κ) I]` with
//! `κ = sym ∇φ`; `V = S (∇w − φ)`; `div M + V = 0`, `div V + q = 0`.

mod bed;
mod bond;
mod breaking;
mod coarser;
mod cover;
mod curvature;
mod curvature_term;
mod error;
mod free;
mod load;
mod model;
mod nodes;
mod parameters;
mod part;
mod recover;
mod sections;
#[cfg(test)]
mod tests;
mod weights;

pub use bed::Bed;
pub use bond::PlateBond;
pub use breaking::{CriticalCurvature, CriticalCurvatures, CriticalShear};
pub use coarser::PlateTransfer;
pub use error::PlateError;
pub use free::FreeCurvature;
pub use model::PlateBending;
pub use nodes::{EdgeSegment, PlateNodes};
pub use parameters::{PlateParameters, PlateSection, ShearLaw};
pub use recover::PlateFields;
pub use sections::CellSections;

/// Component of the deflection along z.
pub const W: usize = 0;
/// Component of the rotation that is ∂w/∂x where shear is rigid.
pub const PHI_X: usize = 1;
/// Component of the rotation that is ∂w/∂y where shear is rigid.
pub const PHI_Y: usize = 2;
