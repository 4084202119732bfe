//! Bodies that several processes share.

use super::support::{alone, machine, root, together};
use serde_json::{Value, json};
use std::fs;

/// By 1 to 4 processes and 7: the displacements of one process to what both certificates allow, with an iteration more than with one
/// process at most.
fn agrees(case: &Value) {
    let _machine = machine();
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("case.json"), case.to_string()).unwrap();
    let expected = alone(folder.path());
    assert_eq!(expected.summary["solver"]["method"], "multigrid");
    let mut first = Vec::new();
    for processes in [1, 2, 3, 4, 7] {
        let found = together(folder.path(), processes);
        let (difference, error) = (found.difference(&expected), found.error() + expected.error());
        assert!(difference <= error, "{processes}: {difference:.1e}, allowed {error:.1e}");
        assert!(error < 1e-6, "{processes}: {error:.1e}");
        let reason = found.summary["solver"]["reason"].as_str().unwrap();
        assert!(reason.contains("shared by"), "{reason}");
        if processes == 1 {
            first = found.iterations();
        }
        let grown = found.iterations().iter().zip(&first).all(|(more, one)| *more <= one + 1);
        assert!(grown && found.iterations().len() == first.len(), "{:?} {first:?}", found.iterations());
        assert_eq!(found.summary["states"].as_array().unwrap().len(), first.len());
        same_reactions(&found.summary, &expected.summary, processes);
    }
}

/// Reactions agree to what is left of loads of newtons and more.
fn same_reactions(found: &Value, expected: &Value, processes: usize) {
    for (found, expected) in
        found["states"].as_array().unwrap().iter().zip(expected["states"].as_array().unwrap())
    {
        let largest = expected["reactions"].as_array().unwrap().iter().flat_map(numbers).fold(1.0, f64::max);
        let pairs =
            found["reactions"].as_array().unwrap().iter().zip(expected["reactions"].as_array().unwrap());
        for (found, expected) in pairs {
            for key in ["force_x", "force_y", "force_z"] {
                let [a, b] = [found, expected].map(|reaction| reaction[key].as_f64().unwrap_or(0.0));
                assert!((a - b).abs() <= 1e-7 * largest, "{processes}, {key}: {a} {b}");
            }
        }
    }
}

fn numbers(reaction: &Value) -> Vec<f64> {
    ["force_x", "force_y", "force_z"].iter().filter_map(|key| Some(reaction[key].as_f64()?.abs())).collect()
}

/// A block of odd sides with a bore and an inclined crack, on two springs besides its face; pulled, and under its weight.
fn block(model: &Value) -> Value {
    json!({
        "title": "A bored block with a crack",
        "units": "mm-N-MPa",
        "model": model,
        "body": { "block": { "size": [23, 13, 9], "spacing": 1,
            "cuts": [ { "bore": { "along": "z", "centre": [8, 6, 0], "radius": 2.6 } } ] } },
        "horizon_ratio": 2,
        "cracks": [ { "name": "inclined", "disc": { "centre": [16, 6.2, 4.4], "normal": [0.9, 0.3, 0.1], "radius": 3.3 } } ],
        "supports": [ { "at": { "region": "left" }, "ux": 0, "uy": 0, "uz": 0 } ],
        "load_cases": [
            { "name": "pull", "loads": [ { "traction": { "face": "right", "total": [1000, 100, 50] } } ] },
            { "name": "press", "loads": [ { "traction": { "face": "top", "uniform": [0, -3, 0] } } ] }
        ],
        "probes": [ { "name": "end", "at": { "region": "right" }, "field": "ux" } ]
    })
}

#[test]
fn a_cracked_block_of_bonds() {
    agrees(&block(&json!({ "bond_solid": { "youngs_modulus": 210000, "edges": "overlay" } })));
}

#[test]
fn a_cracked_block_of_families() {
    agrees(&block(
        &json!({ "state_solid": { "youngs_modulus": 210000, "poisson_ratio": 0.3, "edges": "none" } }),
    ));
}

/// A case of the gallery without checks, some of its values replaced.
fn gallery(name: &str) -> Value {
    let text = fs::read_to_string(root().join("cases").join(name)).unwrap();
    let mut case: Value = serde_json::from_str(&text).unwrap();
    case["checks"] = json!([]);
    case
}

/// Points beside a border that cuts cells move as those inside do.
#[test]
fn a_plate_with_a_hole_that_cuts_cells() {
    agrees(&gallery("plate/plate_with_hole_off_lines.json"));
}

#[test]
fn a_bored_plate_with_planes_of_symmetry() {
    agrees(&gallery("solid/bored_plate.json"));
}
