//! Beam clamped at both ends with a force F at mid-span.
//!
//! V = F/2 up to L/2, and phi = 0 there by symmetry gives M(0) = F L / 8. For x <= L/2, and mirrored behind
//! it (w and M even, phi and V odd about L/2; at L/2 itself V is the left value):
//!
//! ```text
//! w = F x² (3L - 4x) / 48B + F x / 2S      phi = F x (L - 2x) / 8B      M = F (L - 4x) / 8      V = F / 2
//! ```

use super::{End, Facts, Reference, Solution, State, TIMOSHENKO_BEAM};

pub(super) const ENTRY: Reference = Reference {
    name: "clamped_clamped_mid_force",
    about: "beam clamped at both ends, force at mid-span",
    source: TIMOSHENKO_BEAM,
    build,
};

fn build(facts: &Facts) -> Result<Solution, String> {
    facts.ends_are(End::Clamped, End::Clamped)?;
    let (l, b, s) = facts.symbols();
    let force = facts.only_force_at(l / 2.0)?;
    let at = move |x: f64| {
        let (y, side) = if x <= l / 2.0 { (x, 1.0) } else { (l - x, -1.0) };
        State {
            w: force * y * (y * (3.0 * l - 4.0 * y) / (48.0 * b) + 1.0 / (2.0 * s)),
            phi: side * force * y * (l - 2.0 * y) / (8.0 * b),
            moment: force * (l - 4.0 * y) / 8.0,
            shear: side * force / 2.0,
        }
    };
    Ok(Solution::local(force * at(l / 2.0).w / 2.0, at))
}
