//! Simply supported beam under a uniform moment load c, the moment per length.
//!
//! V' = 0 and M' = -V - c with M = 0 at both ends leave V = -c and M = 0: the supports carry the load as a
//! couple and the sections turn by a constant angle. The deflection vanishes only because shear and rotation
//! cancel.
//!
//! ```text
//! w = 0      phi = c / S      M = 0      V = -c      U = c² L / 2S
//! ```

use super::{End, Facts, Reference, Solution, State, TIMOSHENKO_BEAM};

pub(super) const ENTRY: Reference = Reference {
    name: "simply_supported_uniform_moment",
    about: "simply supported beam, uniform moment per length (only the shear strain is not zero)",
    source: TIMOSHENKO_BEAM,
    build,
};

fn build(facts: &Facts) -> Result<Solution, String> {
    facts.ends_are(End::Simple, End::Simple)?;
    let (l, _, s) = facts.symbols();
    let c = facts.only_uniform_moment()?;
    let state = State { w: 0.0, phi: c / s, moment: 0.0, shear: -c };
    Ok(Solution::local(c * state.phi * l / 2.0, move |_| state))
}
