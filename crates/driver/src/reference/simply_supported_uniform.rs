//! Simply supported beam under a uniform load q.
//!
//! ```text
//! w = q x (L - x) [ (L² + Lx - x²) / 24B + 1 / 2S ]      phi = q (L - 2x) (L² + 2Lx - 2x²) / 24B
//! M = -q x (L - x) / 2      V = q (L - 2x) / 2      U = q² L⁵ / 240B + q² L³ / 24S
//! ```

use super::{End, Facts, Reference, Solution, State, TIMOSHENKO_BEAM};

pub(super) const ENTRY: Reference = Reference {
    name: "simply_supported_uniform",
    about: "simply supported beam, uniform load",
    source: TIMOSHENKO_BEAM,
    build,
};

fn build(facts: &Facts) -> Result<Solution, String> {
    facts.ends_are(End::Simple, End::Simple)?;
    let (l, b, s) = facts.symbols();
    let q = facts.only_uniform()?;
    let at = move |x: f64| {
        let product = x * (l - x);
        let slope = l - 2.0 * x;
        State {
            w: q * product * ((l * l + product) / (24.0 * b) + 1.0 / (2.0 * s)),
            phi: q * slope * (l * l + 2.0 * product) / (24.0 * b),
            moment: -q * product / 2.0,
            shear: q * slope / 2.0,
        }
    };
    let energy = q * q * l.powi(3) * (l * l / (240.0 * b) + 1.0 / (24.0 * s));
    Ok(Solution::local(energy, at))
}
