//! Winkler foundations on the points: second order with lumped loads.

use crate::support::standard::unit;
use crate::support::{error, relative, run, scene};
use serde_json::{Value, json};
use std::f64::consts::PI;

/// A beam of length 1, EI = 1, κGA = 50 on a foundation.
fn beam(cells: usize, foundation: Value) -> Value {
    let mut case = unit(50.0, "exact", cells);
    case["foundation"] = foundation;
    case
}

#[test]
fn a_sine_load_on_a_foundation_is_of_second_order() {
    let k = PI;
    let amplitude = 1.0 / (1000.0 + k.powi(4) / (1.0 + k * k / 50.0));
    let error = |cells: usize| {
        let mut case = beam(cells, json!([{ "stiffness": { "uniform": 1000.0 } }]));
        case["supports"] = json!([{ "at": { "x": 0.0 }, "w": 0.0 }, { "at": { "x": 1.0 }, "w": 0.0 }]);
        case["loads"] = json!([{ "distributed": { "force": { "sine": { "amplitude": 1.0 } } } }]);
        run(&case).errors(|x| (amplitude * (k * x).sin(), 1.0))[0]
    };
    let errors = [8, 16, 32, 64].map(error);
    // A24, measured 1.06e-3, 2.06e-4, 5.02e-5, 1.25e-5: orders 2.04 and 2.01.
    assert!(errors[2] < 6e-5, "{errors:?}");
    for pair in errors[1..].windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.05, "{errors:?}");
    }
}

#[test]
fn a_foundation_alone_carries_a_rigid_beam_by_the_lever() {
    // Stiff beam on k = 1 + s: deflection a + b x with ∫ k (a + b x) (1, x) = F (1, c).
    let mut case = beam(200, json!([{ "stiffness": { "polynomial": [1e-6, 1e-6] } }]));
    case["loads"] = json!([{ "point": { "at": { "x": 0.25 }, "force": 1.0 } }]);
    let run = run(&case);
    // Moments of k/1e-6 over the length: 3/2, 5/6, 7/12.
    let (m0, m1, m2) = (1.5e-6, 5.0 / 6.0 * 1e-6, 7.0 / 12.0 * 1e-6);
    let determinant = m0 * m2 - m1 * m1;
    let (a, b) = ((m2 - 0.25 * m1) / determinant, (0.25 * m0 - m1) / determinant);
    let [w, phi] = run.errors(|x| (a + b * x, b));
    // Measured 2.5e-5 and 3.9e-5: the trapezoidal rule on 200 cells.
    assert!(w <= 5e-5 && phi <= 5e-5, "{w:e}, {phi:e}");
    assert!(run.states[0].record.certificate.energy_balance <= 1e-10);
    assert!(run.states[0].record.certificate.balance.iter().all(|b| b.relative <= 1e-9));
}

#[test]
fn foundations_that_overlap_add_up() {
    let loaded = |foundation: Value| {
        let mut case = beam(40, foundation);
        case["supports"] = json!([{ "at": { "x": 0.0 }, "w": 0.0 }]);
        case["loads"] = json!([{ "distributed": { "from": 0.3, "to": 0.9, "force": { "uniform": 2.0 } } }]);
        run(&case)
    };
    let two = json!([
        { "stiffness": { "uniform": 300.0 } },
        { "from": 0.5, "stiffness": { "polynomial": [100.0, 400.0] } }
    ]);
    let half = |part: &Value| {
        let k = |value: &Value| value.as_f64().map(|k| 0.5 * k);
        let stiffness = match part["stiffness"]["uniform"].is_number() {
            true => json!({ "uniform": k(&part["stiffness"]["uniform"]) }),
            false => {
                let c = part["stiffness"]["polynomial"].as_array().expect("coefficients");
                json!({ "polynomial": c.iter().map(k).collect::<Vec<_>>() })
            }
        };
        let mut half = part.clone();
        half["stiffness"] = stiffness;
        half
    };
    let halves: Vec<Value> = two.as_array().expect("a list").iter().map(half).collect();
    let four = json!([halves[0], halves[1], halves[0], halves[1]]);
    let (found, expected) = (loaded(four), loaded(two));
    let error = relative(found.w(40), expected.w(40));
    // Measured 0.
    assert!(error <= 1e-12, "{error:e}");
}

#[test]
fn a_foundation_under_a_part_of_a_cell_is_a_spring_on_its_point() {
    // 0.501 to 0.503 lies in the share of the point at 0.5: a spring of 2 there.
    let mut on_foundation =
        beam(10, json!([{ "from": 0.501, "to": 0.503, "stiffness": { "uniform": 1000.0 } }]));
    // No bond spans a point.
    on_foundation["horizon_ratio"] = json!(1);
    on_foundation["supports"] = json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }]);
    on_foundation["loads"] = json!([{ "point": { "at": { "x": 1.0 }, "force": 1.0 } }]);
    // 1/3 + 1/50 at the tip under the tip force; influence at 0.5: 5/48 + 0.01; stiffness at 0.5: 1/24 + 0.01.
    let (tip, cross, middle) = (1.0 / 3.0 + 0.02, 5.0 / 48.0 + 0.01, 1.0 / 24.0 + 0.01);
    let spring = 2.0;
    let expected = tip - cross * cross / (1.0 / spring + middle);
    let error = relative(run(&on_foundation).w(10), expected);
    // Measured 0.
    assert!(error <= 1e-12, "{error:e}");
}

#[test]
fn a_foundation_too_stiff_for_the_cells_is_a_warning() {
    let is_quiet = |k: f64| {
        let mut case = beam(8, json!([{ "stiffness": { "uniform": k } }]));
        let stiffness = json!({ "bending": { "uniform": 1.0 }, "shear": { "uniform": 50.0 } });
        case["model"] = json!({ "timoshenko_beam": { "stiffness": stiffness } });
        case["loads"] = json!([{ "point": { "at": { "x": 0.5 }, "force": 1.0 } }]);
        scene(&case).warnings.is_empty()
    };
    // The beam bends over (4 EI/k)^(1/4), here 1 and half a cell of 1/8.
    assert!(is_quiet(4.0) && !is_quiet(4.0 / (0.5_f64 / 8.0).powi(4)));
}

#[test]
fn a_strip_that_a_table_cuts_out_is_the_strip_between_its_ends() {
    let beds = [
        json!({ "stiffness": { "table": [[0.0, 0.0], [0.53, 0.0], [0.53, 1e5], [0.545, 1e5], [0.545, 0.0]] } }),
        json!({ "from": 0.53, "to": 0.545, "stiffness": { "uniform": 1e5 } }),
    ];
    let [table, ends] = beds.map(|bed| {
        let mut case = unit(1000.0, "exact", 40);
        case["supports"] = json!([0.0, 1.0].map(|x| json!({ "at": { "x": x }, "w": 0.0 })));
        case["foundation"] = json!([bed]);
        case["loads"] = json!([{ "distributed": { "force": { "uniform": 1.0 } } }]);
        run(&case).unknowns(0)
    });
    // Measured 6e-15: the widths of the strip are rounded differently.
    assert!(error(&table[0], &ends[0]) <= 1e-12, "{:e}", error(&table[0], &ends[0]));
}

#[test]
fn lumped_parts_of_loads_add_up_to_the_loads() {
    let mut case = unit(1000.0, "exact", 10);
    case["model"]["timoshenko_beam"]["distributed_loads"] = json!("lumped");
    case["supports"] = json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }]);
    let linear = json!({ "from": 0.13, "to": 0.37, "force": { "linear": [1.0, 3.0] } });
    case["loads"] = json!([{ "distributed": linear }]);
    let sum: f64 = run(&case).load()[..11].iter().sum();
    assert!((sum - 0.48).abs() <= 1e-15, "{sum}");
}

#[test]
fn shear_forces_on_a_foundation_and_under_lumped_loads_are_of_second_order() {
    let error = |cells: usize| {
        let mut case = beam(cells, json!([{ "stiffness": { "uniform": 40.0 } }]));
        case["loads"] = json!([{ "point": { "at": { "x": 0.5 }, "force": 1.0 } }]);
        let name = "free_free_foundation_mid_force";
        case["checks"] = json!([{ "closed_form": { "name": name, "field": "V", "tolerance": 1.0 } }]);
        peristat::solve_text(&case.to_string()).expect("a case").summary.checks[0].error
    };
    let errors = [16, 32, 64].map(error);
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        // Measured 1.86 and 1.91; forces on points alone give 1.
        assert!(order > 1.8, "{errors:?}");
    }
    let mut case = unit(50.0, "exact", 50);
    case["model"]["timoshenko_beam"]["distributed_loads"] = json!("lumped");
    case["supports"] = json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }]);
    case["loads"] = json!([{ "distributed": { "force": { "uniform": 1.0 } } }]);
    case["checks"] =
        json!([{ "closed_form": { "name": "cantilever_uniform", "field": "V", "tolerance": 1.0 } }]);
    let solved = peristat::solve_text(&case.to_string()).expect("a case");
    // Measured 3e-16: a uniform load is known all along.
    assert!(solved.summary.checks[0].error <= 1e-14, "{}", solved.summary.checks[0].error);
}
