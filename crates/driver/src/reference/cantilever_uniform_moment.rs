//! Cantilever under a uniform moment load c, the moment per length.
//!
//! No force acts, so V = 0, and M' = -c with M(L) = 0. Shear does not matter: phi = w'.
//!
//! ```text
//! w = c x² (3L - x) / 6B      phi = c x (2L - x) / 2B      M = c (L - x)      V = 0      U = c² L³ / 6B
//! ```

use super::{End, Facts, Reference, Solution, State, TIMOSHENKO_BEAM};

pub(super) const ENTRY: Reference = Reference {
    name: "cantilever_uniform_moment",
    about: "cantilever, uniform moment per length",
    source: TIMOSHENKO_BEAM,
    build,
};

fn build(facts: &Facts) -> Result<Solution, String> {
    facts.ends_are(End::Clamped, End::Free)?;
    let (l, b, _) = facts.symbols();
    let c = facts.only_uniform_moment()?;
    let at = move |x: f64| State {
        w: c * x * x * (3.0 * l - x) / (6.0 * b),
        phi: c * x * (2.0 * l - x) / (2.0 * b),
        moment: c * (l - x),
        shear: 0.0,
    };
    Ok(Solution::local(c * c * l.powi(3) / (6.0 * b), at))
}
