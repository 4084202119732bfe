//! Forces of tractions on bodies of revolution: what is asked for is what the supports take.

use crate::support::plane::probe;
use serde_json::{Value, json};
use std::f64::consts::TAU;

/// Axial reaction of a ring of radii 20 to 100 and this height, mm, that is held all along an edge.
fn reaction(height: f64, (spacing, held): (f64, &str), traction: &Value) -> f64 {
    let case = json!({
        "title": "ring", "units": "mm-N-MPa",
        "model": { "axisymmetric": { "youngs_modulus": 200_000.0, "poisson_ratio": 0.3 } },
        "body": { "rectangle": { "from": [20, 0], "size": [80, height], "spacing": spacing } },
        "supports": [{ "at": { "region": held }, "ux": 0, "uy": 0 }],
        "loads": [{ "traction": traction }],
        "probes": [{ "name": "R", "at": { "region": held }, "field": "reaction_y" }]
    });
    probe(&case, "R")
}

/// An axial shear on the rim or in the bore has 2π r t τ, however deep it reaches: measured 4e-15 of it. With the shear that a
/// ring has beside that in the plane counted twice it was off by the depth over twice the radius.
#[test]
fn an_axial_shear_has_its_force_at_every_depth() {
    for (edge, held, radius) in [("right", "left", 100.0), ("left", "right", 20.0)] {
        let expected = TAU * radius * 20.0 * 3.0;
        for depth in [None, Some(4.0), Some(20.0), Some(40.0), Some(80.0)] {
            let mut loads = vec![
                json!({ "edge": edge, "uniform": [0, -3] }),
                json!({ "edge": edge, "total": [0, -expected] }),
                json!({ "edge": edge, "linear": [[0, 0], [0, -6]] }),
                json!({ "edge": edge, "parabolic": [0, -4.5] }),
            ];
            for load in &mut loads {
                if let Some(depth) = depth {
                    load["depth"] = json!(depth);
                }
                let found = reaction(20.0, (2.0, held), load);
                assert!((found / expected - 1.0).abs() < 1e-12, "{load}: {found} {expected}");
            }
        }
    }
}

/// A radial shear on the top has no force along the axis: measured 2e-12 of its radial reaction.
#[test]
fn a_radial_shear_on_top_has_no_axial_force() {
    let size = 3.0 * 0.5 * TAU * (100.0_f64.powi(2) - 20.0_f64.powi(2));
    for depth in [2.0, 10.0, 20.0] {
        let load = json!({ "edge": "top", "uniform": [3, 0], "depth": depth });
        let found = reaction(20.0, (1.0, "left"), &load);
        assert!(found.abs() < 1e-11 * size, "{depth}: {found}");
    }
}

/// A rubber bush, ν = 0.499, and a hub with a flange.
#[test]
fn bushes_and_hubs_take_the_force_of_their_shear() {
    let bush = json!({
        "title": "bush", "units": "mm-N-MPa",
        "model": { "axisymmetric": { "youngs_modulus": 6.0, "poisson_ratio": 0.499 } },
        "body": { "rectangle": { "from": [20, 0], "size": [40, 30], "spacing": 1.0 } },
        "supports": [{ "at": { "region": "right" }, "ux": 0, "uy": 0 }],
        "loads": [{ "traction": { "edge": "left", "uniform": [0, 1] } }],
        "probes": [{ "name": "R", "at": { "region": "right" }, "field": "reaction_y" }]
    });
    let expected = -TAU * 20.0 * 30.0;
    // Measured 2e-15.
    assert!((probe(&bush, "R") / expected - 1.0).abs() < 1e-12);
    let hub = json!({
        "title": "hub", "units": "mm-N-MPa",
        "model": { "axisymmetric": { "youngs_modulus": 200_000.0, "poisson_ratio": 0.3 } },
        "body": { "outline": { "spacing": 1.0,
                               "vertices": [[20, 0], [100, 0], [100, 10], [40, 10], [40, 60], [20, 60]] } },
        "supports": [{ "at": { "region": "edge_5" }, "uy": 0, "ux": 0 }],
        "loads": [{ "traction": { "edge": "edge_2", "uniform": [0, -2] } }],
        "probes": [{ "name": "R", "at": { "region": "edge_5" }, "field": "reaction_y" }]
    });
    let expected = TAU * 100.0 * 10.0 * 2.0;
    // Measured 5e-12: multigrid ends there.
    assert!((probe(&hub, "R") / expected - 1.0).abs() < 2e-11);
}
