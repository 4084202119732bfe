//! Loads and motions by formulas of the load factor: every step is the case with its number in their place.

use crate::support::plane::refusal;
use peristat::input::Folder;
use serde_json::{Value, json};
use std::path::Path;

const FACTORS: [f64; 3] = [0.5, -1.0, 2.0];

fn solved(case: &Value) -> peristat::Solved {
    peristat::solve_text(&format!("{case:#}")).unwrap_or_else(|error| panic!("{error}: {case}"))
}

/// The case of one step: the number for the load factor in formulas, and what is `proportional` times it.
fn of_step(case: &Value, factor: f64, proportional: &[&str]) -> Value {
    let text = case.to_string().replace("load_factor", &format!("({factor})"));
    let mut own: Value = serde_json::from_str(&text).expect("a case");
    for pointer in proportional {
        let value = own.pointer_mut(pointer).unwrap_or_else(|| panic!("nothing at {pointer}"));
        *value = match &*value {
            Value::String(formula) => json!(format!("({factor})*({formula})")),
            number => json!(factor * number.as_f64().expect("a number")),
        };
    }
    own
}

/// Largest difference of values, of the largest of them.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    let size = b.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / size
}

/// Fields and probes of every step against those of its own case; what is at `proportional` grows with the load factor.
fn assert_steps(case: &Value, proportional: &[&str], fields: &[&str]) {
    let mut stepped = case.clone();
    stepped["steps"] = json!({ "load_factors": FACTORS });
    let all = solved(&stepped);
    let probes = all.summary.probes.len() / FACTORS.len();
    for (k, factor) in FACTORS.into_iter().enumerate() {
        let own = solved(&of_step(case, factor, proportional));
        for field in fields {
            let [a, b] = [all.field(k, field), own.field(0, field)].map(|values| values.expect("a field"));
            let found = apart(&a, &b);
            // 1e-13 found by factors, 1e-11 by cycles.
            assert!(found <= 1e-9, "{field} at {factor}: {found:e}: {case}");
        }
        let read = |run: &peristat::Solved, from: usize| -> Vec<f64> {
            run.summary.probes[from..from + probes].iter().map(|probe| probe.value).collect()
        };
        let found = apart(&read(&all, probes * k), &read(&own, 0));
        assert!(found <= 1e-9, "probes at {factor}: {found:e}: {case}");
    }
}

/// A plate with a traction, a weight and a temperature by formulas, and a force that grows in proportion.
fn plate() -> Value {
    json!({
        "title": "steps", "units": "none",
        "model": { "bond_plane": { "youngs_modulus": 1000, "state": "plane_stress" } },
        "body": { "rectangle": { "size": [24, 16], "spacing": 1 } },
        "thermal_expansion": 1e-3,
        "supports": [{ "at": { "region": "left" }, "ux": "1e-3*(load_factor + 2)^2*(1 + y/16)", "uy": 0.02 }],
        "loads": [
            { "traction": { "edge": "right", "formula": ["load_factor^3 + y/16", "2"] } },
            { "point": { "at": { "x": 12.5, "y": 8.5 }, "force_y": 3 } },
            { "traction": { "edge": "top", "pressure": "3 - load_factor" } },
            { "body_force": { "density": ["0", "0.01*exp(load_factor)"] } },
            { "temperature": { "change": "load_factor^3*x" } }
        ],
        "probes": [{ "name": "pull", "at": { "region": "left" }, "field": "reaction_x" }]
    })
}

#[test]
fn loads_and_motions_of_plates_follow_formulas_of_the_load_factor() {
    let proportional = ["/supports/0/uy", "/loads/1/point/force_y"];
    for solver in ["sparse", "multigrid"] {
        let mut case = plate();
        case["solver"] = json!(solver);
        assert_steps(&case, &proportional, &["ux", "uy", "stress_xx", "temperature"]);
    }
    let mut families = plate();
    families["model"] =
        json!({ "state_plane": { "youngs_modulus": 1000, "poisson_ratio": 0.3, "state": "plane_stress" } });
    assert_steps(&families, &proportional, &["ux", "stress_xx"]);
}

#[test]
fn rigid_regions_of_plates_and_solids_follow_formulas_of_the_load_factor() {
    let mut case = plate();
    case["loads"] = json!([{ "point": { "at": { "x": 12.5, "y": 8.5 }, "force_y": 3 } }]);
    case["regions"] = json!({ "grip": { "box": { "from": [20, 0], "to": [24, 16] } } });
    case["rigid"] =
        json!([{ "region": "grip", "ux": "0.1*sin(load_factor)", "uy": 0.05, "phi": "0.01*load_factor^2" }]);
    let proportional = ["/supports/0/uy", "/loads/0/point/force_y", "/rigid/0/uy"];
    assert_steps(&case, &proportional, &["ux", "uy", "stress_xy"]);
    let mut solid = json!({
        "title": "steps", "units": "none",
        "model": { "bond_solid": { "youngs_modulus": 1000 } },
        "body": { "block": { "size": [12, 6, 6], "spacing": 1 } },
        "supports": [{ "at": { "region": "left" }, "ux": "0.01*load_factor^2*z", "uy": 0, "uz": 0 }],
        "regions": { "grip": { "box": { "from": [9, 0, 0], "to": [12, 6, 6] } } },
        "rigid": [{ "region": "grip", "ux": 0.1, "uy": 0, "uz": "0.1*load_factor^2",
                    "phi_x": "0.01*(1 + load_factor)", "phi_y": 0, "phi_z": 0 }],
        "probes": [{ "name": "pull", "at": { "region": "left" }, "field": "reaction_z" }]
    });
    for solver in ["sparse", "multigrid"] {
        solid["solver"] = json!(solver);
        assert_steps(&solid, &["/rigid/0/ux"], &["ux", "uz", "stress_xz"]);
    }
}

#[test]
fn loads_of_beams_and_of_plates_in_bending_follow_formulas_of_the_load_factor() {
    let beam = json!({
        "title": "steps", "units": "none",
        "model": { "timoshenko_beam": { "youngs_modulus": 1000, "poisson_ratio": 0.3,
                   "section": { "rectangle": { "width": 1, "height": 1 } } } },
        "body": { "line": { "length": 10, "cells": 40 } },
        "supports": [{ "at": { "x": 0 }, "w": 0, "phi": 0 }],
        "loads": [
            { "distributed": { "force": { "formula": "load_factor^2*x" } } },
            { "point": { "at": { "x": 10 }, "force": 2 } }
        ],
        "probes": [{ "name": "tip", "at": { "x": 10 }, "field": "w" }]
    });
    assert_steps(&beam, &["/loads/1/point/force"], &[]);
    let bent = json!({
        "title": "steps", "units": "none",
        "model": { "plate_bending": { "youngs_modulus": 1000, "poisson_ratio": 0.3, "thickness": 1 } },
        "body": { "rectangle": { "size": [16, 16], "spacing": 1 } },
        "supports": [{ "at": { "region": "left" }, "w": 0.1, "phi_n": 0 }, { "at": { "region": "right" }, "w": 0 }],
        "loads": [
            { "pressure": { "formula": "load_factor^2*x/16" } },
            { "line": { "edge": "top", "force": "1 - load_factor" } },
            { "pressure": { "value": 0.5 } }
        ],
        "probes": [{ "name": "middle", "at": { "x": 8, "y": 8 }, "field": "w" }]
    });
    assert_steps(&bent, &["/supports/0/w", "/loads/2/pressure/value"], &["w", "M_xx"]);
}

/// What a program with a solver of its own is given: the displacements of every step solve its equations.
#[test]
fn operators_know_the_motions_of_every_step() {
    let mut case = plate();
    case["steps"] = json!({ "load_factors": FACTORS });
    let source =
        peristat::case::from_text("case", format!("{case:#}"), &[], &Folder::default()).expect("a case");
    let loaded = peristat::Loaded::from_source(source, Path::new(".").into(), None).expect("a scene");
    let operator = peristat::Operator::new(&loaded, None).expect("no contradiction");
    let run = solved(&case);
    for state in 0..FACTORS.len() {
        let moved = ["ux", "uy"].map(|name| run.field(state, name).expect("a field").into_owned());
        let q: Vec<f64> = operator.unknowns().iter().map(|&(point, c)| moved[c][point]).collect();
        let mut force = vec![0.0; q.len()];
        operator.product(&q, &mut force);
        assert!(apart(&force, operator.right_hand_side(state)) < 1e-9);
        let all: Vec<f64> = moved[0].iter().zip(&moved[1]).flat_map(|(x, y)| [*x, *y]).collect();
        assert!(apart(&operator.expand(&q, state), &all) < 1e-9);
    }
}

#[test]
fn what_does_not_follow_steps_is_refused() {
    let why = "is known to loads, and to motions of bodies and plates, that `steps` follow";
    assert!(refusal(&plate()).contains(why), "{}", refusal(&plate()));
    let mut cases = plate();
    cases["load_cases"] = json!([{ "name": "a", "loads": cases["loads"] }]);
    cases["loads"] = json!([]);
    assert!(refusal(&cases).contains(why), "{}", refusal(&cases));
    let mut breaking = plate();
    breaking["loads"] = json!([]);
    breaking["fracture"] = json!({ "critical": { "stretch": 0.01 }, "load": "pull" });
    assert!(refusal(&breaking).contains(why), "{}", refusal(&breaking));
    // A corner whose edges agree in the last step alone.
    let mut apart = plate();
    apart["steps"] = json!({ "load_factors": FACTORS });
    apart["supports"]
        .as_array_mut()
        .expect("a list")
        .push(json!({ "at": { "region": "bottom" }, "ux": "8e-3*load_factor" }));
    assert!(refusal(&apart).contains("contradicts"), "{}", refusal(&apart));
}

/// What acts in some steps only is nothing in others.
#[test]
fn loads_may_be_zero_in_a_step() {
    let mut case = plate();
    case["supports"][0]["ux"] = json!(0);
    case["loads"] = json!([
        { "traction": { "edge": "right", "formula": ["max(0, load_factor)", 0] } },
        { "traction": { "edge": "top", "pressure": "max(0, load_factor)" } },
        { "body_force": { "density": ["max(0, load_factor)", 0] } },
        { "temperature": { "change": "max(0, load_factor)" } }
    ]);
    case["supports"][0]["uy"] = json!(0);
    case["steps"] = json!({ "load_factors": [-1, 1] });
    let run = solved(&case);
    let most = |state: usize| {
        let moved = run.field(state, "ux").expect("a field");
        moved.iter().fold(0.0, |most: f64, u| most.max(u.abs()))
    };
    assert!(most(0) == 0.0 && most(1) > 1e-3, "{} {}", most(0), most(1));
}

/// Fields around a hole know what acts in every step, though none of it acts on the hole.
#[test]
fn stresses_on_holes_follow_steps() {
    let mut case = plate();
    case["body"] = json!({ "rectangle": { "from": [-20, -20], "size": [40, 40], "spacing": 1,
        "holes": [{ "circle": { "name": "hole", "centre": [0, 0], "radius": 4 } }] } });
    case["supports"] =
        json!([{ "at": { "region": "left" }, "ux": 0 }, { "at": { "x": -19.5, "y": 0.5 }, "uy": 0 }]);
    case["loads"] = json!([{ "traction": { "edge": "right", "formula": ["1 + load_factor^2", 0] } }]);
    case["probes"] = json!([{ "name": "peak", "at": { "x": 0, "y": 4 }, "field": "stress_xx" }]);
    assert_steps(&case, &[], &["stress_xx"]);
}
