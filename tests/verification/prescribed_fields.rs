//! Formulas of the position where numbers are prescribed: displacements, tractions and forces per volume.

use peristat::Solved;
use serde_json::{Value, json};

fn solve(case: &Value) -> Solved {
    let solved = peristat::solve_text(&format!("{case:#}")).unwrap_or_else(|error| panic!("{error}"));
    assert!(solved.summary.states.iter().all(|state| state.certificate.converged));
    solved
}

fn faults(case: &Value) -> String {
    match peristat::solve_text(&format!("{case:#}")) {
        Ok(_) => panic!("a case with faults"),
        Err(error) => error.to_string(),
    }
}

/// Forces that hold every point of a body in a prescribed motion are the internal ones: a sum over bonds with the constant of the
/// plane-stress bond, 9E/(πtδ³) (Gerstle and others 2005, Silling and Askari 2005), written here without the code.
#[test]
fn a_motion_that_is_prescribed_everywhere_has_the_internal_forces_of_a_double_loop() {
    const E: f64 = 70_000.0;
    let (columns, rows, horizon) = (4_i32, 24_i32, 3.0_f64);
    let at = |i: i32, j: i32| [f64::from(i) + 0.5, f64::from(j) + 0.5];
    let points: Vec<(i32, i32)> = (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j))).collect();
    let probe = |&(i, j): &(i32, i32), field: &str| {
        let [x, y] = at(i, j);
        json!({ "name": format!("{field} {i} {j}"), "at": { "x": x, "y": y }, "field": field })
    };
    let probes: Vec<Value> =
        points.iter().flat_map(|p| [probe(p, "reaction_x"), probe(p, "reaction_y")]).collect();
    let supports: Vec<Value> = points
        .iter()
        .map(|&(i, j)| {
            let [x, y] = at(i, j);
            json!({ "at": { "x": x, "y": y }, "ux": "0*x", "uy": "0.001*y" })
        })
        .collect();
    let case = json!({
        "title": "prescribed everywhere", "units": "mm-N-MPa", "horizon_ratio": horizon,
        "model": { "bond_plane": { "youngs_modulus": E, "state": "plane_stress", "calibration": "published", "volume_factor": "full" } },
        "body": { "rectangle": { "size": [columns, rows], "spacing": 1 } },
        "supports": supports, "probes": probes
    });
    let solved = solve(&case);
    let constant = 9.0 * E / (std::f64::consts::PI * horizon.powi(3));
    let (mut largest, mut worst) = (0.0_f64, 0.0_f64);
    let mut found = solved.summary.probes.iter().map(|p| p.value);
    for &(i, j) in &points {
        let mut force = [0.0; 2];
        for &(k, l) in &points {
            let d = [f64::from(k - i), f64::from(l - j)];
            let length = d[0].hypot(d[1]);
            if length == 0.0 || length > horizon * (1.0 + 1e-9) {
                continue;
            }
            // Small strains: the elongation along the bond, over its length.
            let stretch = 0.001 * d[1] * d[1] / length / length;
            (0..2).for_each(|axis| force[axis] += constant * stretch * d[axis] / length);
        }
        for f in force {
            // What holds the point takes the pull of its bonds.
            worst = worst.max((found.next().unwrap() + f).abs());
            largest = largest.max(f.abs());
        }
    }
    // 3e-16 is found.
    assert!(largest > 1.0 && worst < 1e-12 * largest, "{worst:e} of {largest:e}");
}

/// A linear motion of the whole border is that of the body, whatever its bonds: no model sees a place wrong.
#[test]
fn a_linear_motion_of_the_border_is_that_of_the_body() {
    let plane =
        json!({ "youngs_modulus": 2e5, "poisson_ratio": 0.2, "state": "plane_strain", "edges": "border" });
    let outline =
        json!({ "outline": { "vertices": [[0, 0], [9, 0], [12, 5], [9, 9], [0, 9]], "spacing": 0.5 } });
    let rectangle = json!({ "rectangle": { "size": [12, 9], "spacing": 0.5 } });
    for (name, model, body, least) in [
        (
            "bonds",
            json!({ "bond_plane": { "youngs_modulus": 2e5, "state": "plane_stress" } }),
            &rectangle,
            1e-12,
        ),
        (
            "bonds, slanted",
            json!({ "bond_plane": { "youngs_modulus": 2e5, "state": "plane_stress" } }),
            &outline,
            1e-12,
        ),
        ("families", json!({ "state_plane": plane }), &rectangle, 1e-12),
    ] {
        let case = json!({
            "title": name, "units": "mm-N-MPa", "model": model, "body": body,
            "supports": [ { "at": { "region": "outer" }, "ux": "1e-3*x + 2e-4*y", "uy": "1e-4*x - 5e-4*y" } ]
        });
        let solved = solve(&case);
        for (field, strain) in [("strain_xx", 1e-3), ("strain_yy", -5e-4), ("strain_xy", 1.5e-4)] {
            let worst = solved
                .field(0, field)
                .expect("a field of this name")
                .iter()
                .fold(0.0_f64, |a, e| a.max((e - strain).abs()));
            // 4e-16 is found, 3e-15 where the border is slanted.
            assert!(worst < least * 1e-3, "{name} {field}: {worst:e}");
        }
    }
}

/// What a formula says is what the keys for straight lines, parabolas and numbers say.
#[test]
fn formulas_are_the_profiles_that_they_describe() {
    let plate = |load: Value| {
        json!({
            "title": "profiles", "units": "mm-N-MPa", "model": { "bond_plane": { "youngs_modulus": 2e5, "state": "plane_stress" } },
            "body": { "rectangle": { "size": [12, 8], "spacing": 0.5, "holes": [ { "circle": { "name": "hole", "centre": [5, 4], "radius": 1.5 } } ] } },
            "supports": [ { "at": { "region": "left" }, "ux": 0, "uy": 0 } ], "loads": [load]
        })
    };
    let block = |load: Value| {
        json!({
            "title": "profiles", "units": "mm-N-MPa", "model": { "bond_solid": { "youngs_modulus": 2e5 } },
            "body": { "block": { "size": [6, 4, 4], "spacing": 1 } },
            "supports": [ { "at": { "region": "left" }, "ux": 0, "uy": 0, "uz": 0 } ], "loads": [load]
        })
    };
    let on = |case: &dyn Fn(Value) -> Value, key: &str, place: &str, value: (&str, Value)| {
        let mut traction = json!({ key: place, value.0: value.1 });
        if place == "right" && key == "face" && ["linear", "parabolic"].contains(&value.0) {
            traction["along"] = json!("y");
        }
        case(json!({ "traction": traction }))
    };
    let pairs = [
        // The edge runs upwards.
        (
            on(&plate, "edge", "right", ("linear", json!([[10, -4], [30, 0]]))),
            on(&plate, "edge", "right", ("formula", json!(["10 + 20*y/8", "-4 + 4*y/8"]))),
        ),
        (
            on(&plate, "edge", "right", ("parabolic", json!([0, 6]))),
            on(&plate, "edge", "right", ("formula", json!([0, "24*y/8*(1 - y/8)"]))),
        ),
        (
            on(&plate, "edge", "hole", ("pressure", json!(5))),
            on(&plate, "edge", "hole", ("pressure", json!("5 + 0*x"))),
        ),
        (
            on(&block, "face", "right", ("linear", json!([[10, 0, 1], [30, 2, 0]]))),
            on(&block, "face", "right", ("formula", json!(["10 + 5*y", "y/2", "1 - y/4"]))),
        ),
        (
            on(&block, "face", "right", ("pressure", json!(7))),
            on(&block, "face", "right", ("pressure", json!("7 + 0*z"))),
        ),
        (
            plate(json!({ "body_force": { "density": [1, -2] } })),
            plate(json!({ "body_force": { "density": ["1 + 0*x", "-2"] } })),
        ),
    ];
    // Where no bond ends on the border, a traction fades inwards, which asks how it varies along the edge.
    let fading = |load: Value| {
        let mut case = plate(load);
        case["model"] = json!({ "state_plane": { "youngs_modulus": 2e5, "poisson_ratio": 0.3, "state": "plane_stress" } });
        case["body"] = json!({ "rectangle": { "size": [12, 8], "spacing": 0.5 } });
        case
    };
    let pairs = pairs.into_iter().chain([
        (
            on(&fading, "edge", "right", ("parabolic", json!([5, 6]))),
            on(&fading, "edge", "right", ("formula", json!(["20*y/8*(1 - y/8)", "24*y/8*(1 - y/8)"]))),
        ),
        (
            on(&fading, "edge", "top", ("pressure", json!(5))),
            on(&fading, "edge", "top", ("pressure", json!("5 + 0*x"))),
        ),
    ]);
    for (k, (profile, formula)) in pairs.enumerate() {
        let [profile, formula] = [profile, formula].map(|case| solve(&case));
        for field in ["ux", "uy"] {
            let [a, b] =
                [&profile, &formula].map(|solved| solved.field(0, field).expect("a field of this name"));
            let size = a.iter().fold(0.0_f64, |size, u| size.max(u.abs()));
            let worst = a.iter().zip(b.iter()).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()));
            // 1e-15 is found; cells that a hole has cut share what their slivers lack in another way, 9e-9.
            let least = if k == 5 { 3e-8 } else { 1e-12 };
            assert!(size > 0.0 && worst < least * size, "pair {k}, {field}: {:e}", worst / size);
        }
    }
}

#[test]
fn a_formula_with_one_value_is_that_number() {
    // A strip under a uniform tension is exact, whatever the edges: u = σ L/E; a formula left 0.1 % in u, 2 % in the stress.
    let strip = |[left, right]: [Value; 2]| {
        json!({
            "title": "strip", "units": "mm-N-MPa",
            "model": { "state_plane": { "youngs_modulus": 7e4, "poisson_ratio": 0.3, "state": "plane_stress" } },
            "body": { "rectangle": { "size": [81, 21], "spacing": 3 } },
            "supports": [ { "at": { "x": 40.5, "y": 10.5 }, "ux": 0, "uy": 0 }, { "at": { "x": 40.5, "y": 16.5 }, "ux": 0 } ],
            "loads": [ { "traction": left }, { "traction": right } ]
        })
    };
    let formula = |edge: &str, value: &str| json!({ "edge": edge, "formula": [value, "0*x"] });
    let suction = |edge: &str| json!({ "edge": edge, "pressure": "-100 - 0*y" });
    for tractions in [
        [formula("left", "-100 - 0*y"), formula("right", "100 + y - y")],
        [suction("left"), suction("right")],
    ] {
        let solved = solve(&strip(tractions));
        let stress = solved.field(0, "stress_xx").expect("stresses");
        let worst = stress.iter().fold(0.0_f64, |worst, s| worst.max((s / 100.0 - 1.0).abs()));
        assert!(worst < 1e-9, "{worst:.1e}");
    }
}

#[test]
fn formulas_without_a_value_are_faults_where_they_stand() {
    let case = |support: Value, load: Value| {
        json!({
            "title": "faults", "units": "mm-N-MPa", "model": { "bond_plane": { "youngs_modulus": 2e5, "state": "plane_stress" } },
            "body": { "rectangle": { "size": [12, 8], "spacing": 1 } },
            "supports": [ { "at": { "region": "left" }, "ux": support, "uy": 0 } ], "loads": [load]
        })
    };
    let push = json!({ "traction": { "edge": "right", "uniform": [1, 0] } });
    for (found, expected) in [
        (faults(&case(json!("sqrt(x - 1)"), push.clone())), "supports[0].ux"),
        (faults(&case(json!("2*t"), push.clone())), "there is no `t`"),
        (
            faults(&case(json!(0), json!({ "body_force": { "density": ["1/(x - 1.5)", 0] } }))),
            "loads[0].body_force.density",
        ),
        (
            faults(&case(json!(0), json!({ "body_force": { "density": ["x", 0, 0] } }))),
            "`density` has 3 numbers",
        ),
        (
            faults(&case(json!(0), json!({ "traction": { "edge": "top", "pressure": "log(-y)" } }))),
            "no value on the border",
        ),
        (
            faults(&case(json!(0), json!({ "traction": { "edge": "top", "formula": ["z", 0] } }))),
            "no `z` in the plane",
        ),
    ] {
        assert!(found.contains(expected), "{found}");
    }
    let beam = json!({
        "title": "beam", "units": "mm-N-MPa", "model": { "timoshenko_beam": { "stiffness": { "bending": { "uniform": 1 }, "shear": { "uniform": 1 } } } },
        "body": { "line": { "length": 1, "cells": 10 } }, "supports": [ { "at": { "x": 0 }, "w": "x", "phi": 0 } ]
    });
    assert!(faults(&beam).contains("formulas are for bodies"), "{}", faults(&beam));
}

/// A corner belongs to two edges. Where both prescribe the same motion there, their order changes nothing; where they do not, the case
/// is refused.
#[test]
fn formulas_that_contradict_each_other_are_refused() {
    let case = |supports: Value| {
        json!({
            "title": "corner", "units": "mm-N-MPa", "model": { "bond_plane": { "youngs_modulus": 2e5, "state": "plane_stress" } },
            "body": { "rectangle": { "size": [12, 9], "spacing": 1 } }, "supports": supports
        })
    };
    let left = |ux: Value| json!({ "at": { "region": "left" }, "ux": ux, "uy": 0 });
    let top = |ux: Value| json!({ "at": { "region": "top" }, "ux": ux });
    for other in [left(json!("2e-3*y")), left(json!(0.5)), top(json!("1e-3*8 + 1e-3*x")), top(json!(0.5))] {
        let found = faults(&case(json!([left(json!("1e-3*y")), other])));
        assert!(found.contains("contradicts"), "{found}");
    }
    let [first, second] = [left(json!("1e-3*y")), top(json!("9e-3 + 1e-3*x"))];
    let solve = |supports: Value| solve(&case(supports)).field(0, "stress_xx").expect("stresses").to_vec();
    let [one, other] = [solve(json!([first, second])), solve(json!([second, first]))];
    let size = one.iter().fold(0.0_f64, |size, s| size.max(s.abs()));
    let worst = one.iter().zip(&other).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()));
    // 2e-14 is found.
    assert!(size > 1.0 && worst < 1e-12 * size, "{worst:e} of {size:e}");
}
