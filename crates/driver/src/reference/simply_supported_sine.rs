//! Simply supported beam under the load q0 sin(kx), k = n pi / L.
//!
//! ```text
//! w = q0 (1 / B k⁴ + 1 / S k²) sin kx      phi = q0 cos kx / B k³
//! M = -q0 sin kx / k²      V = q0 cos kx / k      U = q0 W L / 4,  W the amplitude of w
//! ```

use std::f64::consts::PI;

use super::{End, Facts, Reference, Solution, State, TIMOSHENKO_BEAM};

pub(super) const ENTRY: Reference = Reference {
    name: "simply_supported_sine",
    about: "simply supported beam, sine load of any number of half waves",
    source: TIMOSHENKO_BEAM,
    build,
};

fn build(facts: &Facts) -> Result<Solution, String> {
    facts.ends_are(End::Simple, End::Simple)?;
    let (l, b, s) = facts.symbols();
    let (q, half_waves) = facts.only_sine()?;
    let k = wave_number(half_waves, l);
    let deflection = q * (1.0 / (b * k * k) + 1.0 / s) / (k * k);
    let at = move |x: f64| {
        let (sine, cosine) = sine_cosine(half_waves, x, l);
        State {
            w: deflection * sine,
            phi: q * cosine / (b * k * k * k),
            moment: -q * sine / (k * k),
            shear: q * cosine / k,
        }
    };
    Ok(Solution::local(q * deflection * l / 4.0, at))
}

/// k = n pi / L.
pub(super) fn wave_number(half_waves: u32, length: f64) -> f64 {
    f64::from(half_waves) * PI / length
}

/// sin(n pi x / L) and cos(n pi x / L). Whole turns and quarters are removed from n x, whose rounding error
/// is kept, before pi comes in: the sine is exactly zero at the supports and the error does not grow with n.
pub(super) fn sine_cosine(half_waves: u32, x: f64, length: f64) -> (f64, f64) {
    let n = f64::from(half_waves);
    let rounded = n * x;
    let lost = n.mul_add(x, -rounded);
    let turned = (rounded.rem_euclid(2.0 * length) + lost) / length;
    let (sign, t) = if turned > 1.0 { (-1.0, turned - 1.0) } else { (1.0, turned) };
    let (sine, cosine) = if t < 0.25 {
        (PI * t).sin_cos()
    } else if t <= 0.75 {
        let (sine, cosine) = (PI * (0.5 - t)).sin_cos();
        (cosine, sine)
    } else {
        let (sine, cosine) = (PI * (1.0 - t)).sin_cos();
        (sine, -cosine)
    };
    (sign * sine, sign * cosine)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sine_is_that_of_the_library_and_zero_at_its_nodes() {
        for half_waves in 1..=5 {
            for i in 0..=200 {
                let x = f64::from(i) / 200.0 * 2.5;
                let (sine, cosine) = sine_cosine(half_waves, x, 2.5);
                let (s, c) = (wave_number(half_waves, 2.5) * x).sin_cos();
                // Measured 1.4e-15, nearly all of it the rounding of k x on the right.
                assert!((sine - s).abs() < 4e-15 && (cosine - c).abs() < 4e-15, "n = {half_waves}, x = {x}");
            }
            assert_eq!(sine_cosine(half_waves, 2.5, 2.5).0.abs(), 0.0);
        }
    }
}
