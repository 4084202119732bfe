//! Modes at places of the fronts of cracks in solids.

use serde_json::{Value, json};
use std::collections::BTreeMap;

/// Values by name, and how often it is warned of a slanted crack.
fn warned_probes(case: &Value) -> (BTreeMap<String, f64>, usize) {
    let solved = peristat::solve_text(&case.to_string()).unwrap_or_else(|error| panic!("{error}"));
    let values = solved.summary.probes.iter().map(|probe| (probe.name.clone(), probe.value)).collect();
    (values, solved.summary.warnings.iter().filter(|warning| warning.contains("slanted")).count())
}

fn probes(case: &Value) -> BTreeMap<String, f64> {
    let (values, warnings) = warned_probes(case);
    assert_eq!(warnings, 0);
    values
}

/// Half of a cube of side 4 with a round crack of radius 1 across z in its middle, sheared along x, and what is asked at some angles.
fn sheared(angles: &[f64], normal: [f64; 3]) -> Value {
    let asked = angles.iter().flat_map(|angle| {
        let (sin, cos) = angle.to_radians().sin_cos();
        ["k_i", "k_ii", "k_iii", "stress_intensity", "energy_release_rate"].map(|quantity| {
            let mut asked =
                json!({ "name": format!("{quantity} {angle}"), "crack": "penny", "at": [cos, sin, 0] });
            if quantity != "stress_intensity" {
                asked["quantity"] = json!(quantity);
            }
            asked
        })
    });
    json!({
        "title": "penny", "units": "none", "model": { "bond_solid": { "youngs_modulus": 1000 } },
        "body": { "block": { "from": [-2, 0, -2], "size": [4, 2, 4], "spacing": 0.125 } }, "symmetry": ["bottom"],
        "cracks": [ { "name": "penny", "disc": { "centre": [0, 0, 0], "normal": normal, "radius": 1 } } ],
        "supports": [ { "at": { "region": "back" }, "ux": 0, "uz": 0 } ],
        "loads": [ { "traction": { "face": "front", "uniform": [1, 0, 0] } },
            { "traction": { "face": "right", "uniform": [0, 0, 1] } },
            { "traction": { "face": "left", "uniform": [0, 0, -1] } } ],
        "stress_intensity": asked.collect::<Vec<_>>()
    })
}

#[test]
fn a_sheared_crack_slides_across_and_along_its_front() {
    let angles = [0.0, 30.0, 60.0, 90.0, 150.0];
    let found = probes(&sheared(&angles, [0.0, 0.0, 1.0]));
    let turned = probes(&sheared(&angles, [0.0, 0.0, -1.0]));
    // Kassir and Sih (1966): K_II = 4/(2 - nu) sqrt(a/pi) cos, K_III = (1 - nu) 4/(2 - nu) sqrt(a/pi) sin.
    let whole = 4.0 / 1.75 * std::f64::consts::FRAC_1_PI.sqrt();
    for angle in angles {
        let (sin, cos) = f64::to_radians(angle).sin_cos();
        let of = |quantity: &str| found[&format!("{quantity} {angle}")];
        let errors =
            [of("k_i"), of("k_ii") - whole * cos, of("k_iii") - 0.75 * whole * sin].map(|e| e / whole);
        // 0.006, 0.104 and 0.083 found: points beside faces that slide are too soft along them, and the cube is two radii deep.
        assert!(
            errors[0].abs() < 0.01 && errors[1].abs() < 0.11 && errors[2].abs() < 0.09,
            "{angle}: {errors:.3?}"
        );
        let square = of("k_i").powi(2) + of("k_ii").powi(2) + of("k_iii").powi(2) / 0.75;
        assert!((of("stress_intensity").powi(2) / square - 1.0).abs() < 1e-12);
        let rate = of("energy_release_rate") * 1000.0 / (1.0 - 0.0625);
        assert!((rate / square - 1.0).abs() < 1e-12);
        // Seen from the other side it slides the other way across the front, and the same way along it.
        for (quantity, sign) in [("k_i", 1.0), ("k_ii", -1.0), ("k_iii", 1.0)] {
            let other = turned[&format!("{quantity} {angle}")];
            assert!((other - sign * of(quantity)).abs() < 1e-9 * whole, "{quantity} {angle}: {other}");
        }
    }
}

#[test]
fn a_slanted_crack_opens_as_one_along_layers_does() {
    // A cube of side 5 with a disc of radius 1 in its middle under one tension in all directions, which adds 5.3 % to K_I: by the third
    // power of the side from the 1.3 % of a side of 8.
    let normal = [1.0, 2.0, 3.0_f64];
    let length = normal.iter().map(|n| n * n).sum::<f64>().sqrt();
    let n = normal.map(|k| k / length);
    let across = [n[1], -n[0], 0.0].map(|k| k / n[0].hypot(n[1]));
    let along = [-n[2] * across[1], n[2] * across[0], n[0] * across[1] - n[1] * across[0]];
    let angles: Vec<f64> = (0..12).map(|k| 30.0 * f64::from(k) + 7.0).collect();
    let asked = angles.iter().flat_map(|angle| {
        let (sin, cos) = angle.to_radians().sin_cos();
        let at = [0, 1, 2].map(|k| cos * across[k] + sin * along[k]);
        ["k_i", "k_ii", "k_iii"].map(|quantity| {
            json!({ "name": format!("{quantity} {angle}"), "crack": "penny", "quantity": quantity, "at": at })
        })
    });
    let held = |at: [f64; 3], axes: &[&str]| {
        let mut support = json!({ "at": { "x": at[0], "y": at[1], "z": at[2] } });
        axes.iter().for_each(|axis| support[*axis] = json!(0));
        support
    };
    let corner = 2.5 - 1.0 / 12.0;
    let faces = ["left", "right", "bottom", "top", "back", "front"];
    let case = json!({
        "title": "slanted", "units": "none", "model": { "bond_solid": { "youngs_modulus": 1000 } },
        "body": { "block": { "from": [-2.5, -2.5, -2.5], "size": [5, 5, 5], "spacing": 1.0 / 6.0 } },
        "cracks": [ { "name": "penny", "disc": { "centre": [0.01, 0.02, 0.03], "normal": normal, "radius": 1 } } ],
        "supports": [ held([-corner; 3], &["ux", "uy", "uz"]), held([corner, -corner, -corner], &["uy", "uz"]),
            held([-corner, corner, -corner], &["uz"]) ],
        "loads": faces.map(|face| json!({ "traction": { "face": face, "pressure": -1 } })),
        "stress_intensity": asked.collect::<Vec<_>>()
    });
    let (found, warnings) = warned_probes(&case);
    assert_eq!(warnings, 1);
    let exact = 1.053 * 2.0 * std::f64::consts::FRAC_1_PI.sqrt();
    let of =
        |quantity: &str| angles.iter().map(|a| found[&format!("{quantity} {a}")] / exact).collect::<Vec<_>>();
    let opening = of("k_i");
    let mean = opening.iter().sum::<f64>() / opening.len() as f64;
    let apart = opening.iter().map(|k| (k - 1.0).abs()).fold(0.0, f64::max);
    let sliding = of("k_ii").into_iter().chain(of("k_iii")).map(f64::abs).fold(0.0, f64::max);
    // Measured: 1.007, 0.063, 0.021.
    assert!((mean - 1.0).abs() < 0.01 && apart < 0.07 && sliding < 0.03, "{mean:.3} {apart:.3} {sliding:.3}");
}

#[test]
fn fronts_of_halves_and_of_polygons_are_those_of_the_whole() {
    let bar = |mirror: bool, crack: Value| {
        let from = if mirror { 0.0 } else { -2.0 };
        let mut case = json!({
            "title": "bar", "units": "none", "model": { "bond_solid": { "youngs_modulus": 1000 } },
            "body": { "block": { "from": [0, from, 0], "size": [2, 2.0 - from, 1], "spacing": 0.125 } },
            "symmetry": ["back", "front"], "cracks": [crack],
            "supports": [ { "at": { "x": 1.9375, "y": 0.0625, "z": 0.5 }, "ux": 0 } ],
            "loads": [ { "traction": { "face": "top", "uniform": [0, 1, 0] } } ],
            "stress_intensity": [ { "name": "K", "crack": 1, "quantity": "k_i", "at": [1, 0, 0.5] } ]
        });
        if mirror {
            case["symmetry"] = json!(["bottom", "back", "front"]);
        } else {
            case["supports"] = json!([ { "at": { "x": 1.9375, "y": 0.0625, "z": 0.5 }, "ux": 0, "uy": 0 },
                { "at": { "x": 1.9375, "y": -0.0625, "z": 0.5 }, "ux": 0 } ]);
            case["loads"] = json!([ { "traction": { "face": "top", "uniform": [0, 1, 0] } },
                { "traction": { "face": "bottom", "uniform": [0, -1, 0] } } ]);
        }
        probes(&case)["K"]
    };
    let corners = json!([[-1, 0, 0], [1, 0, 0], [1, 0, 1], [-1, 0, 1]]);
    let turned = json!([[-1, 0, 1], [1, 0, 1], [1, 0, 0], [-1, 0, 0]]);
    let whole = bar(false, json!({ "polygon": corners }));
    for found in [bar(true, json!({ "polygon": corners })), bar(true, json!({ "polygon": turned }))] {
        assert!((found / whole - 1.0).abs() < 1e-8, "{found} {whole}");
    }
    // Tada, Paris and Irwin: 2.826 sigma sqrt(pi a) for half of the width.
    let expected = 2.826 * std::f64::consts::PI.sqrt();
    // 0.76 % less found.
    assert!((whole / expected - 1.0).abs() < 0.008, "{}", whole / expected - 1.0);
}
