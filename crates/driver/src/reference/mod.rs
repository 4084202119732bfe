//! Closed-form solutions that a case may name in its `checks`: what the answer is compared with, on paper.
//!
//! All of them are about one uniform straight Timoshenko beam of length L with bending stiffness B = EI and
//! shear stiffness S = kappa G A, its axis from x = 0 to x = L:
//!
//! ```text
//! M = B phi'      V = S (w' - phi)      V' + q = 0      M' + V + c = 0
//! ```
//!
//! w is the deflection, phi the rotation of the section (phi = w' where shear is rigid), q the load per
//! length along +w, c the moment per length along +phi. At x = L an applied force is V(L) and an applied
//! moment M(L); at x = 0 they are -V(0) and -M(0). An upward load on a simply supported beam thus gives a
//! negative M. A Winkler foundation of stiffness k_f per length adds -k_f w to q.
//!
//! Where V jumps (under a point force, over an interior support) a solution gives the value at the left of
//! the point. Every formula is written so that its rounding error is a few units in the last place of the
//! largest value.
//!
//! A new reference is one file, which defines `ENTRY`, and one line below. It does not read cases, sample
//! grids or compare numbers: the driver fills [`Facts`] and uses the [`Solution`].

mod facts;
mod foundation;
mod questions;
mod solution;
#[cfg(test)]
mod tests;

pub use facts::{BondClass, End, Facts, Load};
pub use solution::{Displacements, Field, Reference, Solution, State};
use solution::{FOUNDATION_BEAM, PUBLISHED_BEAM, TIMOSHENKO_BEAM};

peristat_assembly::register! {
    /// Every reference a case may name, in the order of `peristat list`.
    Reference:
    cantilever_tip_force,
    cantilever_end_moment,
    cantilever_uniform,
    cantilever_uniform_moment,
    simply_supported_uniform,
    simply_supported_mid_force,
    simply_supported_uniform_moment,
    simply_supported_sine,
    simply_supported_sine_discrete,
    simply_supported_sine_nonlocal,
    clamped_clamped_uniform,
    clamped_clamped_mid_force,
    clamped_simply_supported_uniform,
    clamped_guided_uniform,
    clamped_guided_tip_force,
    two_span_uniform,
    simply_supported_sine_foundation,
    free_free_foundation_mid_force,
}

/// The reference of this name, if there is one.
#[must_use]
pub fn find(name: &str) -> Option<&'static Reference> {
    TABLE.iter().find(|reference| reference.name == name)
}
