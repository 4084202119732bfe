//! Handbook formulas of crack specimens, as functions of x = a/W.

/// Stress intensity of a compact tension specimen, `K B √W / P`: ASTM E399.
pub(crate) fn compact_tension(x: f64) -> f64 {
    (2.0 + x) * (0.886 + x * (4.64 + x * (-13.32 + x * (14.72 - 5.6 * x)))) / (1.0 - x).powf(1.5)
}

/// Its opening at the mouth, a quarter of the width before the load line, `E' B V0 / P`: ASTM E399.
pub(crate) fn mouth_opening(x: f64) -> f64 {
    19.75 / (1.0 - x).powi(2) * (0.5 + x * (0.192 + x * (1.385 + x * (-2.919 + 1.842 * x))))
}

/// Its opening on the load line, `E' B V / P`: ASTM E1820.
pub(crate) fn load_line_opening(x: f64) -> f64 {
    let sum = 2.163 + x * (12.219 + x * (-20.065 + x * (-0.9925 + x * (20.609 - 9.9314 * x))));
    ((1.0 + x) / (1.0 - x)).powi(2) * sum
}

/// Stress intensity of a bend specimen of a span of four widths, `K B W^1.5 / (P S)`: ASTM E399.
pub(crate) fn single_edge_bend(x: f64) -> f64 {
    let sum = 1.99 - x * (1.0 - x) * (2.15 - 3.93 * x + 2.7 * x * x);
    3.0 * x.sqrt() * sum / (2.0 * (1.0 + 2.0 * x) * (1.0 - x).powf(1.5))
}

/// Stress intensity of a panel of width 2W with a central crack of length 2a, `K / (σ √(π a))`: Feddersen's secant with
/// Tada's polynomial, 0.1 %.
pub(crate) fn centre_cracked_panel(x: f64) -> f64 {
    (1.0 - 0.025 * x * x + 0.06 * x.powi(4)) / (std::f64::consts::FRAC_PI_2 * x).cos().sqrt()
}

/// Root of the mean square of a formula between two crack lengths: what the difference of two energies is to be compared
/// with.
pub(crate) fn averaged(formula: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    // Simpson's rule.
    let (n, step) = (100, (to - from) / 100.0);
    let weight = |k: i32| if k == 0 || k == n { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
    let sum: f64 = (0..=n).map(|k| weight(k) * formula(from + f64::from(k) * step).powi(2)).sum();
    (sum / (3.0 * f64::from(n))).sqrt()
}

#[test]
fn formulas_have_their_published_values() {
    // An independent Python implementation: f(.5) = 9.659, V0 = 54.71, V_LL = 36.99; E399, table of f(.5) = 2.66 for a span of four widths.
    let close =
        |found: f64, expected: f64, digits: f64| assert!((found - expected).abs() < digits, "{found}");
    close(compact_tension(0.5), 9.659, 5e-4);
    close(mouth_opening(0.5), 54.71, 5e-3);
    close(load_line_opening(0.5), 36.99, 5e-3);
    close(single_edge_bend(0.5), 2.66, 5e-3);
    // The root of the secant is the fourth root of 2, the polynomial 0.9975.
    close(centre_cracked_panel(0.5), 2.0_f64.powf(0.25) * 0.9975, 1e-12);
}
