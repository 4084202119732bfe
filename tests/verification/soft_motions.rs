//! Slender beams of many points, whose softest motions a factor loses in the rounding of the stiffest.

use peristat::summary::Summary;
use serde_json::{Value, json};

/// A line of 200 000 cells under a uniform load. Its softest wave is 700 times below the rounding of the stiffest: 12.4 EI h/L⁴ is
/// 6e-5, and ε κGA/h is 4e-2.
fn line(supports: &Value) -> Value {
    let stiffness =
        json!({ "bending": { "uniform": 1.0 }, "shear": { "uniform": 1e9 }, "axial": { "uniform": 1e9 } });
    json!({
        "title": "slender", "units": "none", "horizon_ratio": 3,
        "model": { "timoshenko_beam": { "stiffness": stiffness, "bond_law": "exact" } },
        "body": { "line": { "length": 1.0, "cells": 200_000 } },
        "supports": supports,
        "loads": [{ "distributed": { "force": { "uniform": 1.0 } } }],
        "probes": [
            { "name": "middle", "field": "w", "at": { "x": 0.5 } },
            { "name": "end", "field": "w", "at": { "x": 1.0 } },
            { "name": "slope", "field": "phi", "at": { "x": 0.8 } }
        ]
    })
}

fn solved(case: &Value, solver: &str) -> Summary {
    let mut case = case.clone();
    case["solver"] = json!(solver);
    peristat::solve_text(&format!("{case:#}")).unwrap_or_else(|e| panic!("{e}")).summary
}

/// Compares displacement form, by both factors, with strain form, which loses nothing in rounding.
fn agrees(case: &Value, most: usize) {
    let exact = solved(case, "strain");
    let size = exact.probes.iter().map(|p| p.value.abs()).fold(0.0, f64::max);
    for solver in ["band", "sparse"] {
        let found = solved(case, solver);
        for (probe, exact) in found.probes.iter().zip(&exact.probes) {
            let off = (probe.value - exact.value).abs() / size;
            assert!(off < 1e-12, "{solver} {}: {off:e}", probe.name);
        }
        let iterations = found.solver.iterations[0];
        assert!(iterations <= most, "{solver}: {iterations} iterations");
        assert!(found.solver.reason.contains("solved for apart"), "{}", found.solver.reason);
        assert!(found.states[0].certificate.digits >= 11, "{solver}: {:?}", found.states[0].certificate);
    }
}

fn clamped() -> Value {
    json!([{ "at": { "x": 0 }, "w": 0, "phi": 0 }])
}

// Beside each limit: iterations today, and without the soft motions.

#[test]
fn a_cantilever_takes_as_many_iterations_as_a_short_one() {
    agrees(&line(&clamped()), 5); // 3, 30
}

#[test]
fn so_does_a_beam_on_springs() {
    agrees(
        &line(
            &json!([{ "at": { "x": 0 }, "w_spring": 1, "phi_spring": 3 }, { "at": { "x": 1 }, "w_spring": 2 }]),
        ),
        5,
    ); // 3, 22
}

#[test]
fn supports_become_nodes() {
    let held =
        |phi: f64, w: f64| json!([{ "at": { "x": 0 }, "w": 0, "phi": phi }, { "at": { "x": 0.7 }, "w": w }]);
    agrees(&line(&held(0.0, 0.0)), 12); // 8 and 9, 24 and 42
    // Prescribed motions take a second pass.
    agrees(&line(&held(0.1, 0.2)), 12); // 7 and 8, 34 and 52
}

#[test]
fn ends_may_slide_or_turn() {
    agrees(&line(&json!([{ "at": { "x": 0 }, "phi": 0 }, { "at": { "x": 1 }, "w": 0 }])), 12); // 7, 30
    let spring = [
        json!({ "at": { "x": 0 }, "w": 0 }),
        json!({ "at": { "x": 0.35 }, "w_spring": 2 }),
        json!({ "at": { "x": 1 }, "w": 0 }),
    ];
    agrees(&line(&json!(spring)), 18); // 13, 24 to 26
}

#[test]
fn graded_lines_have_them_too() {
    let mut case = line(&clamped());
    case["body"]["line"]["grading"] = json!({ "geometric": { "ratio": 5 } });
    agrees(&case, 5); // 3
}

#[test]
fn a_line_that_stretches_has_them_too() {
    let mut case = line(&clamped());
    let exact = solved(&case, "strain");
    case["supports"][0]["ux"] = json!(0);
    let pull = json!({ "point": { "at": { "x": 1 }, "axial": 5.0 } });
    case["loads"].as_array_mut().expect("a list").push(pull);
    let found = solved(&case, "band");
    for (probe, exact) in found.probes.iter().zip(&exact.probes) {
        let off = probe.value / exact.value - 1.0;
        assert!(off.abs() < 1e-12, "{}: {off:e}", probe.name);
    }
    assert!(found.solver.iterations[0] <= 5, "{} iterations", found.solver.iterations[0]);
}

#[test]
fn supports_as_close_as_bonds_do_without() {
    for apart in [1, 2] {
        let x = f64::from(apart) * 5e-6;
        let case = line(&json!([{ "at": { "x": 0 }, "w": 0, "phi": 0 }, { "at": { "x": x }, "w": 0 }]));
        let (exact, found) = (solved(&case, "strain"), solved(&case, "band"));
        let off = found.probes[1].value / exact.probes[1].value - 1.0;
        assert!(off.abs() < 1e-12, "{off:e}"); // 2e-14
        assert!(!found.solver.reason.contains("solved for apart"), "{}", found.solver.reason);
    }
}

#[test]
fn supports_that_act_one_way_have_them_too() {
    let both = line(&json!([{ "at": { "x": 0 }, "w": 0 }, { "at": { "x": 1 }, "w": 0 }]));
    let mut case = both.clone();
    case["supports"][1]["only"] = json!("negative");
    let (exact, found) = (solved(&both, "strain"), solved(&case, "band"));
    let off = found.probes[0].value / exact.probes[0].value - 1.0;
    assert!(off.abs() < 1e-12, "{off:e}");
    let iterations = found.solver.iterations.iter().sum::<usize>();
    assert!(iterations <= 15, "{iterations} iterations"); // 11
}
