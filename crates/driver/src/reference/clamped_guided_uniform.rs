//! Beam clamped at x = 0 and guided at x = L (phi = 0, free to move) under a uniform load q.
//!
//! Half of a clamped beam of length 2L:
//!
//! ```text
//! w = q x (2L - x) [ x (2L - x) / 24B + 1 / 2S ]      phi = q x (L - x) (2L - x) / 6B
//! M = q (3 (L - x)² - L²) / 6      V = q (L - x)      U = q² L⁵ / 90B + q² L³ / 6S
//! ```

use super::{End, Facts, Reference, Solution, State, TIMOSHENKO_BEAM};

pub(super) const ENTRY: Reference = Reference {
    name: "clamped_guided_uniform",
    about: "beam clamped at x = 0 and guided at x = L, uniform load",
    source: TIMOSHENKO_BEAM,
    build,
};

fn build(facts: &Facts) -> Result<Solution, String> {
    facts.ends_are(End::Clamped, End::Guided)?;
    let (l, b, s) = facts.symbols();
    let q = facts.only_uniform()?;
    let at = move |x: f64| {
        let rest = l - x;
        let product = x * (2.0 * l - x);
        State {
            w: q * product * (product / (24.0 * b) + 1.0 / (2.0 * s)),
            phi: q * product * rest / (6.0 * b),
            moment: q * (3.0 * rest * rest - l * l) / 6.0,
            shear: q * rest,
        }
    };
    let energy = q * q * l.powi(3) * (l * l / (90.0 * b) + 1.0 / (6.0 * s));
    Ok(Solution::local(energy, at))
}
