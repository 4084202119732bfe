//! Beam clamped at x = 0 and guided at x = L (phi = 0, free to move) with a force F at the guided end: the
//! column of a sway frame, 12 B / L³ stiff where shear is rigid.
//!
//! V = F, and phi = 0 at both ends gives M(0) = F L / 2:
//!
//! ```text
//! w = F x² (3L - 2x) / 12B + F x / S      phi = F x (L - x) / 2B      M = F (L - 2x) / 2      V = F
//! ```

use super::{End, Facts, Reference, Solution, State, TIMOSHENKO_BEAM};

pub(super) const ENTRY: Reference = Reference {
    name: "clamped_guided_tip_force",
    about: "beam clamped at x = 0 and guided at x = L, force at the guided end",
    source: TIMOSHENKO_BEAM,
    build,
};

fn build(facts: &Facts) -> Result<Solution, String> {
    facts.ends_are(End::Clamped, End::Guided)?;
    let (l, b, s) = facts.symbols();
    let force = facts.only_force_at(l)?;
    let at = move |x: f64| State {
        w: force * x * (x * (3.0 * l - 2.0 * x) / (12.0 * b) + 1.0 / s),
        phi: force * x * (l - x) / (2.0 * b),
        moment: force * (l - 2.0 * x) / 2.0,
        shear: force,
    };
    Ok(Solution::local(force * at(l).w / 2.0, at))
}
