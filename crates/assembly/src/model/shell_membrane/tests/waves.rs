//! Waves on a cylinder that repeats itself along its axis: forces against those of the continuum.

use super::super::*;
use super::tubes::*;
use crate::model::plane::Calibration;
use std::f64::consts::TAU;

/// Largest error of the forces of `u = sin kx cos nθ, v = 0.7 cos kx sin nθ, w = 0.4 cos kx cos nθ`, per the largest force.
fn error(points: i32, [along, around]: [f64; 2], kinematics: ShellKinematics) -> f64 {
    let spacing = 1.0 / f64::from(points);
    let tube = shell([points; 2], spacing, [true; 2], parameters(kinematics, Calibration::Matched));
    let (k, n, r) = (TAU * along, around, 1.0 / TAU);
    let u = state(&tube, |[x, s]| {
        let ((a, b), (c, d)) = ((k * x).sin_cos(), (n * s / r).sin_cos());
        [a * d, 0.7 * b * c, 0.4 * b * d]
    });
    let (ex, es, g) = (k, 0.7 * n / r + 0.4 / r, -(n / r + 0.7 * k));
    let c = 1.125 * E * H;
    let (nx, ns, nt) = (c * (ex + es / 3.0), c * (es + ex / 3.0), c * g / 3.0);
    let area = spacing * spacing;
    let exact = state(&tube, |[x, s]| {
        let ((a, b), (c, d)) = ((k * x).sin_cos(), (n * s / r).sin_cos());
        [(nx * k - nt * n / r) * a * d, (ns * n / r - nt * k) * b * c, ns / r * b * d].map(|f| f * area)
    });
    let found = force(&tube, &u);
    let real = unknowns(&tube);
    let difference = real.iter().map(|&k| (found[k] - exact[k]).abs()).fold(0.0, f64::max);
    difference / real.iter().map(|&k| exact[k].abs()).fold(0.0, f64::max)
}

#[test]
fn forces_of_waves_converge_with_order_two() {
    // Errors at 48 and 96 points around are of an independent Python implementation.
    let cases = [
        ([1.0, 0.0], ShellKinematics::Published, [6.95e-3, 1.74e-3]),
        ([1.0, 0.0], ShellKinematics::Chord, [6.94e-3, 1.74e-3]),
        ([1.0, 2.0], ShellKinematics::Published, [3.86e-2, 9.80e-3]),
        ([1.0, 2.0], ShellKinematics::Chord, [4.82e-2, 1.23e-2]),
        ([0.0, 2.0], ShellKinematics::Chord, [4.45e-2, 1.13e-2]),
    ];
    for (wave, kinematics, expected) in cases {
        let errors = [48, 96].map(|points| error(points, wave, kinematics));
        let order = (errors[0] / errors[1]).log2();
        assert!((1.9..=2.1).contains(&order), "{wave:?} {kinematics:?} {order}");
        (0..2).for_each(|k| assert!((errors[k] / expected[k] - 1.0).abs() < 0.02, "{wave:?} {errors:?}"));
    }
}
