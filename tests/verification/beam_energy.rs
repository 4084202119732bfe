//! The stored energy of beams, in the certificate, is that of the beam whatever its cells: loads between points store some there.

use serde_json::{Value, json};

/// The stored energy of a beam, and the integral of its energy density, which is found from section forces.
fn energies(cells: usize, stiffness: &Value, supports: &Value, loads: &Value) -> [f64; 2] {
    let case = json!({
        "title": "beam", "units": "none",
        "model": { "timoshenko_beam": { "stiffness": stiffness } },
        "body": { "line": { "length": 1.0, "cells": cells } },
        "supports": supports, "loads": loads,
        "probes": [{ "name": "integral", "of": "integral", "field": "energy_density" }]
    });
    let solved = peristat::solve_text(&format!("{case:#}")).expect("a case that can be solved");
    [solved.summary.states[0].certificate.energy, solved.summary.probes[0].value]
}

/// EI = 2, κGA = 40, EA = 7; the area 1 makes the integral of the density over the length the energy.
fn even() -> Value {
    json!({
        "bending": { "uniform": 2.0 }, "shear": { "uniform": 40.0 }, "axial": { "uniform": 7.0 }, "area": 1.0
    })
}

fn clamp() -> Value {
    json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0, "ux": 0.0 }])
}

#[test]
fn it_is_that_of_closed_forms_with_one_cell() {
    let spread = |key: &str, values: Value| json!([{ "distributed": { key: values } }]);
    let both = json!([
        { "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0, "ux": 0.0 },
        { "at": { "x": 1.0 }, "w": 0.0, "phi": 0.0, "ux": 0.0 }
    ]);
    // With M, V and N by statics; of clamped ends, whose points do not move: q² L⁵/(1440 EI) + q² L³/(24 κGA).
    let cases = [
        (clamp(), spread("force", json!({ "uniform": 3.0 })), 9.0 / 80.0 + 9.0 / 240.0),
        // V = q (1 − x²)/2 and M its integral, (2 − 3 x + x³)/6.
        (clamp(), spread("force", json!({ "linear": [0.0, 3.0] })), 9.0 * (33.0 / 5040.0 + 1.0 / 600.0)),
        (clamp(), spread("axial", json!({ "uniform": 3.0 })), 9.0 / 42.0),
        (clamp(), spread("axial", json!({ "linear": [3.0, 0.0] })), 9.0 / 280.0),
        // M = c (1 − x).
        (clamp(), spread("moment", json!({ "uniform": 3.0 })), 9.0 / 12.0),
        (both, spread("force", json!({ "uniform": 3.0 })), 9.0 / 2880.0 + 9.0 / 960.0),
    ];
    for (supports, loads, exact) in cases {
        for cells in [1, 2, 7] {
            let [found, _] = energies(cells, &even(), &supports, &loads);
            assert!((found / exact - 1.0).abs() < 1e-14, "{loads} {cells}: {found} is not {exact}");
        }
    }
}

#[test]
fn it_is_the_integral_of_the_energy_density() {
    let propped = json!([
        { "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0, "ux": 0.0 }, { "at": { "x": 1.0 }, "w": 0.0, "ux": 0.0 }
    ]);
    let tapered = json!({
        "bending": { "polynomial": [3.0, -2.0] }, "shear": { "polynomial": [50.0, -20.0] },
        "axial": { "polynomial": [9.0, -4.0] }, "area": 1.0
    });
    let mut stepped = even();
    stepped["bending"] = json!({ "table": [[0.0, 3.0], [0.43, 3.0], [0.43, 1.0], [1.0, 1.5]] });
    let mut coupled = even();
    coupled["coupling"] = json!({ "uniform": -1.5 });
    let part = json!([
        { "distributed": { "from": 0.13, "to": 0.71, "force": { "linear": [4.0, -1.0] } } },
        { "distributed": { "axial": { "linear": [1.0, 2.0] }, "moment": { "uniform": 0.7 } } }
    ]);
    let wave = json!([
        { "distributed": { "force": { "sine": { "amplitude": 3.0, "half_waves": 5 } } } },
        { "distributed": { "axial": { "sine": { "amplitude": 2.0, "half_waves": 1 } } } }
    ]);
    let formula = json!([{ "distributed": { "force": { "formula": "3 * exp(-x) * cos(4 * x)" } } }]);
    let inside = json!([
        { "point": { "at": { "x": 0.637 }, "force": 3.0, "axial": -2.0, "moment": 0.4 } },
        { "distributed": { "force": { "uniform": 1.0 } } }
    ]);
    let all = [("even", even()), ("tapered", tapered), ("stepped", stepped), ("coupled", coupled)];
    for (name, stiffness) in all {
        for loads in [&part, &wave, &formula, &inside] {
            for cells in [5, 1500] {
                let [energy, integral] = energies(cells, &stiffness, &propped, loads);
                let apart = (energy / integral - 1.0).abs();
                // 2.9e-15 is found.
                assert!(apart < 2e-14, "{name} {loads} {cells}: {energy} is not {integral}, {apart:e}");
            }
        }
    }
}
