//! Cantilever under a uniform load q.
//!
//! ```text
//! w = q x² (6L² - 4Lx + x²) / 24B + q x (2L - x) / 2S      phi = q x (3L² - 3Lx + x²) / 6B
//! M = q (L - x)² / 2      V = q (L - x)      U = q² L⁵ / 40B + q² L³ / 6S
//! ```
//!
//! The brackets are evaluated as 2L² + (2L - x)² and L² + (L - x)(2L - x), sums of positive terms.

use super::{End, Facts, Reference, Solution, State, TIMOSHENKO_BEAM};

pub(super) const ENTRY: Reference = Reference {
    name: "cantilever_uniform",
    about: "cantilever, uniform load",
    source: TIMOSHENKO_BEAM,
    build,
};

fn build(facts: &Facts) -> Result<Solution, String> {
    facts.ends_are(End::Clamped, End::Free)?;
    let (l, b, s) = facts.symbols();
    let q = facts.only_uniform()?;
    let at = move |x: f64| {
        let (rest, beyond) = (l - x, 2.0 * l - x);
        State {
            w: q * x * (x * (2.0 * l * l + beyond * beyond) / (24.0 * b) + beyond / (2.0 * s)),
            phi: q * x * (l * l + rest * beyond) / (6.0 * b),
            moment: q * rest * rest / 2.0,
            shear: q * rest,
        }
    };
    let energy = q * q * l.powi(3) * (l * l / (40.0 * b) + 1.0 / (6.0 * s));
    Ok(Solution::local(energy, at))
}
