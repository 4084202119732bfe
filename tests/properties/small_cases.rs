//! Small cases of every model that a user could have meant: most of them have a result.

use super::mutate::Random;
use serde_json::{Value, json};

/// A random case of one of the models, by number.
pub(crate) fn small_case(model: usize, random: &mut Random) -> Value {
    match model {
        0 => beam(random),
        1 => shell(random),
        _ => plate(model, random),
    }
}

/// Number of models that [`small_case`] knows; those of central bonds come twice, elastic and breaking.
pub(crate) const MODELS: usize = 7;

fn real(random: &mut Random, from: f64, to: f64) -> f64 {
    from + (to - from) * random.below(1 << 20) as f64 / f64::from(1 << 20)
}

fn beam(random: &mut Random) -> Value {
    let length = real(random, 0.5, 5.0);
    let middle = length * real(random, 0.2, 0.8);
    let right =
        [json!({ "at": { "x": length }, "w": 0.0 }), json!({ "at": { "x": length }, "w": 1e-3, "phi": 0.0 })];
    let mut supports = vec![json!({ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 })];
    supports.extend(random.pick(&[None, Some(&right[0]), Some(&right[1])]).cloned());
    json!({
        "title": "beam",
        "model": { "timoshenko_beam": {
            "youngs_modulus": real(random, 1e9, 3e11), "poisson_ratio": real(random, 0.0, 0.45),
            "section": { "rectangle": { "width": real(random, 0.01, 0.2), "height": real(random, 0.01, 0.3) } },
            "bond_law": random.pick(&["published", "corrected", "exact"])
        } },
        "body": { "line": { "length": length, "cells": 4 + random.below(60) } },
        "horizon_ratio": 1 + random.below(5),
        "solver": random.pick(&["auto", "strain", "band", "sparse"]),
        "supports": supports,
        "loads": [
            { "point": { "at": { "x": length }, "force": real(random, -1e4, 1e4) } },
            { "distributed": { "from": 0.0, "to": middle, "force": { "linear": [0.0, real(random, -1e3, 1e3)] } } }
        ],
        "probes": [
            { "name": "tip", "at": { "x": length }, "field": "w" },
            { "name": "moment", "at": { "x": 0.0 }, "field": "M" }
        ]
    })
}

fn shell(random: &mut Random) -> Value {
    let radius = real(random, 10.0, 200.0);
    let around = 12 + random.below(12);
    let spacing = std::f64::consts::TAU * radius / around as f64;
    let length = spacing * (6 + random.below(12)) as f64;
    json!({
        "title": "tube",
        "model": { "shell_membrane": { "youngs_modulus": 2e5, "thickness": real(random, 0.5, 5.0), "radius": radius,
            "kinematics": random.pick(&["chord", "published"]) } },
        "body": { "rectangle": { "size": [length, spacing * around as f64], "spacing": spacing } },
        "horizon_ratio": random.pick(&[2.0, 3.0, 3.5]),
        "periodic": [{ "along": "y" }],
        "solver": random.pick(&["auto", "sparse", "pcg"]),
        "supports": [
            { "at": { "region": "left" }, "ux": 0.0, "uy": 0.0, "w": 0.0 },
            { "at": { "region": "right" }, "uy": 0.0, "w": 0.0 }
        ],
        "loads": [{ "pressure": { "value": real(random, -2.0, 2.0) } }],
        "probes": [{ "name": "widening", "at": { "x": 0.5 * length, "y": 0.0 }, "field": "w" }]
    })
}

/// A rectangle that is held on its left and pulled on its right, with or without a hole and a crack.
fn plate(model: usize, random: &mut Random) -> Value {
    let cells = [6 + random.below(14), 4 + random.below(10)];
    let spacing = real(random, 0.1, 3.0);
    let [a, b] = cells.map(|n| n as f64 * spacing);
    let breaks = model == 6;
    let bond_plane = json!({ "bond_plane": {
        "youngs_modulus": real(random, 1e3, 3e5), "state": random.pick(&["plane_stress", "plane_strain"]),
        "influence": random.pick(&["constant", "inverse", "linear"])
    } });
    let young = real(random, 1e3, 3e5);
    let model = match model {
        2 | 6 => bond_plane,
        3 => json!({ "beam_bond_orthotropic": {
            "youngs_modulus_1": 20.0 * young, "youngs_modulus_2": real(random, 1.0, 3.0) * young, "poisson_ratio_12": 0.3,
            "shear_modulus_12": 1.5 * young, "fibre_angle": real(random, -90.0, 90.0)
        } }),
        4 => {
            json!({ "axisymmetric": { "youngs_modulus": young, "poisson_ratio": real(random, -0.3, 0.499) } })
        }
        _ => json!({ "state_plane": { "youngs_modulus": young, "poisson_ratio": real(random, -0.3, 0.499),
            "state": random.pick(&["plane_stress", "plane_strain"]) } }),
    };
    let mut case = json!({
        "title": "plate", "units": "mm-N-MPa", "model": model,
        "body": { "rectangle": { "from": [spacing * random.below(30) as f64, 0.0], "size": [a, b], "spacing": spacing } },
        "horizon_ratio": random.pick(&[1.5, 2.0, 3.0, 3.2]),
        "supports": [{ "at": { "region": "left" }, "ux": 0.0, "uy": 0.0 }],
        "loads": [{ "traction": { "edge": "right", "uniform": [real(random, -100.0, 100.0), real(random, -10.0, 10.0)] } }],
        "probes": [{ "name": "pull", "at": { "region": "right" }, "field": "ux" }],
        "solver": random.pick(&["auto", "sparse", "pcg", "multigrid"])
    });
    let from = case["body"]["rectangle"]["from"][0].as_f64().unwrap_or(0.0);
    if random.below(3) == 0 {
        let hole = json!({ "circle": { "centre": [from + 0.5 * a, 0.5 * b], "radius": real(random, 0.6, 2.0) * spacing } });
        case["body"]["rectangle"]["holes"] = json!([hole]);
    }
    if random.below(3) == 0 {
        let x = from + 0.6 * a;
        case["cracks"] = json!([{ "path": [[x, -spacing], [x, real(random, 0.2, 0.6) * b]] }]);
    }
    if breaks {
        case["solver"] = json!("auto");
        case["fracture"] = json!({ "critical": { "stretch": real(random, 1e-4, 1e-2) }, "load": "pull", "max_solves": 6,
            "strategy": random.pick(&["batch", "worst", "all"]) });
    }
    case
}
