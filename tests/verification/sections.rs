//! Sections that vary along a line: nodal values are those of the local beam, found here by quadrature.

use crate::support::standard::unit;
use crate::support::{Run, run};
use serde_json::{Value, json};
use std::f64::consts::PI;

/// A cantilever of length 1 clamped at 0 that nothing loads yet.
fn cantilever(bending: Value, shear: Value, cells: usize) -> Value {
    let mut case = unit(1.0, "exact", cells);
    case["model"] = json!({ "timoshenko_beam": { "stiffness": { "bending": bending, "shear": shear } } });
    case["supports"] = json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }]);
    case
}

/// `∫ f` from `a` to `b`, between breaks by Gauss' rule of three points on panels of 1/2000.
fn integral(f: impl Fn(f64) -> f64, a: f64, b: f64, breaks: &[f64]) -> f64 {
    let inside = breaks.iter().copied().filter(|x| *x > a && *x < b);
    let ends: Vec<f64> = std::iter::once(a).chain(inside).chain([b]).collect();
    let (d, weights) = (0.5 * 0.6_f64.sqrt(), [5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0]);
    let mut sum = 0.0;
    for pair in ends.windows(2) {
        let panels = 1 + (2000.0 * (pair[1] - pair[0])) as usize;
        let h = (pair[1] - pair[0]) / panels as f64;
        for k in 0..panels {
            for (z, weight) in [0.5 - d, 0.5, 0.5 + d].into_iter().zip(weights) {
                sum += weight * h * f(pair[0] + (k as f64 + z) * h);
            }
        }
    }
    sum
}

/// EI, S, M and V at a position.
type At = fn(f64) -> f64;

/// Largest errors of w and φ against `φ = ∫ M/EI` and `w = ∫ (x − s) M/EI + V/S`.
fn errors(run: &Run, [bending, shear, m, v]: [At; 4], breaks: &[f64]) -> [f64; 2] {
    run.errors(|x| {
        let phi = integral(|s| m(s) / bending(s), 0.0, x, breaks);
        (integral(|s| (x - s) * m(s) / bending(s) + v(s) / shear(s), 0.0, x, breaks), phi)
    })
}

#[test]
fn a_taper_under_a_tip_force_is_exact_at_all_points() {
    for (cells, ratio) in [(8, 3), (8, 1), (60, 5)] {
        let bending = json!({ "polynomial": [1.0, 4.5, 6.75, 3.375] });
        let mut case = cantilever(bending, json!({ "polynomial": [50.0, 75.0] }), cells);
        case["horizon_ratio"] = json!(ratio);
        case["loads"] = json!([{ "point": { "at": { "x": 1.0 }, "force": 1.0 } }]);
        let run = run(&case);
        let at: [At; 4] = [|x| (1.0 + 1.5 * x).powi(3), |x| 50.0 * (1.0 + 1.5 * x), |x| 1.0 - x, |_| 1.0];
        let [w, phi] = errors(&run, at, &[]);
        // Measured 1.1e-14 and 6e-15.
        assert!(w <= 1e-13 && phi <= 1e-13, "{cells} cells: {w:e}, {phi:e}");
        // A20, measured 1e-14; the reference has 12 digits.
        assert!((run.w(cells) / 0.172599648832 - 1.0).abs() <= 1e-11, "{}", run.w(cells));
    }
}

#[test]
fn a_taper_under_a_sine_load_is_exact_at_all_points() {
    for cells in [6, 40] {
        let bending = json!({ "polynomial": [1.0, 4.5, 6.75, 3.375] });
        let mut case = cantilever(bending, json!({ "polynomial": [50.0, 75.0] }), cells);
        case["loads"] = json!([{ "distributed": { "force": { "sine": { "amplitude": 1.0 } } } }]);
        let at: [At; 4] = [
            |x| (1.0 + 1.5 * x).powi(3),
            |x| 50.0 * (1.0 + 1.5 * x),
            |x| (1.0 - x) / PI - (PI * x).sin() / (PI * PI),
            |x| (1.0 + (PI * x).cos()) / PI,
        ];
        let [w, phi] = errors(&run(&case), at, &[]);
        // Measured 5e-15.
        assert!(w <= 1e-13 && phi <= 1e-13, "{cells} cells: {w:e}, {phi:e}");
    }
}

#[test]
fn two_breaks_of_a_table_inside_one_cell_are_exact_at_all_points() {
    // Breaks at 0.31 and 0.36, where cells are a tenth.
    let bending = json!({ "table": [[0.0, 4.0], [0.31, 3.0], [0.36, 3.0], [0.36, 1.0], [1.0, 0.5]] });
    let shear = json!({ "table": [[0.31, 200.0], [0.36, 90.0]] });
    let mut case = cantilever(bending, shear, 10);
    case["loads"] = json!([
        { "distributed": { "force": { "uniform": 2.0 } } },
        { "point": { "at": { "x": 1.0 }, "moment": -0.7 } }
    ]);
    let at: [At; 4] = [
        |x| {
            if x < 0.31 {
                4.0 - x / 0.31
            } else if x < 0.36 {
                3.0
            } else {
                1.0 - 0.5 * (x - 0.36) / 0.64
            }
        },
        |x| 200.0 - 110.0 * ((x - 0.31) / 0.05).clamp(0.0, 1.0),
        |x| (1.0 - x) * (1.0 - x) - 0.7,
        |x| 2.0 * (1.0 - x),
    ];
    let [w, phi] = errors(&run(&case), at, &[0.31, 0.36]);
    // Measured 3e-14 and 1e-15.
    assert!(w <= 1e-13 && phi <= 1e-13, "{w:e}, {phi:e}");
}

#[test]
fn a_stiffness_that_falls_by_orders_of_magnitude_within_a_cell_is_integrated_all_the_same() {
    for least in [0.1, 1e-3, 1e-6] {
        for cells in [1, 16] {
            let bending = json!({ "table": [[0.0, 1.0], [1.0, least]] });
            let mut case = cantilever(bending, json!({ "uniform": 1000.0 }), cells);
            case["loads"] = json!([{ "point": { "at": { "x": 1.0 }, "moment": 1.0 } }]);
            let run = run(&case);
            // φ = ∫ dx/(1 − (1 − r) x).
            let expected = -f64::ln(least) / (1.0 - least);
            let wrong = (run.unknowns(0)[1][cells] / expected - 1.0).abs();
            // Measured 1.1e-15; 8e-14 for the last, where EI itself is rounded to 1e-10 of its least value.
            assert!(wrong <= if least < 1e-4 { 3e-13 } else { 1e-14 }, "{least}, {cells} cells: {wrong:e}");
        }
    }
}

#[test]
fn a_section_that_ends_as_it_begins_is_uniform() {
    let beam = |end: Value| {
        let mut case = crate::support::standard::steel(0.05, "corrected", 12);
        case["supports"] = json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }]);
        case["loads"] = json!([{ "point": { "at": { "x": 1.0 }, "force": 1e3 } }]);
        case["model"]["timoshenko_beam"]["end_section"] = end;
        run(&case)
    };
    let same = json!({ "rectangle": { "width": 0.05, "height": 0.05 } });
    assert_eq!(beam(same).states[0].record.u, beam(Value::Null).states[0].record.u);
}
