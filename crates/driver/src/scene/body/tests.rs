//! Scenes of bodies in the plane as cases make them.

use super::scene::BodyScene;
use crate::case;
use crate::input::Folder;
use crate::model::AnyBody;
use crate::run::body::BodyProblem;
use crate::run::{RunOptions, prepare};
use crate::scene::Scene;
use serde_json::{Value, json};
use std::path::Path;

/// A plate of 2 × 1 with its lower left corner at (1, −0.5), thickness 0.1, and what a test adds to the case.
pub(crate) fn plate(more: Value) -> Value {
    let mut case = json!({
        "title": "plate",
        "model": { "bond_plane": { "youngs_modulus": 1e9, "state": "plane_stress", "thickness": 0.1 } },
        "body": { "rectangle": { "from": [1.0, -0.5], "size": [2.0, 1.0], "spacing": 0.1 } },
        "supports": [
            { "at": { "x": 1.0, "y": -0.5 }, "ux": 0.0, "uy": 0.0 },
            { "at": { "x": 3.0, "y": -0.5 }, "uy": 0.0 }
        ]
    });
    for (key, value) in more.as_object().unwrap() {
        case[key] = value.clone();
    }
    case
}

fn scene(case: &Value) -> BodyScene {
    let source = case::from_text("case", case.to_string(), &[], &Folder::default())
        .unwrap_or_else(|report| panic!("{report}"));
    let scene = Scene::new(source.case, Path::new("."), "case", &source.text, None);
    scene.unwrap_or_else(|report| panic!("{report}")).into_body().unwrap()
}

/// The loads of the first state, and their force and moment about the origin.
fn loads(scene: &BodyScene) -> (Vec<f64>, [f64; 3]) {
    let n = scene.model.points();
    let mut force = vec![0.0; 2 * n];
    scene.load_cases[0].add_to(&*scene.model, 1.0, &mut force);
    let mut total = [0.0; 3];
    for p in 0..n {
        let ([x, y], [fx, fy]) = (scene.model.place(p), [force[p], force[n + p]]);
        total = [total[0] + fx, total[1] + fy, total[2] + x * fy - y * fx];
    }
    (force, total)
}

fn check_total(more: Value, expected: [f64; 3]) {
    let (force, total) = loads(&scene(&plate(more.clone())));
    let size: f64 = force.iter().map(|f| f.abs()).sum::<f64>();
    for (found, expected) in total.iter().zip(&expected) {
        assert!((found - expected).abs() < 1e-12 * 3.0 * size, "{more}: {total:?} {expected:?}");
    }
}

fn traction(edge: &str, key: &str, value: Value) -> Value {
    let mut traction = json!({ "edge": edge });
    traction[key] = value;
    json!({ "traction": traction })
}

#[test]
fn force_and_moment_of_every_load_are_exact() {
    let loads = |load: Value| json!({ "loads": [load] });
    let point = json!({ "point": { "at": { "x": 1.95, "y": 0.05 }, "force_x": 3.0, "force_y": -2.0 } });
    check_total(loads(point), [3.0, -2.0, 1.95 * -2.0 - 0.05 * 3.0]);
    // The region of an edge is centred on it, half a spacing inside.
    let shared = json!({ "point": { "at": { "region": "right" }, "force_x": 3.0, "force_y": -2.0 } });
    check_total(loads(shared), [3.0, -2.0, 2.95 * -2.0]);
    let weight = json!({ "body_force": { "density": [0.0, -5.0] } });
    check_total(loads(weight), [0.0, -1.0, -2.0]);
    let total = json!({ "body_force": { "region": "top", "total": [4.0, 0.0] } });
    check_total(loads(total), [4.0, 0.0, -0.45 * 4.0]);
    for sharing in ["lumped", "consistent"] {
        let on = |edge: &str, key: &str, value: Value| {
            let mut load = traction(edge, key, value);
            load["traction"]["sharing"] = sharing.into();
            loads(load)
        };
        // ∫ t ds and ∫ x × t ds with a thickness of 0.1, by hand.
        check_total(on("right", "uniform", json!([10.0, 4.0])), [1.0, 0.4, 3.0 * 0.4]);
        check_total(on("top", "uniform", json!([10.0, 4.0])), [2.0, 0.8, 2.0 * 0.8 - 0.5 * 2.0]);
        // From the lower to the upper end: 10 (2 y) along x has the moment −∫ y 20 y dy = −20/12.
        check_total(
            on("right", "linear", json!([[-10.0, 0.0], [10.0, 0.0]])),
            [0.0, 0.0, -0.1 * 20.0 / 12.0],
        );
        check_total(on("left", "linear", json!([[0.0, 0.0], [0.0, 6.0]])), [0.0, 0.3, 0.3]);
        check_total(on("right", "parabolic", json!([0.0, -30.0])), [0.0, -2.0, -6.0]);
        check_total(on("bottom", "parabolic", json!([3.0, 6.0])), [0.4, 0.8, 2.0 * 0.8 + 0.5 * 0.4]);
        check_total(on("right", "pressure", json!(7.0)), [-0.7, 0.0, 0.0]);
        check_total(on("top", "total", json!([2.0, -5.0])), [2.0, -5.0, -10.0 - 1.0]);
    }
}

#[test]
fn tractions_around_holes_have_exact_totals() {
    let holes = json!([
        { "circle": { "name": "ring", "centre": [1.5, 0.0], "radius": 0.2 } },
        { "slot": { "name": "slot", "from": [2.2, -0.1], "to": [2.5, 0.2], "radius": 0.15 } },
        { "polygon": { "name": "notch", "vertices": [[2.8, 0.2], [3.2, 0.2], [3.2, 0.3], [2.8, 0.3]] } }
    ]);
    let body =
        json!({ "rectangle": { "from": [1.0, -0.5], "size": [2.0, 1.0], "spacing": 0.05, "holes": holes } });
    let more = |load: Value| json!({ "body": body.clone(), "loads": [load] });
    for name in ["ring", "slot"] {
        check_total(more(traction(name, "pressure", json!(5.0))), [0.0; 3]);
    }
    check_total(more(traction("ring", "total", json!([2.0, -3.0]))), [2.0, -3.0, 1.5 * -3.0]);
    check_total(more(traction("slot", "total", json!([2.0, 0.0]))), [2.0, 0.0, -0.05 * 2.0]);
}

/// A linear displacement of a stress, with some displacement at the origin and some rotation.
fn linear(scene: &BodyScene, stress: [f64; 3], shift: [f64; 2], turn: f64) -> Vec<f64> {
    let [xx, yy, xy] = scene.model.as_plane().unwrap().strain_of(stress);
    let n = scene.model.points();
    let at = |p: usize| scene.model.place(p);
    let x = (0..n).map(|p| shift[0] + xx * at(p)[0] + (0.5 * xy - turn) * at(p)[1]);
    let y = (0..n).map(|p| shift[1] + (0.5 * xy + turn) * at(p)[0] + yy * at(p)[1]);
    x.chain(y).collect()
}

/// Whether a displacement is in equilibrium with the loads of a case where nothing holds it, to 1e-12 of its forces.
fn check_equilibrium(scene: &BodyScene, u: &[f64]) {
    let AnyBody::Two(body) = &scene.model else { panic!("central bonds") };
    let problem = BodyProblem::new(scene, body.clone());
    let (system, _) =
        prepare::<2>(&problem, &RunOptions::default()).unwrap_or_else(|error| panic!("{error:?}"));
    let (load, _) = loads(scene);
    let mut force = vec![0.0; u.len()];
    system.force(u, &mut force);
    let size = force.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
    let mut rest: Vec<f64> = force.iter().zip(&load).map(|(f, l)| f - l).collect();
    system.constraints().restrict(&mut rest);
    let largest = rest.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
    assert!(size > 0.0 && largest < 1e-12 * size, "{largest:e} of {size:e}");
    let mut expanded = u.to_vec();
    system.constraints().expand(1.0, &mut expanded);
    let displacement = u.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let moved = u.iter().zip(&expanded).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
    assert!(moved < 1e-12 * displacement, "{moved:e} of {displacement:e}");
}

#[test]
fn tractions_of_one_stress_have_its_linear_displacement() {
    let all = [
        traction("right", "uniform", json!([3e6, 1e6])),
        traction("left", "uniform", json!([-3e6, -1e6])),
        traction("top", "uniform", json!([1e6, -2e6])),
        traction("bottom", "uniform", json!([-1e6, 2e6])),
    ];
    let (stress, corner) = ([3e6, -2e6, 1e6], [1.05, -0.45]);
    let scene = scene(&plate(json!({ "loads": all })));
    // They act through the border.
    assert!(scene.load_cases[0].stresses.is_empty() && !scene.load_cases[0].forces.is_empty());
    // No motion at the lower left corner, no rotation of the line to the right one.
    let [xx, yy, xy] = scene.model.as_plane().unwrap().strain_of(stress);
    let turn = -0.5 * xy;
    let shift = [-xx * corner[0] - xy * corner[1], -yy * corner[1]];
    check_equilibrium(&scene, &linear(&scene, stress, shift, turn));
}

#[test]
fn pulls_against_rollers_and_mirrors_are_exact() {
    let pull = json!([traction("right", "uniform", json!([2e6, 0.0]))]);
    let rollers = json!([
        { "at": { "region": "left" }, "ux": 0.0 },
        { "at": { "x": 1.0, "y": -0.5 }, "uy": 0.0 }
    ]);
    let held = scene(&plate(json!({ "loads": pull, "supports": rollers })));
    let [xx, yy, _] = held.model.as_plane().unwrap().strain_of([2e6, 0.0, 0.0]);
    // The edge is held, not its points: nothing moves along x at x = 1.
    check_equilibrium(&held, &linear(&held, [2e6, 0.0, 0.0], [-xx, 0.45 * yy], 0.0));
    // What the stress does to the held edge is taken back there: the resultant is that of the traction.
    let total = loads(&held).1;
    assert!((total[0] - 2e5).abs() < 1e-7 && total[1].abs() < 1e-7 && total[2].abs() < 1e-7, "{total:?}");
    let mirrors = json!({ "loads": pull, "supports": [], "symmetry": ["left", "bottom"] });
    let mirrored = scene(&plate(mirrors));
    assert!(mirrored.model.points() > 200);
    check_equilibrium(&mirrored, &linear(&mirrored, [2e6, 0.0, 0.0], [-xx, 0.5 * yy], 0.0));
}

#[test]
fn pressure_on_everything_is_exact_around_holes_too() {
    let holes = json!([{ "circle": { "name": "hole", "centre": [2.0, 0.0], "radius": 0.23 } }]);
    let body =
        json!({ "rectangle": { "from": [1.0, -0.5], "size": [2.0, 1.0], "spacing": 0.1, "holes": holes } });
    let edges = ["left", "right", "top", "bottom", "hole"];
    let all: Vec<Value> = edges.iter().map(|edge| traction(edge, "pressure", json!(1e6))).collect();
    let scene = scene(&plate(json!({ "body": body, "loads": all })));
    let [xx, yy, _] = scene.model.as_plane().unwrap().strain_of([-1e6, -1e6, 0.0]);
    check_equilibrium(&scene, &linear(&scene, [-1e6, -1e6, 0.0], [-1.05 * xx, 0.45 * yy], 0.0));
}

#[test]
fn a_crack_across_a_pull_is_not_held_shut_by_a_uniform_stress() {
    let loads = json!([
        traction("right", "uniform", json!([1e6, 0.0])),
        traction("left", "uniform", json!([-1e6, 0.0]))
    ]);
    let stresses = |path: Value| {
        let mut case = plate(json!({ "loads": loads, "cracks": [{ "path": path }] }));
        case["model"]["bond_plane"]["edges"] = json!("overlay");
        let scene = scene(&case);
        scene.load_cases[0].stresses.iter().filter(|s| s.points.is_none()).count()
    };
    assert_eq!(stresses(json!([[2.0, 0.8], [2.0, 0.1]])), 0);
    assert_eq!(stresses(json!([[1.6, 0.0], [2.4, 0.0]])), 1);
}
