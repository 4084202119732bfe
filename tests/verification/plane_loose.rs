//! Bodies that are not held, or fall apart, are named before anything is factored.

use crate::support::plane::refusal;
use serde_json::{Value, json};

fn plate() -> Value {
    json!({
        "title": "plate",
        "model": { "bond_plane": { "youngs_modulus": 7e10, "state": "plane_stress" } },
        "body": { "rectangle": { "size": [20, 10], "spacing": 1 } },
        "supports": [{ "at": { "region": "left" }, "ux": 0, "uy": 0 }],
        "loads": [{ "traction": { "edge": "top", "uniform": [0, -1e3] } }]
    })
}

fn check(case: &Value, words: &[&str]) {
    for solver in ["auto", "sparse", "multigrid", "pcg"] {
        let mut case = case.clone();
        case["solver"] = json!(solver);
        let said = refusal(&case);
        assert!(words.iter().all(|w| said.contains(w)), "{solver}: {said}");
    }
}

#[test]
fn a_body_without_supports_is_named_with_its_motions() {
    let mut case = plate();
    case["supports"] = json!([]);
    check(&case, &["nothing holds the body"]);
    case["supports"] = json!([{ "at": { "region": "left" }, "ux": 0 }]);
    check(&case, &["free", "along y"]);
    case["supports"] = json!([{ "at": { "x": 10.5, "y": 5.5 }, "ux": 0, "uy": 0 }]);
    check(&case, &["free to turn about (10.5, 5.5)"]);
}

#[test]
fn a_crack_through_the_body_leaves_a_loose_half() {
    let mut case = plate();
    case["cracks"] = json!([{ "path": [[12, -1], [12, 11]] }]);
    check(&case, &["nothing holds", "(16"]);
    // With a ligament it is one body, and with springs on both parts it stands.
    case["cracks"] = json!([{ "path": [[12, -1], [12, 7]] }]);
    assert!(peristat::solve_text(&case.to_string()).is_ok());
    case["cracks"] = json!([{ "path": [[12, -1], [12, 11]] }]);
    let springs = json!({ "at": { "region": "right" }, "ux_spring": 1e9, "uy_spring": 1e9 });
    case["supports"] = json!([case["supports"][0], springs]);
    assert!(peristat::solve_text(&case.to_string()).is_ok());
}

#[test]
fn parts_of_an_outline_that_do_not_touch_are_named() {
    // A slot cuts the plate from edge to edge.
    let mut case = plate();
    case["body"]["rectangle"]["holes"] =
        json!([{ "polygon": { "vertices": [[8, -1], [13, -1], [13, 11], [8, 11]] } }]);
    case["loads"] = json!([{ "point": { "at": { "region": "right" }, "force_y": -1e3 } }]);
    check(&case, &["hole 1 parts the body", "(16.5, 5)"]);
}

#[test]
fn a_point_on_one_bond_is_named() {
    // A finger of one row, cut off but for its neighbours along x.
    let mut case = plate();
    case["horizon_ratio"] = json!(1.5);
    case["model"]["bond_plane"]["calibration"] = json!("published");
    case["model"]["bond_plane"]["volume_factor"] = json!("full");
    case["cracks"] = json!([{ "path": [[18.0, 8.5], [19.0, 9.0], [20.5, 9.0]] }]);
    let said = refusal(&case);
    assert!(said.contains("(19.5, 9.5)") && said.contains("one line"), "{said}");
}

#[test]
fn a_ligament_of_one_row_is_a_hinge() {
    // Bonds along one row turn freely; what completes the border holds the part behind it.
    let case = |edges: &str, force: Value| {
        json!({
            "title": "ligament", "units": "mm-N-MPa",
            "model": { "bond_plane": { "youngs_modulus": 7e4, "state": "plane_stress", "edges": edges } },
            "horizon_ratio": 1.5,
            "body": { "outline": { "spacing": 1, "vertices": [
                [0, 0], [10, 0], [10, 4], [12, 4], [12, 0], [20, 0], [20, 9], [12, 9], [12, 5], [10, 5], [10, 9], [0, 9]
            ] } },
            "supports": [{ "at": { "region": "edge_12" }, "ux": 0, "uy": 0 }],
            "loads": [{ "traction": { "edge": "edge_6", "uniform": force } }]
        })
    };
    for edges in ["none", "energy", "volume"] {
        let error = peristat::solve_text(&case(edges, json!([0, 1])).to_string()).expect_err("a mechanism");
        assert!(error.to_string().contains("the body has a mechanism"), "{edges}: {error}");
    }
    let held = peristat::solve_text(&case("border", json!([0, 1])).to_string()).expect("a body that is held");
    assert!(held.summary.states[0].certificate.converged);
}
