//! Weights and inertia of bodies whose materials have densities of their own, by statics.

use serde_json::{Value, json};

/// Values of the probes of a case, in their order.
fn probes(case: &Value) -> Vec<f64> {
    let summary = peristat::solve_text(&format!("{case:#}")).unwrap_or_else(|e| panic!("{e}")).summary;
    summary.probes.iter().map(|probe| probe.value).collect()
}

fn bar(loads: &Value) -> Value {
    json!({
        "title": "bar", "units": "none", "density": 2,
        "model": { "bond_plane": { "youngs_modulus": 1000, "state": "plane_stress", "thickness": 3 } },
        "body": { "rectangle": { "size": [40, 10], "spacing": 1 } },
        "regions": { "far half": { "box": { "from": [20, -1], "to": [41, 11] } },
            "end": { "box": { "from": [30, -1], "to": [41, 11] } } },
        "materials": { "heavy": { "at": "far half", "density": 7 } },
        "supports": [ { "at": { "region": "left" }, "ux": 0, "uy": 0 } ],
        "loads": loads,
        "probes": [ { "name": "x", "at": { "region": "left" }, "field": "reaction_x" },
            { "name": "y", "at": { "region": "left" }, "field": "reaction_y" } ]
    })
}

#[test]
fn weights_are_those_of_the_materials() {
    let whole = probes(&bar(&json!([ { "gravity": { "along": [0, -1], "acceleration": 0.1 } } ])));
    assert!((whole[1] / (0.1 * (2.0 + 7.0) * 600.0) - 1.0).abs() < 1e-9, "{whole:?}");
    let end = json!([ { "gravity": { "along": [0, -1], "acceleration": 0.1, "region": "end" } } ]);
    let end = probes(&bar(&end));
    assert!((end[1] / (0.1 * 7.0 * 300.0) - 1.0).abs() < 1e-9, "{end:?}");
}

#[test]
fn what_turns_pulls_by_its_mass() {
    let found = probes(&bar(&json!([ { "spin": { "omega": 0.1, "about": [0, 5] } } ])));
    // ω² ∫ ρ x dV.
    let expected = -0.01 * 30.0 * (2.0 * 200.0 + 7.0 * 600.0);
    assert!((found[0] / expected - 1.0).abs() < 1e-9, "{found:?} {expected}");
}

#[test]
fn solids_weigh_what_their_materials_do() {
    let case = json!({
        "title": "block", "units": "none", "density": 2,
        "model": { "bond_solid": { "youngs_modulus": 1000 } },
        "body": { "block": { "size": [6, 6, 12], "spacing": 1 } },
        "regions": { "top half": { "box": { "from": [-1, -1, 6], "to": [7, 7, 13] } } },
        "materials": { "heavy": { "at": "top half", "youngs_modulus": 500, "density": 5 } },
        "supports": [ { "at": { "region": "back" }, "ux": 0, "uy": 0, "uz": 0 } ],
        "loads": [ { "gravity": { "along": [0, 0, -1], "acceleration": 1 } } ],
        "probes": [ { "name": "z", "at": { "region": "back" }, "field": "reaction_z" } ]
    });
    let found = probes(&case);
    assert!((found[0] / ((2.0 + 5.0) * 216.0) - 1.0).abs() < 1e-9, "{found:?}");
}

#[test]
fn a_cut_border_weighs_by_what_its_cells_have() {
    // The region is of whole cells: its excess weight is exact, as that of the body is.
    let mut case = bar(&json!([ { "gravity": { "along": [0, -1], "acceleration": 0.1 } } ]));
    case["body"] = json!({ "outline": { "vertices": [[0, 0], [40, 3], [40, 13], [0, 10]], "spacing": 1 } });
    case["regions"]["far half"] = json!({ "disc": { "centre": [20, 6], "radius": 3 } });
    case["regions"]["end"] = case["regions"]["far half"].clone();
    case["supports"][0]["at"] = json!({ "region": "edge_4" });
    case["probes"][0]["at"] = json!({ "region": "edge_4" });
    case["probes"][1]["at"] = json!({ "region": "edge_4" });
    let [both, region] = [json!(null), json!("end")].map(|region| {
        case["loads"][0]["gravity"]["region"] = region;
        probes(&case)[1]
    });
    // Of the region 7/2 of what the base material would weigh there.
    assert!((both / (0.1 * 2.0 * 1200.0 + region * 5.0 / 7.0) - 1.0).abs() < 1e-9, "{both} {region}");
}
