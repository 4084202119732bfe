//! Cantilever with a moment C at its free end.
//!
//! ```text
//! w = C x² / 2B      phi = C x / B      M = C      V = 0
//! ```

use super::{End, Facts, Reference, Solution, State, TIMOSHENKO_BEAM};

pub(super) const ENTRY: Reference = Reference {
    name: "cantilever_end_moment",
    about: "cantilever, moment at the free end",
    source: TIMOSHENKO_BEAM,
    build,
};

fn build(facts: &Facts) -> Result<Solution, String> {
    facts.ends_are(End::Clamped, End::Free)?;
    let (l, b, _) = facts.symbols();
    let moment = facts.only_moment_at(l)?;
    let at = move |x: f64| State { w: moment * x * x / (2.0 * b), phi: moment * x / b, moment, shear: 0.0 };
    Ok(Solution::local(moment * at(l).phi / 2.0, at))
}
