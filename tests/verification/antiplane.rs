//! Plates in antiplane shear, from cases.

use serde_json::{Value, json};

fn solved(case: &Value) -> peristat::Solved {
    peristat::solve_text(&case.to_string()).unwrap_or_else(|error| panic!("{error}"))
}

fn refusal(case: &Value) -> String {
    peristat::solve_text(&case.to_string()).err().map(|error| error.to_string()).unwrap_or_default()
}

fn plate(model: Value) -> Value {
    json!({
        "title": "sheared", "units": "none", "model": { "bond_antiplane": model },
        "body": { "rectangle": { "size": [14.0, 9.0], "spacing": 1.0 } },
        "supports": [{ "at": { "region": "bottom" }, "w": 0.0 }],
        "loads": [{ "traction": { "edge": "top", "uniform": [0.0, 0.0, 3.0] } }],
    })
}

/// Largest difference of the stress at any point from one stress.
fn off_stress(found: &peristat::Solved, expected: [f64; 2]) -> f64 {
    let of = |name: &str, expected: f64| {
        let values = found.field(0, name).expect("a field");
        values.iter().map(|s| (s - expected).abs()).fold(0.0, f64::max)
    };
    of("stress_xz", expected[0]).max(of("stress_yz", expected[1]))
}

#[test]
fn one_shear_is_exact_at_free_held_and_loaded_edges() {
    for influence in ["constant", "inverse", "linear"] {
        for ratio in [1.5, 2.0, 3.0, 4.2] {
            let mut case = plate(json!({ "shear_modulus": 7.0, "thickness": 0.4, "influence": influence }));
            case["horizon_ratio"] = json!(ratio);
            let found = solved(&case);
            let off = off_stress(&found, [0.0, 3.0]);
            assert!(off < 1e-12, "{influence} {ratio}: {off}");
            let w = found.field(0, "w").expect("a field");
            let moved = w.iter().zip(found.points()).map(|(w, at)| (w - 3.0 / 7.0 * at[1]).abs());
            let worst = moved.fold(0.0, f64::max);
            assert!(worst < 1e-12, "{influence} {ratio}: {worst}");
        }
    }
}

#[test]
fn loads_act_as_asked_and_supports_hold_them() {
    let mut case = plate(json!({ "shear_modulus": 7.0 }));
    case["regions"] = json!({ "middle": { "box": { "from": [4.0, 3.0], "to": [8.0, 6.0] } } });
    case["loads"] = json!([
        { "traction": { "edge": "top", "linear": [[0.0, 0.0, 1.0], [0.0, 0.0, 3.0]] } },
        { "traction": { "edge": "right", "parabolic": [0.0, 0.0, 6.0] } },
        { "body_force": { "density": [0.0, 0.0, 0.5] } },
        { "body_force": { "region": "middle", "total": [0.0, 0.0, -2.0] } },
        { "point": { "at": { "x": 7.5, "y": 4.5 }, "force": 1.5 } },
    ]);
    let found = solved(&case);
    let resultants = found.summary.states[0].certificate.resultants.clone().expect("resultants");
    // 14·2 + 9·6·2/3 + 126·0.5 − 2 + 1.5, by statics.
    let expected = 28.0 + 36.0 + 63.0 - 0.5;
    for (total, sign) in [(&resultants.asked, 1.0), (&resultants.applied, 1.0), (&resultants.reactions, -1.0)]
    {
        assert_eq!((total.forces()[0], total.forces()[1], total.moments()), (None, None, [None; 3]));
        let force = total.forces()[2].expect("a force");
        assert!((sign * force - expected).abs() < 1e-12 * expected, "{force}");
    }
}

#[test]
fn half_of_a_plate_beside_a_mirror_is_the_whole() {
    let model = json!({ "shear_modulus": 7.0 });
    let mut half = plate(model.clone());
    half["symmetry"] = json!(["left"]);
    half["loads"] = json!([{ "traction": { "edge": "right", "uniform": [0.0, 0.0, 2.0] } }]);
    let mut whole = plate(model);
    whole["body"]["rectangle"] = json!({ "from": [-14.0, 0.0], "size": [28.0, 9.0], "spacing": 1.0 });
    whole["loads"] = json!([
        { "traction": { "edge": "right", "uniform": [0.0, 0.0, 2.0] } },
        { "traction": { "edge": "left", "uniform": [0.0, 0.0, 2.0] } },
    ]);
    let [half, whole] = [half, whole].map(|case| solved(&case));
    for name in ["w", "stress_xz", "stress_yz"] {
        let (a, b) = (half.field(0, name).expect("a field"), whole.field(0, name).expect("a field"));
        let places = whole.points();
        let size = b.iter().fold(0.0, |size: f64, v| size.max(v.abs()));
        for (value, at) in a.iter().zip(half.points()) {
            let k = places.iter().position(|p| *p == at).expect("the point is in the whole");
            // 3e-14 measured.
            assert!((value - b[k]).abs() < 1e-12 * size, "{name} at {at:?}: {value} {}", b[k]);
        }
    }
}

#[test]
fn vectors_need_three_numbers_and_act_across_alone() {
    let with = |uniform: Value| {
        let mut case = plate(json!({ "shear_modulus": 7.0 }));
        case["loads"][0]["traction"]["uniform"] = uniform;
        refusal(&case)
    };
    assert!(
        with(json!([0.0, 3.0]))
            .contains("`uniform` has 2 numbers, and forces across the plane have 3, along x, y and z")
    );
    assert!(with(json!([1.0, 0.0, 3.0])).contains("points of this body do not move along x"));
    let mut flat = plate(json!({}));
    flat["model"] = json!({ "bond_plane": { "youngs_modulus": 1.0, "state": "plane_stress" } });
    flat["supports"] = json!([{ "at": { "region": "bottom" }, "ux": 0.0, "uy": 0.0 }]);
    assert!(
        refusal(&flat).contains("`uniform` has 3 numbers, and forces in the plane have 2, along x and y")
    );
}

#[test]
fn what_does_not_hold_a_plate_across_is_refused() {
    let mut case = plate(json!({ "shear_modulus": 7.0 }));
    case["supports"][0]["ux"] = json!(0.0);
    assert!(refusal(&case).contains("points move across the plane alone, and `ux` does not hold that"));
    case["supports"] = json!([]);
    assert!(refusal(&case).contains("nothing holds the body"));
    case["supports"] = json!([{ "at": { "region": "bottom" }, "w": 0.0 }]);
    case["cracks"] = json!([{ "path": [[-1.0, 4.0], [15.0, 4.0]] }]);
    assert!(
        refusal(&case).contains("nothing holds the part of the body around (7, 6.5)"),
        "{}",
        refusal(&case)
    );
}
