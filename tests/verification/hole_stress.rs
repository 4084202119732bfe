//! Stresses on round holes, which come from fields fitted to the points around them.

use peristat::summary::Summary;
use serde_json::{Value, json};

fn solve(case: &Value) -> Summary {
    peristat::solve_text(&format!("{case:#}")).unwrap_or_else(|error| panic!("{error}: {case}")).summary
}

/// A quarter of a ring, radii 10 and 25, with a pressure inside.
fn ring(model: &str, ratio: f64) -> Value {
    let turn = |k: i32| f64::from(k) * std::f64::consts::FRAC_PI_2 / 180.0;
    let arc = (0..=180).map(|k| [25.0 * turn(k).cos(), 25.0 * turn(k).sin()]);
    let arc = arc.map(|at| at.map(|x| (1e9 * x).round() / 1e9));
    let vertices: Vec<[f64; 2]> = [[0.0; 2]].into_iter().chain(arc).collect();
    let mut keys = json!({ "youngs_modulus": 70000, "state": "plane_stress" });
    if model == "state_plane" {
        keys["poisson_ratio"] = json!(0.3);
    }
    json!({
        "title": "ring", "units": "mm-N-MPa", "model": { model: keys }, "horizon_ratio": ratio,
        "body": { "outline": { "vertices": vertices, "spacing": 1,
            "holes": [{ "circle": { "name": "bore", "centre": [0, 0], "radius": 10 } }] } },
        "symmetry": ["left", "bottom"],
        "loads": [{ "traction": { "edge": "bore", "pressure": 100 } }],
        "probes": [
            { "name": "over", "at": { "x": 0, "y": 10, "inward": [0, 1] }, "field": "stress_xx" },
            { "name": "against", "at": { "x": 0, "y": 10, "inward": [0, 1] }, "field": "stress_yy" },
            { "name": "along", "at": { "x": 6, "y": 8 }, "field": "von_mises" }]
    })
}

#[test]
fn a_pressure_on_a_hole_has_the_stress_of_lame_there() {
    let hoop = 100.0 * (625.0 + 100.0) / (625.0 - 100.0);
    // −100 across the border and no stress across the plane.
    let mises = (hoop * hoop + 100.0 * hoop + 1e4_f64).sqrt();
    for (model, ratio) in [("bond_plane", 2.0), ("bond_plane", 3.0), ("state_plane", 3.0)] {
        let found = solve(&ring(model, ratio)).probes;
        for (probe, expected) in found.iter().zip([hoop, -100.0, mises]) {
            // 0.18, 0.04 and 0.07 % of the hoop stress; at points beside the border 4 % are missed.
            assert!(
                (probe.value - expected).abs() < 4e-3 * hoop,
                "{model} {ratio} {}: {}",
                probe.name,
                probe.value
            );
            assert!(probe.misfit.is_some_and(|misfit| misfit < 2e-3), "{model} {ratio}: {:?}", probe.misfit);
        }
    }
}

/// A plate with a hole of ten points per radius, pulled along x, and some more.
fn pulled(more: &Value) -> Value {
    let mut case = json!({
        "title": "hole", "units": "mm-N-MPa",
        "model": { "bond_plane": { "youngs_modulus": 70000, "state": "plane_stress" } },
        "body": { "rectangle": { "from": [-40, -40], "size": [80, 80], "spacing": 1,
            "holes": [{ "circle": { "name": "hole", "centre": [0, 0], "radius": 10 } }] } },
        "supports": [{ "at": { "region": "left" }, "ux": 0 }, { "at": { "x": -39.5, "y": 0.5 }, "uy": 0 }],
        "loads": [{ "traction": { "edge": "right", "uniform": [100, 0] } }],
        "probes": [{ "name": "top", "at": { "x": 0, "y": 10, "inward": [0, 1] }, "field": "stress_xx" }]
    });
    let more = more.as_object().expect("keys").clone();
    case.as_object_mut().expect("keys").extend(more);
    case
}

#[test]
fn what_acts_beside_a_hole_leaves_its_stress_to_the_points() {
    let misfit = |more: Value| solve(&pulled(&more)).probes[0].misfit;
    assert!(misfit(json!({})).is_some());
    let load =
        |more: Value| json!({ "loads": [{ "traction": { "edge": "right", "uniform": [100, 0] } }, more] });
    let near = json!({ "at": { "x": 11.5, "y": 2.5 }, "uy": 0 });
    for more in [
        load(json!({ "body_force": { "density": [1, 0] } })),
        load(json!({ "point": { "at": { "x": 11.5, "y": 2.5 }, "force_x": 1 } })),
        json!({ "supports": [{ "at": { "region": "left" }, "ux": 0, "uy": 0 }, near] }),
        json!({ "cracks": [{ "path": [[11, -5], [11, 5]] }] }),
    ] {
        assert_eq!(misfit(more.clone()), None, "{more}");
    }
    // What acts on the hole itself is known of the fields.
    assert!(misfit(load(json!({ "traction": { "edge": "hole", "uniform": [1, 0] } }))).is_some());
    // Far from the hole both may be.
    assert!(misfit(load(json!({ "point": { "at": { "x": 30.5, "y": 2.5 }, "force_x": 1 } }))).is_some());
}

/// A place that is written with four digits is 5e-5 off the border, and its stress that of the border.
#[test]
fn places_of_four_digits_are_on_the_hole() {
    let probe = |name: &str, [x, y]: [f64; 2]| json!({ "name": name, "at": { "x": x, "y": y }, "field": "stress_xx" });
    let probes = json!([probe("all", [0.871557427477, 9.96194698092]), probe("four", [0.8716, 9.9619])]);
    let found = solve(&pulled(&json!({ "probes": probes }))).probes;
    let [all, four] = [0, 1].map(|k| found[k].value);
    // Found: 9e-6.
    assert!(found[1].misfit.is_some() && (four / all - 1.0).abs() < 2e-5, "{all} {four}");
}

#[test]
fn a_whole_plate_and_its_quarter_have_the_same_stress_at_a_hole() {
    let whole = pulled(&json!({}));
    let mut quarter = whole.clone();
    quarter["body"]["rectangle"]["from"] = json!([0, 0]);
    quarter["body"]["rectangle"]["size"] = json!([40, 40]);
    quarter["symmetry"] = json!(["left", "bottom"]);
    quarter["supports"] = json!([]);
    let mut ends = whole;
    ends["loads"] = json!([
        { "traction": { "edge": "right", "uniform": [100, 0] } }, { "traction": { "edge": "left", "uniform": [-100, 0] } }]);
    ends["supports"] = json!([
        { "at": { "x": -39.5, "y": 0.5 }, "ux": 0, "uy": 0 }, { "at": { "x": 39.5, "y": 0.5 }, "uy": 0 }]);
    let [whole, quarter] = [&ends, &quarter].map(|case| solve(case).probes[0].value);
    assert!((whole / quarter - 1.0).abs() < 1e-6, "{whole} {quarter}");
}

/// The image of a hole has the image of what acts on it: in a quarter a pressure of 10 + x/2 is one of 10 + |x|/2.
#[test]
fn a_load_on_a_hole_goes_on_behind_lines_of_symmetry() {
    let loaded = |from: i32, pressure: &str, symmetry: &Value, supports: &Value| {
        solve(&json!({
            "title": "hole", "units": "mm-N-MPa",
            "model": { "bond_plane": { "youngs_modulus": 70000, "state": "plane_stress" } },
            "body": { "rectangle": { "from": [from, from], "size": [40 - from, 40 - from], "spacing": 1,
                "holes": [{ "circle": { "name": "hole", "centre": [0, 0], "radius": 10 } }] } },
            "symmetry": symmetry, "supports": supports,
            "loads": [{ "traction": { "edge": "hole", "pressure": pressure } }],
            "probes": [{ "name": "along", "at": { "x": 6, "y": 8 }, "field": "von_mises" }]
        }))
        .probes[0]
            .value
    };
    let points = json!([{ "at": { "x": -39.5, "y": 0.5 }, "ux": 0, "uy": 0 }, { "at": { "x": 39.5, "y": 0.5 }, "uy": 0 }]);
    let whole = loaded(-40, "10 + sqrt(x^2)/2", &json!([]), &points);
    let quarter = loaded(0, "10 + x/2", &json!(["left", "bottom"]), &json!([]));
    assert!((whole / quarter - 1.0).abs() < 1e-6, "{whole} {quarter}");
}
