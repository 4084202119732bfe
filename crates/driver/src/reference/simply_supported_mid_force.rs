//! Simply supported beam with a force F at mid-span.
//!
//! For x <= L/2, and mirrored behind it (w and M even, phi and V odd about L/2; at L/2 itself V is the left
//! value):
//!
//! ```text
//! w = F x (3L² - 4x²) / 48B + F x / 2S      phi = F (L² - 4x²) / 16B      M = -F x / 2      V = F / 2
//! ```

use super::{End, Facts, Reference, Solution, State, TIMOSHENKO_BEAM};

pub(super) const ENTRY: Reference = Reference {
    name: "simply_supported_mid_force",
    about: "simply supported beam, force at mid-span",
    source: TIMOSHENKO_BEAM,
    build,
};

fn build(facts: &Facts) -> Result<Solution, String> {
    facts.ends_are(End::Simple, End::Simple)?;
    let (l, b, s) = facts.symbols();
    let force = facts.only_force_at(l / 2.0)?;
    let at = move |x: f64| {
        let (y, side) = if x <= l / 2.0 { (x, 1.0) } else { (l - x, -1.0) };
        State {
            w: force * y * ((3.0 * l * l - 4.0 * y * y) / (48.0 * b) + 1.0 / (2.0 * s)),
            phi: side * force * (l - 2.0 * y) * (l + 2.0 * y) / (16.0 * b),
            moment: -force * y / 2.0,
            shear: side * force / 2.0,
        }
    };
    Ok(Solution::local(force * at(l / 2.0).w / 2.0, at))
}
