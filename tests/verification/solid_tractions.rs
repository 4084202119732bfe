//! Tractions on faces of solids that vary, and on the borders of what is cut out of them.

use serde_json::{Value, json};

fn solved(case: &Value) -> peristat::Solved {
    peristat::solve_text(&case.to_string()).unwrap_or_else(|error| panic!("{error}"))
}

fn bonds() -> Value {
    json!({ "bond_solid": { "youngs_modulus": 1000.0 } })
}

fn families() -> Value {
    json!({ "state_solid": { "youngs_modulus": 1000.0, "poisson_ratio": 0.3 } })
}

fn case(model: &Value, body: Value) -> Value {
    json!({ "title": "t", "units": "none", "model": model, "body": { "block": body } })
}

fn resultants(case: &Value) -> [[[f64; 3]; 2]; 2] {
    let found = solved(case);
    let of = found.summary.states[0].certificate.resultants.clone().expect("resultants");
    [&of.asked, &of.reactions]
        .map(|total| [total.forces(), total.moments()].map(|three| three.map(|t| t.expect("a number"))))
}

#[test]
fn tractions_that_vary_have_their_force_and_their_moment() {
    for model in
        [bonds(), families(), json!({ "bond_solid": { "youngs_modulus": 1000.0, "edges": "overlay" } })]
    {
        let mut case =
            case(&model, json!({ "from": [0.0, 0.0, 0.0], "size": [3.0, 4.0, 2.0], "spacing": 0.5 }));
        case["supports"] = json!([{ "at": { "region": "left" }, "ux": 0.0, "uy": 0.0, "uz": 0.0 }]);
        case["loads"] = json!([
            { "traction": { "face": "right", "linear": [[-6.0, 0.0, 1.0], [6.0, 0.0, 1.0]], "along": "y" } },
            { "traction": { "face": "front", "parabolic": [0.0, 3.0, 0.0], "along": "x" } },
        ]);
        let [asked, held] = resultants(&case);
        // Of the first load: 2 x 8 N along z at (3, 2, 1), and -∫ t y dA = -6·4²/6·2 about z. Of the second: 2/3·3·3·4 = 24 N along y at
        // (1.5, 2, 2).
        let expected = [[0.0, 24.0, 8.0], [2.0 * 8.0 - 2.0 * 24.0, -3.0 * 8.0, 1.5 * 24.0 - 32.0]];
        for k in 0..3 {
            assert!((asked[0][k] - expected[0][k]).abs() < 1e-12, "{asked:?} {expected:?}");
            assert!((asked[1][k] - expected[1][k]).abs() < 1e-12, "{asked:?} {expected:?}");
            // 1e-13 measured.
            assert!((asked[0][k] + held[0][k]).abs() < 1e-9, "{asked:?} {held:?}");
            assert!((asked[1][k] + held[1][k]).abs() < 1e-9, "{asked:?} {held:?}");
        }
    }
}

/// A block with a window, a bore and a ball cut out, under one pressure on all faces and in all cuts: one stress, stairs or not.
#[test]
fn one_pressure_on_every_wall_is_one_stress() {
    for (model, bulk) in [(bonds(), 1000.0 / 1.5), (families(), 1000.0 / 1.2)] {
        let mut case = case(
            &model,
            json!({
                "size": [16.0, 10.0, 9.0], "spacing": 1.0,
                "cuts": [
                    { "block": { "name": "window", "from": [2.0, 2.0, 6.0], "size": [2.0, 4.0, 3.0] } },
                    { "bore": { "name": "bore", "along": "z", "centre": [8.5, 4.5, 0.0], "radius": 2.2 } },
                    { "ball": { "name": "corner", "centre": [16.0, 10.0, 9.0], "radius": 3.1 } },
                ],
            }),
        );
        let walls = ["left", "right", "bottom", "top", "back", "front", "window", "bore", "corner"];
        let loads = walls.map(|name| json!({ "traction": { "face": name, "pressure": 5.0 } }));
        case["loads"] = json!(loads);
        case["supports"] = json!([
            { "at": { "x": 0.5, "y": 0.5, "z": 0.5 }, "ux": 0.0, "uy": 0.0, "uz": 0.0 },
            { "at": { "x": 15.5, "y": 0.5, "z": 0.5 }, "uy": 0.0, "uz": 0.0 },
            { "at": { "x": 0.5, "y": 9.5, "z": 0.5 }, "uz": 0.0 },
        ]);
        // Rounding is looked at, not where cycles end.
        case["solver"] = json!("sparse");
        let found = solved(&case);
        for (field, axis) in [("ux", 0), ("uy", 1), ("uz", 2)] {
            let values = found.field(0, field).expect("a field");
            let off = values
                .iter()
                .zip(found.points())
                .map(|(v, at)| (v + 5.0 / (3.0 * bulk) * (at[axis] - 0.5)).abs());
            let off = off.fold(0.0, f64::max);
            // 2e-14 measured of bonds beside 0.03.
            assert!(off < if model == bonds() { 1e-11 } else { 1e-3 }, "{field}: {off:e}");
        }
    }
}

/// A quarter of a tube pushes its planes of symmetry apart by the pressure times its radius.
#[test]
fn a_pressure_in_a_bore_has_the_force_of_its_shadow() {
    let mut case = case(
        &bonds(),
        json!({
            "size": [12.0, 12.0, 3.0], "spacing": 1.0,
            "cuts": [
                { "bore": { "name": "bore", "along": "z", "centre": [0.0, 0.0, 0.0], "radius": 6.0 } },
                { "outside_cylinder": { "name": "mantle", "along": "z", "centre": [0.0, 0.0, 0.0], "radius": 12.0 } },
            ],
        }),
    );
    case["symmetry"] = json!(["left", "bottom", "back"]);
    case["loads"] = json!([
        { "traction": { "face": "bore", "pressure": 7.0 } },
        { "traction": { "face": "front", "total": [0.0, 0.0, -4.0] } },
    ]);
    let found = solved(&case);
    let of = found.summary.states[0].certificate.resultants.clone().expect("resultants");
    let forces = |total: &peristat::run::Total| total.forces().map(|f| f.expect("a force"));
    let (asked, held) = (forces(&of.asked), forces(&of.reactions));
    let shadow = 7.0 * 6.0 * 3.0;
    for (k, expected) in [shadow, shadow, -4.0].into_iter().enumerate() {
        assert!(
            (asked[k] - expected).abs() < 1e-11 && (held[k] + expected).abs() < 1e-8,
            "{asked:?} {held:?}"
        );
    }
    // Points beside the bore and the mantle are regions.
    case["supports"] = json!([{ "at": { "region": "mantle" }, "ux": 0.0, "uy": 0.0 }]);
    let fixed = solved(&case);
    let largest = |of: &peristat::Solved| of.field(0, "ux").expect("ux").iter().copied().fold(0.0, f64::max);
    assert!(largest(&fixed) < 0.7 * largest(&found), "{} {}", largest(&fixed), largest(&found));
}

/// A contact of Hertz bears 2π a² p/3, in its middle; half of one that lies half beside the face acts at 3 a/8 from its middle:
/// `∫ r² √(1 − r²) cos φ dr dφ` over half of the circle is π/8, and the force over it π/3.
#[test]
fn contacts_bear_the_force_of_their_pressure_on_every_face() {
    use std::f64::consts::PI;
    let (radius, peak, size) = (1.3, 7.0, [3.0, 4.0, 3.5]);
    let force = 2.0 * PI * radius * radius * peak / 3.0;
    let faces = ["left", "right", "bottom", "top", "back", "front"];
    for (number, face) in faces.into_iter().enumerate() {
        let (axis, is_high) = (number / 2, number % 2 == 1);
        let mut inside = [1.45, 1.6, 1.55];
        inside[axis] = if is_high { size[axis] } else { 0.0 };
        // The same moved to a side of the face, where half of it is left.
        let (beside, mut at_side) = ((axis + 1) % 3, inside);
        at_side[beside] = 0.0;
        for (centre, part) in [(inside, 1.0), (at_side, 0.5)] {
            let mut case = case(&bonds(), json!({ "size": size, "spacing": 0.25 }));
            let opposite = faces[2 * axis + usize::from(!is_high)];
            case["supports"] = json!([{ "at": { "region": opposite }, "ux": 0.0, "uy": 0.0, "uz": 0.0 }]);
            case["loads"] = json!([
                { "traction": { "face": face, "hertz": { "centre": centre, "radius": radius, "peak": peak } } }
            ]);
            let [asked, held] = resultants(&case);
            let (mut f, mut at) = ([0.0; 3], centre);
            f[axis] = if is_high { -part * force } else { part * force };
            if part < 1.0 {
                at[beside] = 3.0 / 8.0 * radius;
            }
            let [x, y, z] = at;
            let moment = [y * f[2] - z * f[1], z * f[0] - x * f[2], x * f[1] - y * f[0]];
            for k in 0..3 {
                // 2e-14 measured.
                assert!((asked[0][k] - f[k]).abs() < 1e-11, "{face}, {part}: {asked:?} {f:?}");
                assert!((asked[1][k] - moment[k]).abs() < 1e-11, "{face}, {part}: {asked:?} {moment:?}");
                // Cycles leave 4e-8.
                assert!((asked[0][k] + held[0][k]).abs() < 1e-6, "{face}: {asked:?} {held:?}");
                assert!((asked[1][k] + held[1][k]).abs() < 1e-6, "{face}: {asked:?} {held:?}");
            }
        }
    }
}
