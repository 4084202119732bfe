//! Beam over two equal spans under a uniform load q: simple supports at x = 0, L/2 and L.
//!
//! The section over the middle support does not turn, so each span is a beam clamped there and simply
//! supported at its outer end. w and M are even and phi and V odd about L/2; at L/2 itself V is the left
//! value.

use super::clamped_simply_supported_uniform::Propped;
use super::{End, Facts, Reference, Solution, State, TIMOSHENKO_BEAM};

pub(super) const ENTRY: Reference = Reference {
    name: "two_span_uniform",
    about: "beam on three simple supports with two equal spans, uniform load",
    source: TIMOSHENKO_BEAM,
    build,
};

fn build(facts: &Facts) -> Result<Solution, String> {
    let (l, b, s) = facts.symbols();
    let middle = l / 2.0;
    facts.supports_are(End::Simple, &[middle], End::Simple)?;
    let span = Propped::new(facts.only_uniform()?, middle, b, s);
    let at = move |x: f64| {
        if x > middle {
            return span.at(x - middle);
        }
        let mirrored = span.at(middle - x);
        State { phi: -mirrored.phi, shear: -mirrored.shear, ..mirrored }
    };
    Ok(Solution::local(2.0 * span.energy(), at))
}
