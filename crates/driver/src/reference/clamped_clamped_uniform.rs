//! Beam clamped at both ends under a uniform load q.
//!
//! ```text
//! w = q x (L - x) [ x (L - x) / 24B + 1 / 2S ]      phi = q x (L - x) (L - 2x) / 12B
//! M = q (L² - 6Lx + 6x²) / 12      V = q (L - 2x) / 2      U = q² L⁵ / 1440B + q² L³ / 24S
//! ```

use super::{End, Facts, Reference, Solution, State, TIMOSHENKO_BEAM};

pub(super) const ENTRY: Reference = Reference {
    name: "clamped_clamped_uniform",
    about: "beam clamped at both ends, uniform load",
    source: TIMOSHENKO_BEAM,
    build,
};

fn build(facts: &Facts) -> Result<Solution, String> {
    facts.ends_are(End::Clamped, End::Clamped)?;
    let (l, b, s) = facts.symbols();
    let q = facts.only_uniform()?;
    let at = move |x: f64| {
        let product = x * (l - x);
        State {
            w: q * product * (product / (24.0 * b) + 1.0 / (2.0 * s)),
            phi: q * product * (l - 2.0 * x) / (12.0 * b),
            moment: q * (l * l - 6.0 * product) / 12.0,
            shear: q * (l - 2.0 * x) / 2.0,
        }
    };
    let energy = q * q * l.powi(3) * (l * l / (1440.0 * b) + 1.0 / (24.0 * s));
    Ok(Solution::local(energy, at))
}
