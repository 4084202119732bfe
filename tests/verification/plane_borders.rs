//! Borders, mirrors and tips of bodies in the plane: what must be symmetric is, what has no meaning is refused.

use peristat::Solved;
use serde_json::{Value, json};

fn solved(case: &Value) -> Solved {
    peristat::solve_text(&case.to_string()).unwrap_or_else(|error| panic!("{error:?}"))
}

/// Values of the probes, in the order of the case.
fn probes(case: &Value) -> Vec<f64> {
    solved(case).summary.probes.iter().map(|p| p.value).collect()
}

/// The message of a case that is refused.
fn refusal(case: &Value) -> String {
    match peristat::solve_text(&case.to_string()) {
        Err(peristat::Error::Case(report)) => report.render(false),
        other => panic!("{:?} is not refused", other.map(|s| s.summary.probes)),
    }
}

fn plate(rectangle: Value, more: Value) -> Value {
    let mut case = json!({
        "title": "plate", "units": "mm-N-MPa",
        "model": { "bond_plane": { "youngs_modulus": 7e4, "state": "plane_stress" } },
        "body": { "rectangle": rectangle }
    });
    for (key, value) in more.as_object().expect("keys of a case") {
        case[key] = value.clone();
    }
    case
}

fn probe(x: f64, y: f64, field: &str) -> Value {
    json!({ "name": format!("{field} {x} {y}"), "at": { "x": x, "y": y }, "field": field })
}

fn traction(edge: &str, key: &str, value: Value) -> Value {
    let mut load = json!({ "edge": edge });
    load[key] = value;
    json!({ "traction": load })
}

fn hole(centre: [f64; 2], radius: f64) -> Value {
    json!([{ "circle": { "name": "h", "centre": centre, "radius": radius } }])
}

#[test]
fn pressure_in_a_hole_has_the_symmetry_of_the_hole() {
    let places = [
        (4.5, 0.5, "ux", 1.0),
        (4.5, -0.5, "ux", 1.0),
        (0.5, 4.5, "uy", 1.0),
        (-0.5, 4.5, "uy", 1.0),
        (-4.5, 0.5, "ux", -1.0),
        (0.5, -4.5, "uy", -1.0),
    ];
    let case = plate(
        json!({ "from": [-12, -12], "size": [24, 24], "spacing": 1, "holes": hole([0.0, 0.0], 4.3) }),
        json!({
            "regions": { "all": { "box": { "from": [-99, -99], "to": [99, 99] } } },
            "supports": [{ "at": { "region": "all" }, "ux_spring": 1.0, "uy_spring": 1.0 }],
            "loads": [traction("h", "pressure", json!(100.0))],
            "probes": places.map(|(x, y, field, _)| probe(x, y, field))
        }),
    );
    let found = probes(&case);
    // Springs of 1 N/mm in all are much softer than the plate: their share of rounding is 1e-16 · 7e4.
    for (value, (.., sign)) in found.iter().zip(places) {
        assert!((sign * value / found[0] - 1.0).abs() < 1e-8, "{found:?}");
    }
    // Half of the plate has the forces of half of the border, with nothing to settle.
    let mut quarter = case.clone();
    quarter["body"]["rectangle"]["from"] = json!([0, 0]);
    quarter["body"]["rectangle"]["size"] = json!([12, 12]);
    quarter["symmetry"] = json!(["left", "bottom"]);
    quarter["supports"][0]["ux_spring"] = json!(0.25);
    quarter["supports"][0]["uy_spring"] = json!(0.25);
    quarter["probes"] = json!([probe(4.5, 0.5, "ux"), probe(0.5, 4.5, "uy")]);
    for value in probes(&quarter) {
        assert!((value / found[0] - 1.0).abs() < 1e-8, "{value} {}", found[0]);
    }
}

#[test]
fn pressure_in_a_notch_pushes_along_the_axis_of_the_notch_only() {
    let case = plate(
        json!({ "size": [20, 12], "spacing": 1, "holes": hole([10.0, 12.0], 3.0) }),
        json!({
            "supports": [{ "at": { "region": "bottom" }, "ux": 0, "uy": 0 }],
            "loads": [traction("h", "pressure", json!(10.0))],
            "probes": [
                { "name": "x", "at": { "region": "bottom" }, "field": "reaction_x" },
                { "name": "y", "at": { "region": "bottom" }, "field": "reaction_y" }
            ]
        }),
    );
    let found = probes(&case);
    // ∫ p n_y ds over the lower half of the circle is p times its diameter.
    assert!(found[0].abs() < 1e-9 && (found[1] - 60.0).abs() < 1e-9, "{found:?}");
}

#[test]
fn probes_on_a_mirror_are_those_of_the_whole_body() {
    let fields = ["ux", "uy", "stress_xx", "stress_yy", "stress_xy", "energy_density", "von_mises"];
    let all: Vec<Value> =
        [17.0, 20.0].into_iter().flat_map(|y| fields.map(|field| probe(0.0, y, field))).collect();
    let case = |from: f64, width: f64| {
        plate(
            json!({ "from": [from, 0], "size": [width, 24], "spacing": 1, "holes": hole([0.0, 12.0], 4.3) }),
            json!({
                "supports": [{ "at": { "region": "bottom" }, "ux": 0, "uy": 0 }],
                "loads": [traction("top", "uniform", json!([0, 100]))],
                "probes": all
            }),
        )
    };
    let whole = probes(&case(-20.0, 40.0));
    let mut half = case(0.0, 20.0);
    half["symmetry"] = json!(["left"]);
    let half = probes(&half);
    for (k, (found, expected)) in half.iter().zip(&whole).enumerate() {
        // ux and stress_xy are odd: zero on the mirror.
        let scale = if k % 7 == 0 { 0.05 } else { expected.abs().max(1.0) };
        assert!((found - expected).abs() < 1e-9 * scale, "{k}: {found} {expected}");
    }
    assert!(whole[9].abs() > 1.0 && half[0] == 0.0, "{whole:?}");
}

#[test]
fn a_rectangle_drawn_as_an_outline_has_the_same_loads() {
    let case = |edges: [&str; 2]| {
        plate(
            json!({ "size": [40, 20], "spacing": 1 }),
            json!({
                "supports": [{ "at": { "region": edges[0] }, "ux": 0, "uy": 0 }],
                "loads": [traction(edges[1], "uniform", json!([0, 1.5]))],
                "probes": [probe(39.5, 10.5, "uy")]
            }),
        )
    };
    let expected = probes(&case(["left", "right"]))[0];
    let mut outline = case(["edge_4", "edge_2"]);
    outline["body"] =
        json!({ "outline": { "vertices": [[0, 0], [40, 0], [40, 20], [0, 20]], "spacing": 1 } });
    let found = probes(&outline)[0];
    assert!((found / expected - 1.0).abs() < 1e-10, "{found} {expected}");
    // Beside the upper end of this edge the body goes on.
    outline["body"]["outline"]["vertices"] = json!([[0, 0], [40, 0], [40, 10], [44, 10], [44, 20], [0, 20]]);
    assert!(probes(&outline)[0].is_finite());
    outline["loads"][0]["traction"]["sharing"] = json!("consistent");
    assert!(probes(&outline)[0].is_finite());
    outline["model"]["bond_plane"]["edges"] = json!("overlay");
    assert!(refusal(&outline).contains("cannot be `consistent`: a shear needs an edge whose neighbours"));
}

#[test]
fn a_rigid_region_on_a_mirror_moves_along_it_only() {
    let case = |from: f64, width: f64, force: f64| {
        plate(
            json!({ "from": [from, 0], "size": [width, 20], "spacing": 1 }),
            json!({
                "regions": { "cap": { "box": { "from": [-3, 17], "to": [3, 20] } } },
                "supports": [{ "at": { "region": "bottom" }, "ux": 0, "uy": 0 }],
                "rigid": [{ "region": "cap" }],
                "loads": [{ "point": { "at": { "region": "cap" }, "force_y": force } }],
                "probes": [probe(0.5, 19.5, "uy"), probe(0.5, 14.5, "stress_yy")]
            }),
        )
    };
    let whole = probes(&case(-15.0, 30.0, -2000.0));
    let mut half = case(0.0, 15.0, -1000.0);
    half["symmetry"] = json!(["left"]);
    let text = refusal(&half);
    assert!(text.contains("a mirror halves this rigid region"), "{text}");
    assert!(text.contains("add \"ux\": 0, \"phi\": 0"), "{text}");
    half["rigid"][0] = json!({ "region": "cap", "ux": 0, "phi": 0 });
    for (found, expected) in probes(&half).iter().zip(whole) {
        assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
    }
}

/// A square with a crack, under tractions that are in balance.
fn cracked(loads: Value, cracks: Value) -> Value {
    plate(
        json!({ "size": [40, 40], "spacing": 1 }),
        json!({
            "cracks": cracks,
            "supports": [
                { "at": { "x": 0.5, "y": 0.5 }, "ux": 0, "uy": 0 },
                { "at": { "x": 39.5, "y": 0.5 }, "uy": 0 }
            ],
            "loads": loads,
            "stress_intensity": [{ "name": "K", "crack": 1, "tips": "both" }]
        }),
    )
}

#[test]
fn closed_and_sliding_tips_are_told() {
    let pull = |t: f64| {
        json!([traction("top", "uniform", json!([0, t])), traction("bottom", "uniform", json!([0, -t]))])
    };
    let shear = json!([
        traction("top", "uniform", json!([50, 0])),
        traction("bottom", "uniform", json!([-50, 0])),
        traction("right", "uniform", json!([0, 50])),
        traction("left", "uniform", json!([0, -50]))
    ]);
    let crack = json!([{ "path": [[14, 20], [26, 20]] }]);
    let warnings = |loads: Value| solved(&cracked(loads, crack.clone())).summary.warnings;
    assert_eq!(warnings(pull(100.0)), [""; 0]);
    let closed = warnings(pull(-100.0));
    assert!(closed.len() == 1 && closed[0].contains("overlap at a tip of `K`"), "{closed:?}");
    let slid = warnings(shear);
    assert!(slid.len() == 1 && slid[0].contains("slide at a tip of `K`"), "{slid:?}");
}

#[test]
fn tips_on_other_cracks_are_no_tips() {
    let refused = |cracks: Value, tips: &str| {
        let mut case = cracked(json!([traction("top", "uniform", json!([0, 1]))]), cracks);
        case["stress_intensity"][0]["tips"] = json!(tips);
        refusal(&case)
    };
    let whole = json!([[14, 20], [26, 20]]);
    let twice = json!([{ "path": whole }, { "path": whole }]);
    let overlapping = json!([{ "path": [[14, 20], [22, 20]] }, { "path": [[18, 20], [26, 20]] }]);
    let joined = json!([{ "path": [[20, 10], [20, 20]] }, { "path": whole }]);
    for (cracks, tips) in [(twice, "start"), (overlapping, "end"), (joined, "end")] {
        let text = refused(cracks, tips);
        assert!(text.contains("lies on the crack `2`, or within a spacing of it, so it is no tip"), "{text}");
    }
}

#[test]
fn numbers_that_make_no_sense_are_refused_at_once() {
    let case = |from: f64, ratio: f64| {
        plate(
            json!({ "from": [from, 0], "size": [5, 5], "spacing": 1 }),
            json!({
                "horizon_ratio": ratio,
                "supports": [{ "at": { "region": "left" }, "ux": 0, "uy": 0 }],
                "loads": [traction("right", "uniform", json!([1, 0]))]
            }),
        )
    };
    assert!(solved(&case(1e9, 3.0)).summary.states[0].certificate.converged);
    for from in [1e12, -1e16] {
        assert!(refusal(&case(from, 3.0)).contains("is lost in rounding"));
    }
    assert!(refusal(&case(0.0, 200.0)).contains("the largest horizon ratio of bodies is 100"));
    let beyond = refusal(&case(0.0, 60.0));
    assert!(beyond.contains("a horizon of 60 ends beyond the body, which is 5 × 5"), "{beyond}");
    // Up to twelve spacings the few bonds of a small body are answered.
    assert!(solved(&case(0.0, 12.0)).summary.states[0].certificate.converged);
    // What the horizon makes impossible is no warning on cracks.
    let mut short = case(0.0, 1.4);
    short["cracks"] = json!([{ "path": [[2, -1], [2, 3]] }]);
    let text = refusal(&short);
    assert!(text.contains("cannot have the moduli") && !text.contains("cuts no bond"), "{text}");
    let mut twice = case(0.0, 3.0);
    twice["supports"] = json!([twice["supports"][0], { "at": { "region": "bottom" }, "ux": 1 }]);
    let text = refusal(&twice);
    assert!(text.contains("`supports[1].ux` contradicts `supports[0].ux`\n"), "{text}");
    assert!(text.contains("edges share the points of their corner"), "{text}");
}

#[cfg(unix)]
#[test]
fn files_without_end_are_refused() {
    for kind in ["points", "mesh"] {
        let mut case = plate(json!({}), json!({ "supports": [{ "at": { "x": 0, "y": 0 }, "ux": 0 }] }));
        case["body"] = json!({});
        case["body"][kind] = json!({ "file": "/dev/zero" });
        assert!(refusal(&case).contains("/dev/zero lies outside the folder"), "{}", refusal(&case));
    }
}
