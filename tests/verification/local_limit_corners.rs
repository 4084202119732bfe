//! Corners and points at which local elasticity has no smooth stress: what is refused, what is warned of, and what is left there.

use peristat::Solved;
use serde_json::{Value, json};

const MODULUS: f64 = 70_000.0;

fn case(body: &Value, supports: &Value, loads: &Value) -> Value {
    json!({
        "title": "corners", "units": "mm-N-MPa", "limit": "local",
        "model": { "bond_plane": { "youngs_modulus": MODULUS, "state": "plane_stress" } },
        "body": body, "supports": supports, "loads": loads
    })
}

fn strip(spacing: f64) -> Value {
    json!({ "rectangle": { "size": [40, 20], "spacing": spacing } })
}

fn solve(case: &Value) -> Solved {
    peristat::solve_text(&format!("{case:#}")).unwrap_or_else(|error| panic!("{error}: {case}"))
}

/// What refuses a case; nothing where it is solved.
fn refusal(case: &Value) -> String {
    peristat::solve_text(&format!("{case:#}")).err().map_or(String::new(), |error| error.to_string())
}

fn warnings(solved: &Solved) -> String {
    solved.summary.warnings.join("\n")
}

fn probe(solved: &Solved, name: &str) -> f64 {
    solved.summary.probes.iter().find(|probe| probe.name == name).map_or(f64::NAN, |probe| probe.value)
}

/// Two points that hold all rigid motions of a strip.
fn points() -> Value {
    json!([{ "at": { "x": 10.5, "y": 10.5 }, "ux": 0, "uy": 0 }, { "at": { "x": 30.5, "y": 10.5 }, "uy": 0 }])
}

#[test]
fn points_hold_loads_that_balance_and_no_others() {
    let pulled = |left: f64| {
        let side = |edge: &str, t: f64| json!({ "traction": { "edge": edge, "uniform": [t, 0] } });
        case(&strip(1.0), &points(), &json!([side("right", 100.0), side("left", left)]))
    };
    assert_eq!(refusal(&pulled(-100.0)), "");
    // What loads of four digits lack.
    assert_eq!(refusal(&pulled(-99.99)), "");
    let message = refusal(&pulled(-90.0));
    // 200 of 3800 N.
    assert!(message.contains("at (10.5, 10.5)") && message.contains("under 5.3 % of the loads"), "{message}");
}

#[test]
fn combinations_balance_as_a_whole() {
    let side = |edge: &str, t: f64| json!({ "traction": { "edge": edge, "uniform": [t, 0] } });
    let mut sum = case(&strip(1.0), &points(), &json!([]));
    let load_case = |name: &str, loads: Value| json!({ "name": name, "loads": loads });
    sum["load_cases"] = json!([
        load_case("one", json!([side("right", 10.0), side("left", -10.0)])),
        load_case("other", json!([side("right", 10.0), side("left", -9.0)]))
    ]);
    sum["combinations"] = json!([{ "name": "both", "factors": { "one": 1, "other": 1 } }]);
    let message = refusal(&sum);
    assert!(message.contains("of `other`") && !message.contains("`one`"), "{message}");
}

/// A roller that meets free edges under a pressure has σ_xx = ν σ_yy on its side of the corner and none on the other one.
#[test]
fn stresses_that_jump_are_told_with_their_place() {
    let pressed = |profile: &str| {
        let load = |edge: &str, t: f64| json!({ "traction": { "edge": edge, profile: [0, t] } });
        let mut supports = vec![json!({ "at": { "region": "bottom" }, "ux": 0 })];
        supports.extend([10.5, 30.5].map(|x| json!({ "at": { "x": x, "y": 10.5 }, "uy": 0 })));
        let loads = json!([load("top", -100.0), load("bottom", 100.0)]);
        warnings(&solve(&case(&strip(1.0), &json!(supports), &loads)))
    };
    let told = pressed("uniform");
    assert!(told.contains("stresses jump at (0, 0), by 24.2 %"), "{told}");
    assert_eq!(pressed("parabolic"), "");
}

#[test]
fn an_even_shear_jumps_at_the_ends_of_its_edge_and_a_parabolic_one_does_not() {
    let sheared = |profile: &str, shear: f64| {
        let load = |edge: &str, profile: &str, t: Value| json!({ "traction": { "edge": edge, profile: t } });
        let loads = json!([
            load("right", profile, json!([0, shear])),
            load("left", profile, json!([0, -shear])),
            load("left", "linear", json!([[-120, 0], [120, 0]]))
        ]);
        warnings(&solve(&case(&strip(1.0), &points(), &loads)))
    };
    let told = sheared("uniform", 10.0);
    assert!(told.contains("stresses jump at ("), "{told}");
    assert_eq!(sheared("parabolic", 15.0), "");
}

/// A line of symmetry takes no shear: an even one on an edge that meets it jumps there.
#[test]
fn a_shear_jumps_where_its_edge_meets_a_line_of_symmetry() {
    let sheared = |formula: &str| {
        let load = |edge: &str, t: Value| json!({ "traction": { "edge": edge, "formula": t } });
        let loads = json!([
            load("right", json!(["0", formula])),
            load("left", json!(["0", format!("-({formula})")]))
        ]);
        let mut case = case(&strip(1.0), &json!([{ "at": { "x": 20.5, "y": 10.5 }, "ux": 0 }]), &loads);
        case["symmetry"] = json!(["bottom"]);
        warnings(&solve(&case))
    };
    assert!(sheared("1-y/20").contains("stresses jump at ("));
    assert_eq!(sheared("y*(20-y)/100"), "");
}

/// An L with legs of 16, pulled at the end of one and held by a linear stress on its other side: changes of length against triangles
/// with six nodes that are graded to the corner, known to 3e-6.
#[test]
fn one_correction_does_no_harm_away_from_a_corner() {
    let ends: [([f64; 2], [f64; 2], f64); 5] = [
        ([3.0, 31.0], [29.0, 3.0], 1.58610e-2),
        ([13.0, 31.0], [29.0, 13.0], 1.72853e-2),
        ([3.0, 3.0], [13.0, 31.0], 3.66644e-2),
        ([3.0, 31.0], [3.0, 3.0], 4.15532e-2),
        ([13.0, 31.0], [29.0, 3.0], 2.21508e-2),
    ];
    let worst = |spacing: f64, limit: &str| {
        let body = json!({ "outline": {
            "vertices": [[0, 0], [32, 0], [32, 16], [16, 16], [16, 32], [0, 32]], "spacing": spacing } });
        let [near, far] = [8.0, 24.0].map(|x| x + 0.5 * spacing);
        let supports = json!([{ "at": { "x": near, "y": near }, "ux": 0, "uy": 0 }, { "at": { "x": far, "y": near }, "uy": 0 }]);
        let loads = json!([
            { "traction": { "edge": "edge_5", "uniform": [0, 100] } },
            { "traction": { "edge": "edge_1", "formula": ["0", "4.6875*x - 125"] } }]);
        let mut case = case(&body, &supports, &loads);
        case["limit"] = json!(limit);
        let place = |(k, [x, y]): (usize, [f64; 2])| {
            ["ux", "uy"].map(|u| json!({ "name": format!("{u}{k}"), "at": { "x": x, "y": y }, "field": u }))
        };
        let places = ends.iter().flat_map(|(from, to, _)| [*from, *to]).enumerate();
        case["probes"] = json!(places.flat_map(place).collect::<Vec<Value>>());
        let solved = solve(&case);
        assert_eq!(warnings(&solved).contains("one correction is all that does no harm"), limit == "local");
        let off = |(k, (from, to, expected)): (usize, &([f64; 2], [f64; 2], f64))| {
            let d = [0, 1].map(|c| to[c] - from[c]);
            let moved = |u: &str| {
                probe(&solved, &format!("{u}{}", 2 * k + 1)) - probe(&solved, &format!("{u}{}", 2 * k))
            };
            ((moved("ux") * d[0] + moved("uy") * d[1]).abs() / d[0].hypot(d[1]) - expected).abs()
        };
        ends.iter().enumerate().map(off).fold(0.0_f64, f64::max) / 4.15532e-2
    };
    for (spacing, most) in [(1.0, 1.0), (0.5, 0.8)] {
        let [before, after] = ["nonlocal", "local"].map(|limit| worst(spacing, limit));
        assert!(after < most * before, "{spacing}: {before:e}, then {after:e}");
    }
}
