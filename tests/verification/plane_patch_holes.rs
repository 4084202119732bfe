//! Patch tests of bodies with holes.

use crate::plane_patch::{EXACT, MODULUS, RATIOS, STRESSES, UNITS, check_fields, gradient, held, linear};
use crate::support::plane::solve;
use serde_json::{Value, json};

/// A rectangle of 44 × 30 with a round hole and a square one, of which all points near borders follow a linear displacement,
/// one support each.
fn with_holes(g: [[f64; 2]; 2], ratio: f64, [length, stress]: [f64; 2]) -> Value {
    let reach = 2.0 * ratio.floor() + 0.5;
    let near = |[x, y]: [f64; 2]| {
        let to_edge = x.min(44.0 - x).min(y).min(30.0 - y);
        let to_circle = (x - 12.0).hypot(y - 15.0) - 3.2;
        let to_square = (x - 33.0).abs().max((y - 15.0).abs()) - 3.0;
        to_edge.min(to_circle).min(to_square) < reach
    };
    let inside = |[x, y]: [f64; 2]| {
        (x - 12.0).hypot(y - 15.0) > 3.2 && ((x - 33.0).abs() > 3.0 || (y - 15.0).abs() > 3.0)
    };
    let places = (0..44 * 30).map(|k| [f64::from(k % 44) + 0.5, f64::from(k / 44) + 0.5]);
    let held = places.filter(|p| inside(*p) && near(*p)).map(|p| {
        let at = p.map(|x| x * length);
        let u = linear(g, [0.0; 2])(at);
        json!({ "at": { "x": at[0], "y": at[1] }, "ux": u[0], "uy": u[1] })
    });
    let square = [[30, 12], [36, 12], [36, 18], [30, 18]].map(|p| p.map(|x| f64::from(x) * length));
    json!({
        "title": "patch with holes",
        "model": { "bond_plane": { "youngs_modulus": MODULUS * stress, "state": "plane_strain" } },
        "body": { "rectangle": { "size": [44.0 * length, 30.0 * length], "spacing": length, "holes": [
            { "circle": { "centre": [12.0 * length, 15.0 * length], "radius": 3.2 * length } },
            { "polygon": { "vertices": square } } ] } },
        "horizon_ratio": ratio, "solver": "sparse",
        "supports": held.collect::<Vec<Value>>()
    })
}

#[test]
fn uniform_strains_are_exact_around_holes() {
    for (ratio, units) in RATIOS[..4].iter().flat_map(|m| UNITS.map(|u| (*m, u))) {
        for relative in STRESSES {
            let g = gradient("plane_strain", relative.map(|s| 100.0 / MODULUS * s));
            let run = solve(&with_holes(g, ratio, units));
            assert!(run.report.sizes.unknowns > 0 || ratio > 3.5, "nothing is free to be wrong");
            let name = format!("m = {ratio}, {units:?}, {relative:?}");
            check_fields(&run, 0, relative.map(|s| 100.0 * s * units[1]), EXACT, &name);
            let error = run.error(0, linear(g, [0.0; 2]));
            assert!(error <= EXACT, "{name}: displacement {error}");
        }
    }
}

#[test]
fn pressure_on_every_border_is_exact_around_holes() {
    for (ratio, solver, tolerance) in
        [(2.0, "sparse", EXACT), (3.0, "sparse", EXACT), (3.0, "multigrid", 1e-9)]
    {
        let pressure = |edge: &str| json!({ "traction": { "edge": edge, "pressure": 50.0 } });
        let edges = ["left", "right", "bottom", "top", "eye", "slot"];
        let case = json!({
            "title": "pressure",
            "model": { "bond_plane": { "youngs_modulus": MODULUS, "state": "plane_stress" } },
            "body": { "rectangle": { "size": [64, 48], "spacing": 1, "holes": [
                { "circle": { "name": "eye", "centre": [16, 20], "radius": 6 } },
                { "slot": { "name": "slot", "from": [36, 14], "to": [52, 34], "radius": 2.5 } } ] } },
            "horizon_ratio": ratio, "solver": solver,
            "supports": held([[0.5, 0.5], [63.5, 0.5]], |_| [0.0; 2]),
            "loads": edges.map(pressure)
        });
        let run = solve(&case);
        assert_eq!(run.report.solver.method.contains("multigrid"), solver == "multigrid");
        check_fields(&run, 0, [-50.0, -50.0, 0.0], tolerance, solver);
        let strain = gradient("plane_stress", [-50.0 / MODULUS, -50.0 / MODULUS, 0.0]);
        let error = run.error(0, linear(strain, [0.5, 0.5]));
        assert!(error <= tolerance, "{solver}: displacement {error}");
    }
}
