//! Cracks act as long as they are: rows of them against their closed form, fronts of pieces, of edges and of mirrors.

use serde_json::{Value, json};
use std::f64::consts::PI;

/// Young's modulus of all bodies.
const YOUNG: f64 = 1000.0;

fn energy(case: &Value) -> f64 {
    let solved = peristat::solve_text(&case.to_string()).unwrap_or_else(|error| panic!("{error}"));
    solved.summary.states[0].certificate.energy
}

fn refusal(case: &Value) -> String {
    peristat::solve_text(&case.to_string()).err().map_or_else(String::new, |error| error.to_string())
}

/// A quarter of a cell of a row of cracks of half length `a` a distance of 2 apart, `cells` spacings per half cell, pulled across them.
/// In space it is a slice in plane strain.
fn row(model: &Value, cells: f64, horizon_ratio: f64, a: f64) -> Value {
    let h = 1.0 / cells;
    let is_solid = model.get("bond_solid").is_some() || model.get("state_solid").is_some();
    let thickness = 4.0 * h;
    let mut case = json!({
        "title": "row", "units": "none", "model": model, "horizon_ratio": horizon_ratio,
        "symmetry": ["left", "right", "bottom"], "supports": [],
        "body": { "rectangle": { "size": [1, 2], "spacing": h } },
        "loads": [ { "traction": { "edge": "top", "uniform": [0, 1] } } ]
    });
    if is_solid {
        case["body"] = json!({ "block": { "size": [1, 2, thickness], "spacing": h } });
        case["symmetry"] = json!(["left", "right", "bottom", "back", "front"]);
        case["loads"] = json!([ { "traction": { "face": "top", "uniform": [0, 1, 0] } } ]);
    }
    if a > 0.0 {
        case["cracks"] = match is_solid {
            true => json!([ { "polygon": [[0, 0, 0], [a, 0, 0], [a, 0, thickness], [0, 0, thickness]] } ]),
            false => json!([ { "path": [[0, 0], [a, 0]] } ]),
        };
    }
    case
}

/// By how many spacings a row of cracks acts longer than it is. A cell of it takes -2 σ² W² ln cos(π a/W)/(π E') more energy than without
/// them, from K = σ √(W tan(π a/W)) of an infinite sheet (Westergaard 1939).
fn excess(case: &Value, cells: f64, a: f64, modulus: f64) -> f64 {
    let mut whole = case.clone();
    whole["cracks"] = json!([]);
    let depth = case["body"]["block"]["size"][2].as_f64().unwrap_or(1.0);
    let width = 2.0;
    let more = 4.0 * (energy(case) - energy(&whole)) / depth;
    let found = width / PI * (-more * PI * modulus / (2.0 * width * width)).exp().acos();
    (found - a) * cells
}

#[test]
fn cracks_act_as_long_as_they_are() {
    let plane = |name: &str| {
        let mut model = json!({ name: { "youngs_modulus": YOUNG, "state": "plane_stress" } });
        if name == "state_plane" {
            model[name]["poisson_ratio"] = json!(0.2);
        }
        model
    };
    let solid = json!({ "bond_solid": { "youngs_modulus": YOUNG } });
    // Spacings found with horizons of 2, 3 and 4 spacings; with all bonds cut that cross.
    let rows = [
        (solid, YOUNG / (1.0 - 0.0625), [0.001, 0.011, 0.030], [0.427, 0.401, 0.469]),
        (plane("bond_plane"), YOUNG, [0.012, 0.031, 0.064], [0.432, 0.424, 0.467]),
        (plane("state_plane"), YOUNG, [-0.044, -0.050, -0.017], [0.397, 0.348, 0.433]),
    ];
    for (model, modulus, effective, crossed) in rows {
        for k in 0..3 {
            let mut case = row(&model, 16.0, 2.0 + k as f64, 0.5);
            let own = excess(&case, 16.0, 0.5, modulus);
            case["crack_fronts"] = json!("crossed");
            let published = excess(&case, 16.0, 0.5, modulus);
            assert!((own - effective[k]).abs() < 2e-3, "{model} {k}: {own}");
            assert!((published - crossed[k]).abs() < 2e-3, "{model} {k}: {published}");
        }
    }
}

/// A block of 10 × 8 × 6 cells that is pulled along y, with some cracks.
fn block(cracks: Value) -> Value {
    json!({
        "title": "block", "units": "none", "model": { "bond_solid": { "youngs_modulus": YOUNG } },
        "horizon_ratio": 3, "body": { "block": { "size": [10, 8, 6], "spacing": 1 } }, "cracks": cracks,
        "supports": [ { "at": { "region": "bottom" }, "ux": 0, "uy": 0, "uz": 0 } ],
        "loads": [ { "traction": { "face": "top", "uniform": [0, 1, 0] } } ]
    })
}

/// A rectangle across y.
fn sheet([x0, x1]: [f64; 2], [z0, z1]: [f64; 2]) -> Value {
    json!({ "polygon": [[x0, 4, z0], [x1, 4, z0], [x1, 4, z1], [x0, 4, z1]] })
}

#[test]
fn seams_and_faces_are_no_fronts() {
    let whole = energy(&block(json!([sheet([-1.0, 5.0], [-1.0, 7.0])])));
    let alike = [
        // It ends on the faces.
        json!([sheet([0.0, 5.0], [0.0, 6.0])]),
        // Two pieces side by side, and one behind the other.
        json!([sheet([-1.0, 5.0], [-1.0, 3.0]), sheet([-1.0, 5.0], [3.0, 7.0])]),
        json!([sheet([-1.0, 2.0], [-1.0, 7.0]), sheet([2.0, 5.0], [-1.0, 7.0])]),
    ];
    for cracks in alike {
        let found = energy(&block(cracks.clone()));
        assert_eq!(found.to_bits(), whole.to_bits(), "{cracks}: {found} {whole}");
    }
    let asked = |cracks: Value, fronts: &str| {
        let mut case = block(cracks);
        case["crack_fronts"] = json!(fronts);
        energy(&case)
    };
    assert_eq!(asked(json!([sheet([-1.0, 5.0], [-1.0, 7.0])]), "effective").to_bits(), whole.to_bits());
    let crossed = asked(json!([sheet([-1.0, 5.0], [-1.0, 7.0])]), "crossed");
    assert!(crossed > 1.01 * whole, "{crossed} {whole}");
    // A sheet amid the body recedes on all sides.
    let inside = json!([sheet([3.0, 7.0], [2.0, 4.0])]);
    let [own, crossed] = ["effective", "crossed"].map(|fronts| asked(inside.clone(), fronts));
    assert!(crossed > 1.001 * own, "{crossed} {own}");
}

#[test]
fn paths_in_pieces_are_one_crack() {
    let plate = |cracks: Value| {
        energy(&json!({
            "title": "plate", "units": "none", "horizon_ratio": 3,
            "model": { "bond_plane": { "youngs_modulus": YOUNG, "state": "plane_stress" } },
            "body": { "rectangle": { "size": [20, 12], "spacing": 1 } }, "cracks": cracks,
            "supports": [ { "at": { "region": "bottom" }, "ux": 0, "uy": 0 } ],
            "loads": [ { "traction": { "edge": "top", "uniform": [0, 1] } } ]
        }))
    };
    let whole = plate(json!([{ "path": [[-1, 6], [6, 6], [9, 8]] }]));
    let parts = plate(json!([{ "path": [[-1, 6], [6, 6]] }, { "path": [[9, 8], [6, 6]] }]));
    let on_edge = plate(json!([{ "path": [[0, 6], [6, 6], [9, 8]] }]));
    let by_points = plate(json!([{ "path": [[-1, 6], [5, 6], [6, 6], [8.97, 7.98], [9, 8]] }]));
    assert_eq!(parts.to_bits(), whole.to_bits());
    assert_eq!(on_edge.to_bits(), whole.to_bits());
    assert_eq!(by_points.to_bits(), whole.to_bits());
    // One that reaches a little beyond the other one ends there all the same.
    let rounded = plate(json!([{ "path": [[-1, 6], [6.0001, 6]] }, { "path": [[9, 8], [6, 6]] }]));
    assert_eq!(rounded.to_bits(), whole.to_bits());
    // A loop has no tips: it frees what it encloses, as the same with all bonds cut.
    let square = json!([[6, 3], [12, 3], [12, 9], [6, 9], [6.0, 3.000_000_000_1]]);
    let error = peristat::solve_text(
        &json!({
            "title": "plate", "units": "none", "horizon_ratio": 3,
            "model": { "bond_plane": { "youngs_modulus": YOUNG, "state": "plane_stress" } },
            "body": { "rectangle": { "size": [20, 12], "spacing": 1 } }, "cracks": [{ "path": square }],
            "supports": [ { "at": { "region": "bottom" }, "ux": 0, "uy": 0 } ],
            "loads": [ { "traction": { "edge": "top", "uniform": [0, 1] } } ]
        })
        .to_string(),
    )
    .err()
    .map_or_else(String::new, |error| error.to_string());
    assert!(error.contains("nothing holds the part of the body around (9, 6), 36 points"), "{error}");
}

#[test]
fn cracks_that_meet_a_mirror_go_on_behind_it() {
    let plate = |from: f64, cracks: Value| {
        energy(&json!({
            "title": "plate", "units": "none", "horizon_ratio": 3,
            "model": { "bond_plane": { "youngs_modulus": YOUNG, "state": "plane_stress" } },
            "symmetry": if from < 0.0 { json!([]) } else { json!(["left"]) },
            "body": { "rectangle": { "from": [from, 0], "size": [12.0 - from, 14], "spacing": 1 } },
            "cracks": cracks, "supports": [ { "at": { "region": "bottom" }, "ux": 0, "uy": 0 } ],
            "loads": [ { "traction": { "edge": "top", "uniform": [0, 1] } } ]
        }))
    };
    for (half, whole) in [
        (json!([[0, 6], [5, 6]]), json!([[-5, 6], [5, 6]])),
        (json!([[0, 6], [2, 11]]), json!([[-2, 11], [0, 6], [2, 11]])),
        (json!([[0, 6], [6, 8.3]]), json!([[-6, 8.3], [0, 6], [6, 8.3]])),
        (json!([[-5, 6], [5, 6]]), json!([[-5, 6], [5, 6]])),
    ] {
        let [part, all] =
            [(0.0, &half), (-12.0, &whole)].map(|(from, path)| plate(from, json!([{ "path": path }])));
        // 1e-13 found.
        assert!((2.0 * part / all - 1.0).abs() < 1e-12, "{half}: {part} {all}");
    }
}

#[test]
fn cracks_that_come_back_from_a_mirror_are_refused() {
    let model = json!({ "bond_plane": { "youngs_modulus": YOUNG, "state": "plane_stress" } });
    let mut case = row(&model, 16.0, 2.0, 0.5);
    case["cracks"][0]["path"] = json!([[-1, 0], [0.5, 0]]);
    let found = refusal(&case);
    assert!(
        found.contains("the crack `1` reaches beyond a mirror, so that its image cuts the body"),
        "{found}"
    );
    // One that is its own image may go on behind the mirror.
    case["cracks"][0]["path"] = json!([[-0.5, 0], [0.5, 0]]);
    let own = energy(&case);
    assert_eq!(own.to_bits(), energy(&row(&model, 16.0, 2.0, 0.5)).to_bits());
    let mut solid = row(&json!({ "bond_solid": { "youngs_modulus": YOUNG } }), 8.0, 2.0, 0.5);
    solid["cracks"][0]["polygon"][0][0] = json!(-1);
    solid["cracks"][0]["polygon"][3][0] = json!(-1);
    assert!(refusal(&solid).contains("reaches beyond a mirror"));
}
