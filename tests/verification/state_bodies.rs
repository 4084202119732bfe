//! Spheres, bars, shafts and half spaces of state-based families against closed forms.

use super::state_based::{errors, orders};
use crate::support::plane::{displacements, probe, solve};
use peristat::case::FieldName;
use serde_json::json;
use std::f64::consts::{FRAC_PI_2, PI};

const NU: f64 = 0.3;

/// A quarter of a hollow sphere of radii 0.5 and 1 with n points through its wall.
fn sphere(n: u32) -> [f64; 2] {
    let on_arc = |k: u32| (f64::from(k) * FRAC_PI_2 / 96.0).sin_cos();
    let arc = (1..96).map(on_arc).map(|(sin, cos)| [cos, sin]);
    let vertices: Vec<[f64; 2]> =
        [[0.0, 0.0], [1.0, 0.0]].into_iter().chain(arc).chain([[0.0, 1.0]]).collect();
    let hole = json!({ "circle": { "name": "cavity", "centre": [0, 0], "radius": 0.5 } });
    let run = displacements(&json!({
        "title": "sphere",
        "model": { "axisymmetric": { "youngs_modulus": 1, "poisson_ratio": NU } },
        "body": { "outline": { "vertices": vertices, "spacing": 0.5 / f64::from(n), "holes": [hole] } },
        "symmetry": ["bottom"],
        "loads": [{ "traction": { "edge": "cavity", "pressure": 1, "depth": 0.5 } }]
    }));
    let along = 1.0 / 7.0;
    let u = |r: f64| along * ((1.0 - 2.0 * NU) * r + 0.5 * (1.0 + NU) / (r * r));
    assert!((u(0.5) - 0.4).abs() < 1e-12 && (u(1.0) - 0.15).abs() < 1e-12);
    errors(&run, |[x, y]| {
        let r = x.hypot(y);
        [x, y].map(|c| u(r) * c / r)
    })
}

#[test]
fn a_hollow_sphere_converges_to_lame() {
    // Means: 5.4e-3 and 1.7e-3.
    let [coarse, fine] = [16, 32].map(|n| sphere(n)[1]);
    assert!(coarse < 1.2e-2 && fine < 3e-3, "{coarse:e} {fine:e}");
}

#[test]
fn a_solid_bar_is_exact_on_its_axis_too() {
    let run = solve(&json!({
        "title": "bar",
        "model": { "axisymmetric": { "youngs_modulus": 1, "poisson_ratio": NU } },
        "body": { "rectangle": { "size": [0.5, 1], "spacing": 0.0625 } },
        "symmetry": ["bottom"],
        "loads": [{ "traction": { "edge": "top", "uniform": [0, 1] } }]
    }));
    let error = run.error(0, |[x, y]| [-NU * x, y]);
    assert!(error < 1e-11, "{error:e}");
    let hoop = run.field(0, FieldName::StressZz).into_iter().fold(0.0, |a: f64, s| a.max(s.abs()));
    assert!(hoop < 1e-11, "{hoop:e}");
}

#[test]
fn a_spinning_shaft_converges_with_the_square_of_the_spacing() {
    let shaft = |n: u32| {
        let spacing = 1.0 / f64::from(n);
        let run = displacements(&json!({
            "title": "shaft",
            "model": { "axisymmetric": { "youngs_modulus": 1, "poisson_ratio": NU } },
            "body": { "rectangle": { "size": [1, spacing], "spacing": spacing } },
            "periodic": [{ "along": "y" }],
            "supports": [{ "at": { "x": 0.5 * spacing, "y": 0.5 * spacing }, "uy": 0 }],
            "density": 1,
            "loads": [{ "spin": { "omega": 1 } }]
        }));
        errors(&run, |[r, _]| [0.2228571428571429 * r - 0.0928571428571429 * r.powi(3), 0.0])[0]
    };
    // 1.4e-3 and 3.6e-4.
    let found = [40, 80].map(shaft);
    assert!(found[0] < 2.5e-3, "{found:?}");
    assert!(orders(&found)[0] >= 1.8, "{found:?}");
}

#[test]
fn a_contact_pressure_settles_a_half_space() {
    // 10 contact radii, 8 points over one: the middle against the edge of the contact, π p₀ a/(4 E*).
    let settlement = |points: u32| {
        let spacing = 1.0 / f64::from(points);
        let [top, edge] = [10.0 - 0.5 * spacing, 1.0 - 0.5 * spacing];
        let case = json!({
            "title": "contact",
            "model": { "axisymmetric": { "youngs_modulus": 1, "poisson_ratio": NU } },
            "body": { "rectangle": { "size": [10, 10], "spacing": spacing } },
            "horizon_ratio": 2, "symmetry": ["bottom"],
            "loads": [{ "traction": { "edge": "top", "hertz": { "radius": 1, "peak": 1 } } }],
            "probes": [
                { "name": "middle", "at": { "x": 0.5 * spacing, "y": top }, "field": "uy" },
                { "name": "edge", "at": { "x": edge, "y": top }, "field": "uy" }
            ]
        });
        let exact = 0.25 * PI * (1.0 - NU * NU) * (edge * edge - 0.25 * spacing * spacing);
        (probe(&case, "edge") - probe(&case, "middle")) / exact - 1.0
    };
    let found = [8, 16].map(|points| settlement(points).abs());
    assert!(found[1] < 0.06 && found[1] < found[0], "{found:?}");
}
