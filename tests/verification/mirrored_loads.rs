//! What is asked of loads beside lines of symmetry acts there: statics of every treatment of edges, and one stress on solids whose walls
//! meet.

use peristat::run::Certificate;
use peristat::{Solved, solve_text};
use serde_json::{Value, json};

fn solved(case: &Value) -> Solved {
    solve_text(&case.to_string()).unwrap_or_else(|error| panic!("{error}\n{case}"))
}

fn certificate(solved: &Solved) -> &Certificate {
    &solved.summary.states[0].certificate
}

fn plate(model: Value, size: [u32; 2], mirror: &str) -> Value {
    let supports = match mirror {
        "left" => json!([{ "at": { "x": 0.5, "y": 0.5 }, "uy": 0 }]),
        _ => json!([{ "at": { "region": "left" }, "ux": 0 }]),
    };
    json!({
        "title": "mirrored", "units": "none", "model": model, "symmetry": [mirror], "supports": supports,
        "body": { "rectangle": { "size": size, "spacing": 1 } },
        "loads": [{ "traction": { "edge": "right", "uniform": [10, 0] } }]
    })
}

/// With `none` 2.6 % of the force was missing, with an overlay over two rows 20 %.
#[test]
fn plates_carry_what_is_asked_whatever_is_done_about_their_edges() {
    for mirror in ["left", "bottom"] {
        for edges in ["border", "overlay", "none", "volume", "energy"] {
            for size in [[40, 20], [20, 2], [20, 3]] {
                let model = json!({ "bond_plane": { "youngs_modulus": 1000, "state": "plane_stress", "edges": edges } });
                let solved = solved(&plate(model, size, mirror));
                assert!(certificate(&solved).converged, "{mirror} {edges} {size:?}");
            }
        }
    }
}

/// A quarter of a plate with a hole in its middle: one eigenvalue was negative with the influences `constant` and `inverse`.
#[test]
fn a_hole_between_two_mirrors_leaves_a_definite_stiffness() {
    for influence in ["constant", "inverse", "linear"] {
        let material = json!({ "youngs_modulus": 1000, "poisson_ratio": 0.3, "state": "plane_stress", "influence": influence });
        let solved = solved(&json!({
            "title": "quarter", "units": "none", "model": { "state_plane": material }, "symmetry": ["left", "bottom"],
            "body": { "rectangle": { "size": [20, 20], "spacing": 1, "holes": [
                { "circle": { "name": "hole", "centre": [0, 0], "radius": 5 } }] } },
            "loads": [{ "traction": { "edge": "right", "uniform": [10, 0] } }]
        }));
        assert!(certificate(&solved).converged, "{influence}");
        let is_said = solved.summary.warnings.iter().any(|text| text.contains("influence `linear`"));
        assert_eq!(is_said, influence != "linear", "{:?}", solved.summary.warnings);
    }
}

fn pressed(body: Value, symmetry: Value, supports: Value, faces: &[&str]) -> Solved {
    let loads: Vec<Value> =
        faces.iter().map(|face| json!({ "traction": { "face": face, "pressure": 6 } })).collect();
    solved(&json!({
        "title": "pressed", "units": "none", "model": { "bond_solid": { "youngs_modulus": 1000 } },
        "body": { "block": body }, "symmetry": symmetry, "supports": supports, "loads": loads
    }))
}

fn is_one_pressure(solved: &Solved) {
    for name in ["stress_xx", "stress_yy", "stress_zz"] {
        let field = solved.field(0, name).expect("a stress");
        let worst = field.iter().fold(0.0_f64, |m, s| m.max((s + 6.0).abs()));
        // 2e-9 measured, what conjugate gradients leave; sides with two pressures gave 4.
        assert!(worst < 1e-8, "{name} {worst:e}");
    }
}

#[test]
fn one_pressure_on_walls_that_meet_is_one_stress() {
    let pins = json!([
        { "at": { "x": 0.5, "y": 0.5, "z": 0.5 }, "ux": 0, "uy": 0, "uz": 0 },
        { "at": { "x": 9.5, "y": 0.5, "z": 0.5 }, "uy": 0, "uz": 0 },
        { "at": { "x": 0.5, "y": 9.5, "z": 0.5 }, "uz": 0 }
    ]);
    let bores = json!([
        { "bore": { "name": "a", "along": "x", "centre": [5, 5, 5], "radius": 2.2 } },
        { "bore": { "name": "b", "along": "y", "centre": [5, 5, 5], "radius": 2.2 } }
    ]);
    let faces = ["left", "right", "bottom", "top", "back", "front", "a", "b"];
    is_one_pressure(&pressed(
        json!({ "size": [10, 10, 10], "spacing": 1, "cuts": bores }),
        json!([]),
        pins,
        &faces,
    ));
}

#[test]
fn a_round_body_that_a_mirror_halves_has_no_border_there() {
    let cut = json!([{ "outside_cylinder": { "name": "round", "along": "z", "centre": [2, 5, 2], "radius": 4.6 } }]);
    let solved = pressed(
        json!({ "size": [10, 10, 4], "spacing": 1, "cuts": cut }),
        json!(["left"]),
        json!([
            { "at": { "x": 0.5, "y": 4.5, "z": 0.5 }, "uy": 0, "uz": 0 },
            { "at": { "x": 3.5, "y": 4.5, "z": 0.5 }, "uz": 0 },
            { "at": { "x": 0.5, "y": 7.5, "z": 0.5 }, "uz": 0 }
        ]),
        &["back", "front", "round"],
    );
    is_one_pressure(&solved);
}

/// What acts along a fin one cell thick has no arm: it acts in the middle, and a warning says so.
#[test]
fn a_fin_one_cell_thick_bears_a_traction_along_it() {
    let solved = solved(&json!({
        "title": "fin", "units": "none", "model": { "bond_solid": { "youngs_modulus": 1000 } },
        "body": { "block": { "size": [12, 4, 4], "spacing": 1, "cuts": [{ "block": { "from": [4, 1, 0], "size": [8, 3, 4] } }] } },
        "supports": [{ "at": { "region": "left" }, "ux": 0, "uy": 0, "uz": 0 }],
        "loads": [{ "traction": { "face": "bottom", "uniform": [1, 0, 0] } }]
    }));
    assert!(certificate(&solved).converged);
    assert!(solved.summary.warnings.iter().any(|text| text.contains("one cell thick")));
}

/// A quarter of a ring under the pressure of its bore, held on twelve chords outside: the supports take what one stress has there, not the
/// lines of symmetry that chords meet at a slant. Three times the force was counted.
#[test]
fn a_pressure_opposite_to_a_held_border_acts_as_asked() {
    let [bore, rim, pressure] = [10.0, 20.0, 30.0];
    let at = |k: u32| {
        let (sin, cos) = (std::f64::consts::FRAC_PI_2 * f64::from(k) / 12.0).sin_cos();
        [rim * cos, rim * sin].map(|x| (1e9 * x).round() / 1e9)
    };
    let vertices: Vec<[f64; 2]> = std::iter::once([0.0; 2]).chain((0..=12).map(at)).collect();
    let chords: Vec<String> = (2..14).map(|k| format!("edge_{k}")).collect();
    let solved = solved(&json!({
        "title": "quarter", "units": "none", "symmetry": ["left", "bottom"],
        "model": { "state_plane": { "youngs_modulus": 1000, "poisson_ratio": 0.3, "state": "plane_stress", "edges": "ghosts" } },
        "body": { "outline": { "vertices": vertices, "spacing": 1,
            "holes": [{ "circle": { "name": "bore", "centre": [0, 0], "radius": bore } }] } },
        "supports": [{ "at": { "region": chords }, "ux": 0, "uy": 0 }],
        "loads": [{ "traction": { "edge": "bore", "pressure": pressure } }]
    }));
    let certificate = certificate(&solved);
    let resultants = certificate.resultants.clone().expect("resultants");
    for (total, sign) in [(&resultants.asked, 1.0), (&resultants.applied, 1.0), (&resultants.reactions, -1.0)]
    {
        for force in total.forces().into_iter().take(2) {
            // 1e-12 is found.
            assert!(
                (sign * force.expect("a number") / (pressure * bore) - 1.0).abs() < 1e-9,
                "{resultants:?}"
            );
        }
    }
    assert!(certificate.converged);
}
