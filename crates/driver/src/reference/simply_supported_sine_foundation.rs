//! Simply supported beam on a Winkler foundation k_f under the load q0 sin(kx), k = n pi / L.
//!
//! ```text
//! w = W sin kx      W = q0 / (k_f + K)      K = B k⁴ / (1 + B k² / S)
//! phi = (W K / B k³) cos kx      M = -(W K / k²) sin kx      V = (W K / k) cos kx      U = q0 W L / 4
//! ```
//!
//! W K is the part of the load that the beam carries itself; the foundation carries W k_f. U is the energy of
//! both.

use super::simply_supported_sine::{sine_cosine, wave_number};
use super::{End, FOUNDATION_BEAM, Facts, Reference, Solution, State};

pub(super) const ENTRY: Reference = Reference {
    name: "simply_supported_sine_foundation",
    about: "simply supported beam on a Winkler foundation, sine load of any number of half waves",
    source: FOUNDATION_BEAM,
    build,
};

fn build(facts: &Facts) -> Result<Solution, String> {
    facts.ends_are(End::Simple, End::Simple)?;
    let (l, b, s) = facts.symbols();
    let ((q, half_waves), foundation) = facts.only_sine_on_foundation()?;
    let k = wave_number(half_waves, l);
    let stiffness = k * k / (1.0 / (b * k * k) + 1.0 / s);
    let deflection = q / (foundation + stiffness);
    let carried = deflection * stiffness;
    let at = move |x: f64| {
        let (sine, cosine) = sine_cosine(half_waves, x, l);
        State {
            w: deflection * sine,
            phi: carried * cosine / (b * k * k * k),
            moment: -carried * sine / (k * k),
            shear: carried * cosine / k,
        }
    };
    Ok(Solution::local(q * deflection * l / 4.0, at))
}

#[cfg(test)]
mod tests {
    use super::super::tests::facts_for;
    use super::super::{Load, find};
    use super::*;

    fn scene(stiffness: f64) -> Facts {
        let mut facts = facts_for(ENTRY.name);
        facts.loads[1] = Load::Foundation { stiffness };
        facts
    }

    #[test]
    fn a_vanishing_foundation_gives_the_beam_without_one() {
        let mut alone = scene(1.0);
        alone.loads.truncate(1);
        let expected = (find("simply_supported_sine").unwrap().build)(&alone).unwrap();
        let found = build(&scene(1e-20)).unwrap();
        for x in [0.0, 0.3, 0.6, 1.7] {
            let (expected, found) = ((expected.at)(x), (found.at)(x));
            // Measured 3.5e-18, in w.
            assert!((found.w - expected.w).abs() < 1e-16 && (found.phi - expected.phi).abs() < 1e-16);
            assert!((found.moment - expected.moment).abs() < 1e-16, "{x}");
            assert!((found.shear - expected.shear).abs() < 1e-16, "{x}");
        }
    }

    #[test]
    fn a_stiff_foundation_carries_the_load_alone() {
        let found = (build(&scene(1e20)).unwrap().at)(1.7 / 6.0);
        assert!((found.w / (6.1 / 1e20) - 1.0).abs() < 1e-15);
        assert!(found.moment.abs() < 1e-15);
    }
}
