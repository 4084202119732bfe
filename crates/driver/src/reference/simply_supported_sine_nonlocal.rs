//! Simply supported beam of the published bond law with image ends and the load q0 sin(kx), k = n pi / L, in
//! the limit of ever smaller spacing at a fixed horizon delta.
//!
//! The sums of the discrete symbol become integrals. With z = k delta and Cin(z) the integral of (1 - cos t)
//! / t
//!
//! ```text
//! a = S k² A      b = S k R      c = S G + B k² A          W = q0 c / (ac - b²)      P = q0 b / (ac - b²)
//! A = 4 Cin(z) / z²      R = 2 (1 - cos z) / z²      G = 1/2 - (1 - cos z) / z² + sin z / z
//! ```
//!
//! A, R and G go to 1 as z goes to 0, and the local solution returns. In a slender beam AG and R² agree in
//! most digits, so the power series are written for 1 - A, 1 - R and 1 - G, and the linear part of AG - R²,
//! which starts with z⁴, has its own.

use super::simply_supported_sine::{sine_cosine, wave_number};
use super::{End, Facts, PUBLISHED_BEAM, Reference, Solution};

/// The largest z, a horizon of 0.64 wave lengths: up to here the series lose one digit at most.
const LARGEST: f64 = 4.0;

pub(super) const ENTRY: Reference = Reference {
    name: "simply_supported_sine_nonlocal",
    about: "simply supported beam with image ends, published bond law, sine load: the limit of small spacing",
    source: PUBLISHED_BEAM,
    build,
};

fn build(facts: &Facts) -> Result<Solution, String> {
    facts.ends_are(End::Simple, End::Simple)?;
    facts.has_uniform_grid()?;
    facts.has_image_ends()?;
    facts.has_published_law()?;
    let (l, b, s) = facts.symbols();
    let (q, half_waves) = facts.only_sine()?;
    let k = wave_number(half_waves, l);
    let z = k * facts.horizon;
    if z > LARGEST {
        return Err(format!(
            "it needs a horizon of at most {}, the scene has {}",
            LARGEST / k,
            facts.horizon
        ));
    }
    let Integrals { a, r, g, shear } = Integrals::new(z);
    let determinant = b * k * k * a * a + s * shear; // (ac - b²) / S k²
    let deflection = q * (g / (k * k) + b * a / s) / determinant;
    let rotation = q * r / (k * determinant);
    Ok(Solution::nonlocal(q * deflection * l / 4.0, move |x| {
        let (sine, cosine) = sine_cosine(half_waves, x, l);
        (deflection * sine, rotation * cosine)
    }))
}

/// A, R, G of the module's head, and `shear` = AG - R².
struct Integrals {
    a: f64,
    r: f64,
    g: f64,
    shear: f64,
}

impl Integrals {
    fn new(z: f64) -> Self {
        // Deficits 1 - A, 1 - R, 1 - G, and 2 (1 - R) - (1 - A) - (1 - G), in powers z^(p - 2) / p!.
        let (mut a, mut r, mut g, mut linear) = (0.0, 0.0, 0.0, 0.0);
        let (mut term, mut p) = (-0.5, 4.0);
        while p < 40.0 {
            term *= -z * z / (p * (p - 1.0));
            a += 4.0 / p * term;
            r += 2.0 * term;
            g += (p - 1.0) * term;
            linear -= (p - 1.0) * (p - 4.0) / p * term;
            p += 2.0;
        }
        Self { a: 1.0 - a, r: 1.0 - r, g: 1.0 - g, shear: linear + a * g - r * r }
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{Law, sine_facts};
    use super::*;

    // Horizon, S, W, P for EI = 1, L = 1, q0 = 1, k = pi; evaluated with 50 digits (mpmath) from the
    // integrals.
    const AMPLITUDES: [(f64, f64, f64, f64); 6] = [
        (0.1, 4.0, 0.035658335128506455, 0.0322512055115217),
        (0.01, 4.0e+8, 0.01003626129036476, 0.03153114060613878),
        (0.1, 4.0e+8, 4.440946975618798e-05, 0.00014009160975761412),
        (0.5, 400.0, 0.008221753669134468, 0.02778175532102178),
        (1.25, 4.0, 0.05006665837375627, 0.022666993539313285),
        (1.25, 4.0e+8, 8.343976932671153e-10, 2.7736545256809033e-09),
    ];

    /// Deflection at mid-span of the spacing L / (10 m), horizon 0.1.
    fn discrete(m: u32) -> f64 {
        let facts = sine_facts(Law::Published, m, 0.1 / f64::from(m));
        let reference = crate::reference::find("simply_supported_sine_discrete").unwrap();
        ((reference.build)(&facts).unwrap().at)(0.5).w
    }

    fn nonlocal(horizon: f64, shear_stiffness: f64) -> Solution {
        let mut facts = sine_facts(Law::Published, 1, horizon);
        facts.shear_stiffness = shear_stiffness;
        build(&facts).unwrap()
    }

    #[test]
    fn amplitudes_match_the_integrals() {
        for (horizon, shear_stiffness, w, p) in AMPLITUDES {
            let solution = nonlocal(horizon, shear_stiffness);
            let (w_error, p_error) = ((solution.at)(0.5).w / w - 1.0, (solution.at)(0.0).phi / p - 1.0);
            // Measured 8e-15 where z is nearly 4 and the beam slender, at most 3e-15 in the others.
            assert!(w_error.abs() < 2e-14 && p_error.abs() < 2e-14, "{horizon}: {w_error:e}, {p_error:e}");
        }
    }

    #[test]
    fn the_grid_converges_to_it_with_the_square_of_the_spacing() {
        let limit = (nonlocal(0.1, 4.0).at)(0.5).w;
        let error = |m| (discrete(m) / limit - 1.0).abs();
        let order = (error(16) / error(32)).log2();
        // Measured 1.70e-6 and 2.00.
        assert!(error(32) < 2e-6, "{:e}", error(32));
        assert!((order - 2.0).abs() < 0.02, "{order}");
    }

    #[test]
    fn a_vanishing_horizon_gives_the_local_solution() {
        let local = crate::reference::find("simply_supported_sine").unwrap();
        let facts = sine_facts(Law::Published, 1, 1e-9);
        let expected = (local.build)(&facts).unwrap();
        let found = build(&facts).unwrap();
        for x in [0.0, 0.3, 0.5] {
            let (expected, found) = ((expected.at)(x), (found.at)(x));
            assert!((expected.w - found.w).abs() < 1e-16 && (expected.phi - found.phi).abs() < 1e-16);
        }
    }

    #[test]
    fn a_horizon_beyond_the_series_is_refused() {
        let message = build(&sine_facts(Law::Published, 1, 1.5)).unwrap_err();
        assert_eq!(message, "it needs a horizon of at most 1.2732395447351628, the scene has 1.5");
    }
}
