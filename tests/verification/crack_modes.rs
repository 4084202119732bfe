//! Modes of slanted cracks: closed forms, and what holds on any grid.

use serde_json::{Value, json};

/// Whether a value is another one to a share of it.
fn assert_near(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found} {expected}");
}

/// K, K_I, K_II and G of the upper end of a crack between two positions in a square of 80 mm under 100 MPa along y.
fn modes(from: [f64; 2], to: [f64; 2], loads: &Value) -> [f64; 4] {
    let asked = |name: &str| json!({ "name": name, "crack": "slant", "tips": "end", "quantity": name });
    let asked = ["k", "k_i", "k_ii", "energy_release_rate"].map(asked);
    let case = json!({
        "title": "Slanted crack",
        "units": "mm-N-MPa",
        "model": { "bond_plane": { "youngs_modulus": 70000, "state": "plane_stress" } },
        "horizon_ratio": 2,
        "body": { "rectangle": { "from": [-40, -40], "size": [80, 80], "spacing": 1 } },
        "cracks": [ { "name": "slant", "path": [from, to] } ],
        "supports": [
            { "at": { "x": 39.5, "y": -39.5 }, "ux": 0, "uy": 0 },
            { "at": { "x": 38.5, "y": -39.5 }, "uy": 0 }
        ],
        "loads": loads,
        "stress_intensity": asked
    });
    let summary = peristat::solve_text(&format!("{case:#}")).expect("a case that can be solved").summary;
    let value =
        |name: &str| summary.probes.iter().find(|p| p.name == name).expect("a probe of this name").value;
    ["k", "k_i", "k_ii", "energy_release_rate"].map(value)
}

#[test]
fn the_modes_of_a_slanted_crack_sum_to_its_release_rate() {
    let pull = json!([
        { "traction": { "edge": "top", "pressure": -100 } },
        { "traction": { "edge": "bottom", "pressure": -100 } }
    ]);
    let [k, one, two, rate] = modes([-8.0, -8.5], [8.0, 7.5], &pull);
    assert_near(one.hypot(two), k, 1e-12);
    assert_near(rate, k * k / 70000.0, 1e-12);
    // The mirror image slides the other way.
    let [_, other, back, _] = modes([8.0, -8.5], [-8.0, 7.5], &pull);
    assert_near(other, one, 1e-6);
    assert_near(back, -two, 1e-6);
    // σ√(πa) cos²β and σ√(πa) sinβ cosβ times 1.11 for the square: 1 % and 3 % are found.
    let expected = 100.0 * (std::f64::consts::PI * 128.0_f64.sqrt()).sqrt() / 2.0 * 1.109;
    assert_near(one, expected, 0.03);
    assert_near(two, expected, 0.06);
}

#[test]
fn a_crack_in_pure_shear_does_not_open() {
    let shear = json!([
        { "traction": { "edge": "top", "uniform": [100, 0] } },
        { "traction": { "edge": "bottom", "uniform": [-100, 0] } },
        { "traction": { "edge": "right", "uniform": [0, 100] } },
        { "traction": { "edge": "left", "uniform": [0, -100] } }
    ]);
    let [k, one, two, _] = modes([-12.0, 0.0], [12.0, 0.0], &shear);
    assert!(one.abs() < 1e-6 * k, "{one}");
    assert_near(two, k, 1e-12);
}
