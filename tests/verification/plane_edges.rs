//! Bodies whose bonds end on the border: held, free and loaded edges of plates of central bonds, by default.

use peristat::summary::Summary;
use serde_json::{Value, json};

fn solve(case: &Value) -> Summary {
    let solved = peristat::solve_text(&case.to_string()).unwrap_or_else(|error| panic!("{error:?}"));
    assert!(solved.summary.states[0].certificate.converged);
    solved.summary
}

fn values(case: &Value) -> Vec<f64> {
    solve(case).probes.iter().map(|probe| probe.value).collect()
}

fn plate(body: Value) -> Value {
    json!({
        "title": "plate", "units": "mm-N-MPa",
        "model": { "bond_plane": { "youngs_modulus": 7e4, "state": "plane_stress" } },
        "body": body
    })
}

fn probe(x: f64, y: f64, field: &str) -> Value {
    json!({ "name": format!("{field} at {x}, {y}"), "at": { "x": x, "y": y }, "field": field })
}

/// One side held on its line, the other moved by a hundredth of the length, free to contract: a stress of 700 everywhere.
#[test]
fn a_strip_between_held_edges_has_one_stress() {
    for m in [2.0, 3.0, 4.0, 5.0] {
        let mut case = plate(json!({ "rectangle": { "size": [40, 20], "spacing": 1 } }));
        case["horizon_ratio"] = json!(m);
        case["supports"] = json!([ { "at": { "region": "left" }, "ux": 0 }, { "at": { "x": 0.5, "y": 2.5 }, "uy": 0 },
            { "at": { "region": "right" }, "ux": 0.4 } ]);
        let force = json!({ "name": "F", "at": { "region": "right" }, "field": "reaction_x" });
        let places = [(0.5, 0.5), (39.5, 19.5), (20.5, 0.5), (20.5, 10.5)];
        let stresses = places.map(|(x, y)| probe(x, y, "stress_xx"));
        case["probes"] = json!([[force].to_vec(), stresses.to_vec()].concat());
        let found = values(&case);
        // 3e-14 and less is found.
        assert!((found[0] / 14e3 - 1.0).abs() < 1e-12, "{m}: {}", found[0]);
        found[1..].iter().for_each(|s| assert!((s / 700.0 - 1.0).abs() < 1e-12, "{m}: {s}"));
    }
}

/// A re-entrant corner has no singular stress where the tractions of a uniform one act on all edges, shear among them.
#[test]
fn an_angle_under_uniform_stress_and_shear_is_exact() {
    let vertices = [[0, 0], [20, 0], [20, 8], [9, 8], [9, 16], [0, 16]];
    let normals = [[0, -1], [1, 0], [0, 1], [1, 0], [0, 1], [-1, 0]];
    let stress = [300.0, -120.0, 80.0];
    let load = |(k, [x, y]): (usize, [i32; 2])| {
        let [x, y] = [f64::from(x), f64::from(y)];
        let t = [stress[0] * x + stress[2] * y, stress[2] * x + stress[1] * y];
        json!({ "traction": { "edge": format!("edge_{}", k + 1), "uniform": t } })
    };
    for m in [2.0, 3.0, 4.0] {
        let mut case = plate(json!({ "outline": { "vertices": vertices, "spacing": 1 } }));
        case["horizon_ratio"] = json!(m);
        case["loads"] = (0..).zip(normals).map(load).collect();
        case["supports"] = json!([ { "at": { "x": 0.5, "y": 0.5 }, "ux": 0, "uy": 0 }, { "at": { "x": 19.5, "y": 0.5 }, "uy": 0 } ]);
        let places = [(8.5, 7.5), (9.5, 7.5), (8.5, 8.5), (0.5, 15.5), (19.5, 7.5)];
        let fields = ["stress_xx", "stress_yy", "stress_xy"];
        case["probes"] = places.iter().flat_map(|&(x, y)| fields.map(|field| probe(x, y, field))).collect();
        for found in values(&case).chunks(3) {
            // 3e-13 and less is found.
            (0..3).for_each(|k| assert!((found[k] - stress[k]).abs() < 1e-11 * 300.0, "{m}: {found:?}"));
        }
    }
}

/// Half of a plate beside its line of symmetry, under a load on its top: the halves are those of the whole.
#[test]
fn tractions_beside_a_mirror_are_those_of_the_whole_body() {
    let mut whole = plate(json!({ "rectangle": { "from": [-20, 0], "size": [40, 12], "spacing": 1 } }));
    whole["supports"] = json!([ { "at": { "region": "left" }, "ux": 0, "uy": 0 }, { "at": { "region": "right" }, "ux": 0, "uy": 0 } ]);
    whole["probes"] = json!([probe(0.5, 6.5, "uy"), probe(10.5, 11.5, "ux"), probe(10.5, 0.5, "stress_xx")]);
    let mut half = whole.clone();
    half["body"] = json!({ "rectangle": { "from": [0, 0], "size": [20, 12], "spacing": 1 } });
    half["symmetry"] = json!(["left"]);
    half["supports"] = json!([ { "at": { "region": "right" }, "ux": 0, "uy": 0 } ]);
    whole["loads"] = json!([ { "traction": { "edge": "top", "uniform": [0, -3] } } ]);
    half["loads"] = json!([ { "traction": { "edge": "top", "uniform": [0, -3] } } ]);
    for (one, other) in values(&whole).iter().zip(values(&half)) {
        // 1e-13 and less is found.
        assert!((one / other - 1.0).abs() < 1e-11, "{one} {other}");
    }
}

/// A shear on an edge that meets the line turns its sign there: what acts on the line itself acts on nothing.
#[test]
fn shear_beside_a_mirror_is_that_of_the_whole_body() {
    let outline = |vertices: Value| json!({ "outline": { "vertices": vertices, "spacing": 1 } });
    let mut whole = plate(outline(json!([[-8, 0], [8, 0], [8, 8], [0, 8], [-8, 8]])));
    whole["regions"] = json!({ "low": { "box": { "from": [-8, 0], "to": [8, 1] } } });
    whole["supports"] = json!([ { "at": { "region": "low" }, "ux": 0, "uy": 0 } ]);
    whole["loads"] = json!([ { "traction": { "edge": "edge_3", "uniform": [1, 0] } },
        { "traction": { "edge": "edge_4", "uniform": [-1, 0] } } ]);
    whole["probes"] = json!([probe(0.5, 7.5, "ux"), probe(7.5, 7.5, "uy"), probe(0.5, 7.5, "stress_xy")]);
    let mut half = whole.clone();
    half["body"] = outline(json!([[0, 0], [8, 0], [8, 8], [0, 8]]));
    half["symmetry"] = json!(["left"]);
    half["loads"] = json!([ { "traction": { "edge": "edge_3", "uniform": [1, 0] } } ]);
    for (one, other) in values(&whole).iter().zip(values(&half)) {
        // 1e-14 is found; 5e-2 where the line takes nothing.
        assert!((one / other - 1.0).abs() < 1e-12, "{one} {other}");
    }
}

/// A wall of one cell, pulled across by what is the border of its images, too.
#[test]
fn a_wall_of_one_cell_beside_a_mirror_has_its_stress() {
    let mut case = plate(json!({ "rectangle": { "size": [1, 4], "spacing": 1 } }));
    case["symmetry"] = json!(["left", "bottom"]);
    case["loads"] = json!([ { "traction": { "edge": "right", "uniform": [1, 0] } } ]);
    case["probes"] = json!([probe(0.5, 2.5, "stress_xx")]);
    let solved = solve(&case);
    assert!((solved.probes[0].value - 1.0).abs() < 1e-14);
    let resultants = solved.states[0].certificate.resultants.as_ref().expect("resultants");
    assert!((resultants.applied.force_x.expect("a force") - 4.0).abs() < 1e-14);
    assert!(resultants.difference < 1e-15);
}

/// Against biquadratic finite elements, 160 x 80 and coarser, extrapolated: 0.021674.
#[test]
fn a_clamped_cantilever_is_of_second_order() {
    let error = |spacing: f64, m: f64| {
        let mut case = plate(json!({ "rectangle": { "size": [80, 40], "spacing": spacing } }));
        case["horizon_ratio"] = json!(m);
        case["supports"] = json!([ { "at": { "region": "left" }, "ux": 0, "uy": 0 } ]);
        case["loads"] = json!([ { "traction": { "edge": "right", "parabolic": [0, 1.5] } } ]);
        case["probes"] =
            json!([ { "name": "tip", "at": { "x": 80, "y": 20, "inward": [-1, 0] }, "field": "uy" } ]);
        values(&case)[0] / 0.021674 - 1.0
    };
    for (m, expected) in [(2.0, [-0.0026, -0.0007, -0.000_28]), (3.0, [0.0071, 0.002_15, 0.000_59])] {
        for (spacing, expected) in [4.0, 2.0, 1.0].into_iter().zip(expected) {
            let found = error(spacing, m);
            assert!((found - expected).abs() < 2e-5, "m = {m}, {spacing}: {found}");
        }
    }
}
