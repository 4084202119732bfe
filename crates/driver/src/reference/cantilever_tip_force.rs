//! Cantilever with a force F at its free end.
//!
//! ```text
//! w = F x² (3L - x) / 6B + F x / S      phi = F x (2L - x) / 2B      M = F (L - x)      V = F
//! ```

use super::{End, Facts, Reference, Solution, State, TIMOSHENKO_BEAM};

pub(super) const ENTRY: Reference = Reference {
    name: "cantilever_tip_force",
    about: "cantilever, force at the free end",
    source: TIMOSHENKO_BEAM,
    build,
};

fn build(facts: &Facts) -> Result<Solution, String> {
    facts.ends_are(End::Clamped, End::Free)?;
    let (l, b, s) = facts.symbols();
    let force = facts.only_force_at(l)?;
    let at = move |x: f64| State {
        w: force * x * (x * (3.0 * l - x) / (6.0 * b) + 1.0 / s),
        phi: force * x * (2.0 * l - x) / (2.0 * b),
        moment: force * (l - x),
        shear: force,
    };
    Ok(Solution::local(force * at(l).w / 2.0, at))
}
