//! Diagrams that a run of a beam writes.

use super::support::run;
use serde_json::json;
use std::fs;

#[test]
fn a_diagram_of_few_cells_is_the_curve_and_names_its_largest_value() {
    let folder = tempfile::tempdir().unwrap();
    let case = json!({
        "title": "three cells", "units": "mm-N-MPa",
        "model": { "timoshenko_beam": {
            "youngs_modulus": 11000, "poisson_ratio": 0.3, "section": { "rectangle": { "width": 200, "height": 24 } }
        } },
        "body": { "line": { "length": 900, "cells": 3 } },
        "supports": [{ "at": { "x": 0 }, "w": 0 }, { "at": { "x": 900 }, "w": 0 }],
        "loads": [{ "distributed": { "force": { "uniform": -0.32 } } }]
    });
    fs::write(folder.path().join("case.json"), case.to_string()).unwrap();
    let outcome = run(folder.path(), &["run", "case.json", "-o", "out", "--no-estimate"]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let moment = fs::read_to_string(folder.path().join("out/plots/moment.svg")).unwrap();
    // q L²/8 in the middle, between two points that have 28 800.
    assert!(moment.contains("32.4×10³") && !moment.contains("28.8×10³"), "{moment}");
    // A parabola, not two points of each cell.
    let longest =
        moment.split("points=\"").skip(1).map(|p| p.split('"').next().unwrap().split(' ').count()).max();
    assert!(longest > Some(48), "{longest:?}");
}
