//! Slender beams of many points, whose softest motions a factor loses in the rounding of the stiffest.

use peristat::summary::Summary;
use serde_json::{Value, json};

/// A line of 200 000 cells under a uniform load, whose softest wave is 700 times below the rounding of its stiffest: EI h 12.4/L⁴ = 6e-5, ε κGA/h = 4e-2.
fn solved(supports: &Value, solver: &str) -> Summary {
    let stiffness =
        json!({ "bending": { "uniform": 1.0 }, "shear": { "uniform": 1e9 }, "axial": { "uniform": 1e9 } });
    let case = json!({
        "title": "slender", "units": "none", "horizon_ratio": 3, "solver": solver,
        "model": { "timoshenko_beam": { "stiffness": stiffness, "bond_law": "exact" } },
        "body": { "line": { "length": 1.0, "cells": 200_000 } },
        "supports": supports,
        "loads": [{ "distributed": { "force": { "uniform": 1.0 } } }],
        "probes": [
            { "name": "middle", "field": "w", "at": { "x": 0.5 } },
            { "name": "end", "field": "w", "at": { "x": 1.0 } },
            { "name": "slope", "field": "phi", "at": { "x": 0.8 } }
        ]
    });
    peristat::solve_text(&format!("{case:#}")).expect("a case that can be solved").summary
}

/// Compares displacement form, by both factors, with strain form, which loses nothing in rounding.
fn agrees(supports: &Value, most: usize) {
    let exact = solved(supports, "strain");
    let size = exact.probes.iter().map(|p| p.value.abs()).fold(0.0, f64::max);
    for solver in ["band", "sparse"] {
        let found = solved(supports, solver);
        for (probe, exact) in found.probes.iter().zip(&exact.probes) {
            let off = (probe.value - exact.value).abs() / size;
            assert!(off < 1e-12, "{solver} {}: {off:e}", probe.name);
        }
        let iterations = found.solver.iterations[0];
        assert!(iterations <= most, "{solver}: {iterations} iterations");
        assert!(found.states[0].certificate.digits >= 11, "{solver}: {:?}", found.states[0].certificate);
    }
}

// Beside each limit: iterations today, and without the soft motions.

#[test]
fn a_cantilever_takes_as_many_iterations_as_a_short_one() {
    agrees(&json!([{ "at": { "x": 0 }, "w": 0, "phi": 0 }]), 5); // 3, 30
}

#[test]
fn so_does_a_beam_on_springs() {
    let springs =
        json!([{ "at": { "x": 0 }, "w_spring": 1, "phi_spring": 3 }, { "at": { "x": 1 }, "w_spring": 2 }]);
    agrees(&springs, 5); // 3, 22
}

#[test]
fn supports_between_two_nodes_become_nodes() {
    agrees(&json!([{ "at": { "x": 0 }, "w": 0, "phi": 0 }, { "at": { "x": 0.703 }, "w": 0 }]), 12);
    // Prescribed motions take a second pass.
    agrees(&json!([{ "at": { "x": 0 }, "w": 0, "phi": 0.1 }, { "at": { "x": 0.703 }, "w": 0.2 }]), 12);
}

#[test]
fn ends_may_slide_or_turn() {
    agrees(&json!([{ "at": { "x": 0 }, "phi": 0 }, { "at": { "x": 1 }, "w": 0 }]), 12); // 7, 30
    let spring = json!([{ "at": { "x": 0 }, "w": 0 }, { "at": { "x": 0.35 }, "w_spring": 2 }, { "at": { "x": 1 }, "w": 0 }]);
    agrees(&spring, 18); // 13, 24 to 26
}
