//! Long cracks grow where Griffith says, whatever their direction on the lattice.

use crate::support::breaking::{growing, solve};
use serde_json::{Value, json};

const YOUNGS_MODULUS: f64 = 3000.0;
const RELEASE_RATE: f64 = 0.3;
const SIZE: [f64; 2] = [48.0, 16.0];
const MOTION: f64 = 0.1;

/// A ribbon between grips at an angle to the rows, with a crack along a third of it.
fn ribbon(angle: f64, model: Value, horizon_ratio: f64) -> Value {
    let (s, c) = angle.to_radians().sin_cos();
    let shift = if angle == 0.0 { [0.0, 0.0] } else { [37.123, 5.377] };
    let at = |x: f64, y: f64| [c * x - s * y + shift[0], s * x + c * y + shift[1]];
    let [length, width] = SIZE;
    let corners = [at(0.0, 0.0), at(length, 0.0), at(length, width), at(0.0, width)];
    // Beside the points, wherever they are.
    let middle = 0.5 * width + if angle == 0.0 { 0.0 } else { 0.013 };
    let (body, grips) = match angle == 0.0 {
        true => (json!({ "rectangle": { "size": SIZE, "spacing": 1.0 } }), ["bottom", "top"]),
        false => (json!({ "outline": { "vertices": corners, "spacing": 1.0 } }), ["edge_1", "edge_3"]),
    };
    json!({
        "title": "ribbon", "units": "mm-N-MPa", "horizon_ratio": horizon_ratio,
        "model": { "bond_plane": model }, "body": body,
        "cracks": [ { "name": "notch", "path": [at(-1.0, middle), at(length / 3.0, middle)] } ],
        "supports": [ { "at": { "region": grips[0] }, "ux": 0, "uy": 0 },
            { "at": { "region": grips[1] }, "ux": -MOTION * s, "uy": MOTION * c } ],
        "probes": [ { "name": "pull", "at": { "region": grips[1] }, "field": "reaction_y" } ],
        "fracture": { "critical": { "energy_release_rate": RELEASE_RATE }, "strategy": "worst", "load": "pull",
            "max_solves": 160 }
    })
}

/// Largest motion on the first half of the way of a crack, over Griffith's: `G = M H ε²/2`, `M` the modulus between grips.
fn over_griffith(angle: f64, state: &str, horizon_ratio: f64, influence: &str) -> f64 {
    let model = json!({ "youngs_modulus": YOUNGS_MODULUS, "state": state, "influence": influence });
    let (events, _) = solve(&ribbon(angle, model, horizon_ratio));
    let modulus = match state {
        "plane_stress" => YOUNGS_MODULUS / (1.0 - 1.0 / 9.0),
        _ => YOUNGS_MODULUS * 0.75 / (1.25 * 0.5),
    };
    let griffith = (2.0 * RELEASE_RATE * SIZE[1] / modulus).sqrt() / MOTION;
    growing(&events) / griffith
}

#[test]
fn cracks_in_ribbons_grow_at_the_energy_release_rate() {
    // Measured; the last bits of the order of breaks decide the third digit.
    let rows = [
        (0.0, "plane_stress", 3.0, "constant", 1.0304),
        (45.0, "plane_stress", 3.0, "constant", 0.9899),
        (30.0, "plane_strain", 3.0, "constant", 0.9440),
        (0.0, "plane_stress", 4.0, "inverse", 1.0307),
        (45.0, "plane_stress", 4.0, "constant", 0.9935),
    ];
    let of = |&(angle, state, ratio, influence, _): &(f64, &str, f64, &str, f64)| {
        over_griffith(angle, state, ratio, influence)
    };
    let found: Vec<f64> = rows.iter().map(of).collect();
    let near = |(found, row): (&f64, &(f64, &str, f64, &str, f64))| {
        (found - row.4).abs() < 2e-3 && (found - 1.0).abs() < 0.06
    };
    assert!(found.iter().zip(&rows).all(near), "{found:?}");
}
