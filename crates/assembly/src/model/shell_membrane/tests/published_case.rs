//! A tube under axial body forces at both ends, as one row: R = 0.1592, 100 columns, ±5e9 N/m³ over 0.04 of the length 1.
//!
//! Numbers are of an independent Python implementation.

use super::super::*;
use super::tubes::*;
use crate::model::BodyModel;
use crate::model::Points;
use crate::model::plane::Calibration;

struct Golden {
    kinematics: ShellKinematics,
    calibration: Calibration,
    u: [(usize, f64); 2],
    w: [(usize, f64); 2],
    /// Diagonal stiffness of u and of w in column 50.
    stiffness: Option<[f64; 2]>,
}

fn strip(columns: i32, kinematics: ShellKinematics, calibration: Calibration) -> ShellMembrane {
    let parameters = ShellParameters { radius: 0.1592, ..parameters(kinematics, calibration) };
    shell([columns, 1], 1.0 / f64::from(columns), [false, true], parameters)
}

/// u, less the mean of both ends, and w of all columns.
fn solved(strip: &ShellMembrane) -> (Vec<f64>, Vec<f64>) {
    let n = strip.points();
    let mut f = vec![0.0; 3 * n];
    for p in strip.real_points() {
        let x = strip.place(p)[0] - 0.5;
        f[p] = if x.abs() > 0.46 { x.signum() * 5e9 * strip.volume(p) } else { 0.0 };
    }
    let count = unknowns(strip).len() / 3;
    let held = |k: usize| k == count / 2 || (count..2 * count).contains(&k);
    let mut u = solve(strip, &f, held);
    let w = u.split_off(2 * count);
    u.truncate(count);
    let middle = 0.5 * (u[0] + u[count - 1]);
    (u.iter().map(|u| u - middle).collect(), w)
}

#[test]
fn one_row_has_the_displacements_of_an_independent_implementation() {
    use Calibration::{Matched, Published};
    let cases = [
        Golden {
            kinematics: ShellKinematics::Published,
            calibration: Published,
            u: [(99, 4.5318230151e-04), (75, 2.3956935954e-04)],
            w: [(50, -4.7599234031e-05), (99, -1.2566582121e-05)],
            stiffness: Some([1.6078556808e+09, 7.1848892315e+06]),
        },
        Golden {
            kinematics: ShellKinematics::Published,
            calibration: Matched,
            u: [(99, 4.7715755705e-04), (75, 2.55e-04)],
            w: [(50, -5.3066666667e-05), (99, -1.0847154131e-05)],
            stiffness: Some([1.5371031661e+09, 6.7407481677e+06]),
        },
        Golden {
            kinematics: ShellKinematics::Chord,
            calibration: Published,
            u: [(99, 4.5312461508e-04), (99, 4.5312461508e-04)],
            w: [(50, -4.7636174560e-05), (50, -4.7636174560e-05)],
            stiffness: None,
        },
        Golden {
            kinematics: ShellKinematics::Chord,
            calibration: Matched,
            u: [(99, 4.7715773992e-04), (99, 4.7715773992e-04)],
            w: [(50, -5.3066666667e-05), (99, -1.0847650277e-05)],
            stiffness: Some([1.5372682694e+09, 6.7421197093e+06]),
        },
    ];
    for Golden { kinematics, calibration, u, w, stiffness } in cases {
        let strip = strip(100, kinematics, calibration);
        let found = solved(&strip);
        for (place, expected) in u {
            assert!((found.0[place] / expected - 1.0).abs() < 1e-8, "u {kinematics:?} {}", found.0[place]);
        }
        for (place, expected) in w {
            assert!((found.1[place] / expected - 1.0).abs() < 1e-8, "w {kinematics:?} {}", found.1[place]);
        }
        let k = matrix(&strip);
        for (place, expected) in [50, 250].into_iter().zip(stiffness.into_iter().flatten()) {
            assert!((k[(place, place)] / expected - 1.0).abs() < 1e-8, "{}", k[(place, place)]);
        }
    }
}

#[test]
fn the_middle_is_exact_and_the_ends_converge_with_order_two() {
    for kinematics in [ShellKinematics::Published, ShellKinematics::Chord] {
        let mut errors = Vec::new();
        for columns in [100, 200, 400] {
            let strip = strip(columns, kinematics, Calibration::Matched);
            let (u, w) = solved(&strip);
            let exact = |x: f64| {
                let beyond = 0.5 - x.abs();
                let outside = 4.6e-4 + 5e9 / (2.0 * E) * (0.0016 - beyond * beyond);
                if beyond >= 0.04 { 1e-3 * x } else { x.signum() * outside }
            };
            let at = |k: usize| (k as f64 + 0.5) / f64::from(columns) - 0.5;
            let error = (0..u.len()).map(|k| (u[k] - exact(at(k))).abs()).fold(0.0, f64::max);
            errors.push(error / 4.8e-4);
            let (k, step) = (columns as usize / 2, columns as usize / 5);
            let slope = (u[k + step] - u[k - step]) / 0.4;
            assert!((slope / 1e-3 - 1.0).abs() < 1e-9, "{slope}");
            assert!((w[k] / -5.3066666666667e-5 - 1.0).abs() < 1e-9, "{}", w[k]);
        }
        for pair in errors.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            assert!(order >= 1.9, "{errors:?} {order}");
        }
    }
}
