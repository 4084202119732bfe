//! Loads and weights on arcs of outlines, and places on round borders: resultants in closed form, which no chord has.

use peristat::{Solved, solve_text};
use serde_json::{Value, json};
use std::f64::consts::{FRAC_PI_2, PI};

/// Radii of a ring, mm.
const BORE: f64 = 5.0;
const RIM: f64 = 10.0;
/// What chords lose: a third of a ten-thousandth of a spacing over the radius of the length, four times that of the area of a disc; 1.8e-5 is
/// found of the weight, 3.4e-6 of the force.
const LOST: f64 = 2e-5;

fn solve(case: &Value) -> Solved {
    let solved = solve_text(&case.to_string()).unwrap_or_else(|error| panic!("{error}"));
    assert!(solved.summary.states.iter().all(|state| state.certificate.converged));
    solved
}

/// Forces that are asked for along x and y, and what holds them.
fn balance(case: &Value) -> [[f64; 2]; 2] {
    let solved = solve(case);
    let resultants = solved.summary.states[0].certificate.resultants.clone().expect("resultants");
    [&resultants.asked, &resultants.reactions].map(|all| [0, 1].map(|k| all.forces()[k].expect("a number")))
}

fn case(body: Value, supports: Value, loads: Value) -> Value {
    json!({
        "title": "arcs", "units": "mm-N-MPa", "density": 1e-6, "supports": supports, "loads": loads,
        "model": { "bond_plane": { "youngs_modulus": 2e5, "thickness": 2, "state": "plane_stress" } },
        "body": { "outline": body }
    })
}

/// A ring of two arcs around a bore.
fn ring(spacing: f64) -> Value {
    json!({
        "vertices": [{ "arc_to": [RIM, 0], "centre": [0, 0] }, { "arc_to": [-RIM, 0], "centre": [0, 0] }],
        "spacing": spacing, "holes": [{ "circle": { "name": "bore", "centre": [0, 0], "radius": BORE } }]
    })
}

/// Its upper half; `edge_1` is the outer arc, `edge_3` the inner one.
fn half(spacing: f64) -> Value {
    json!({
        "vertices": [
            [RIM, 0], { "arc_to": [-RIM, 0], "centre": [0, 0] },
            [-BORE, 0], { "arc_to": [BORE, 0], "centre": [0, 0], "clockwise": true }
        ],
        "spacing": spacing
    })
}

#[test]
fn a_ring_has_the_weight_and_the_forces_of_its_arcs() {
    for spacing in [1.0, 0.5] {
        let hold = json!([{ "at": { "region": "bore" }, "ux": 0, "uy": 0 }]);
        let asked = |load: Value| balance(&case(ring(spacing), hold.clone(), json!([load])));
        let weight = 1e-6 * 9806.65 * 2.0 * PI * (RIM * RIM - BORE * BORE);
        let around = json!(["edge_1", "edge_2"]);
        let [pressed, held] = asked(json!({ "traction": { "edge": around, "pressure": 7 } }));
        // 3e-14 is found.
        assert!(pressed.iter().chain(&held).all(|f| f.abs() < 1e-11), "{pressed:?} {held:?}");
        for (load, expected) in [
            (json!({ "gravity": { "along": [0, -1] } }), -weight),
            (json!({ "traction": { "edge": around, "uniform": [0, 3] } }), 3.0 * 2.0 * 2.0 * PI * RIM),
            (json!({ "traction": { "edge": "edge_2", "uniform": [0, 3] } }), 3.0 * 2.0 * PI * RIM),
        ] {
            for (found, sign) in asked(load.clone()).iter().zip([1.0, -1.0]) {
                let lost = (sign * found[1] / expected - 1.0).abs();
                assert!(lost < LOST && found[0].abs() < 1e-9 * expected.abs(), "{spacing} {load} {lost:e}");
            }
        }
    }
}

#[test]
fn half_a_ring_bears_its_pressures_and_its_weight() {
    let hold = json!([{ "at": { "region": ["edge_2", "edge_4"] }, "ux": 0, "uy": 0 }]);
    let asked = |load: Value| balance(&case(half(0.5), hold.clone(), json!([load])));
    let shear = json!({ "traction": { "edge": "edge_3", "formula": ["-4*y/5", "4*x/5"] } });
    for (load, expected) in [
        // ∫ n ds over a half circle is its diameter.
        (json!({ "traction": { "edge": "edge_3", "pressure": 6 } }), [0.0, 6.0 * 2.0 * 2.0 * BORE]),
        (json!({ "traction": { "edge": "edge_1", "pressure": 6 } }), [0.0, -6.0 * 2.0 * 2.0 * RIM]),
        // So is ∫ s ds, of the direction along it.
        (shear, [-4.0 * 2.0 * 2.0 * BORE, 0.0]),
        (
            json!({ "gravity": { "along": [0, -1] } }),
            [0.0, -1e-6 * 9806.65 * 2.0 * FRAC_PI_2 * (RIM * RIM - BORE * BORE)],
        ),
        (json!({ "traction": { "edge": "edge_1", "total": [0, 11] } }), [0.0, 11.0]),
    ] {
        let size = expected[0].hypot(expected[1]);
        for (found, sign) in asked(load.clone()).iter().zip([1.0, -1.0]) {
            let lost = (sign * found[0] - expected[0]).hypot(sign * found[1] - expected[1]) / size;
            assert!(lost < LOST, "{load} {found:?} {lost:e}");
        }
    }
}

/// Points that hold rigid motions bear nothing where an arc balances the weight; chords a hundredth of a spacing from it left 0.03 %.
#[test]
fn a_ring_in_balance_has_the_limit_of_local_elasticity() {
    let points = json!([{ "at": { "x": 7.5, "y": 0.5 }, "ux": 0, "uy": 0 }, { "at": { "x": -7.5, "y": 0.5 }, "uy": 0 }]);
    // Per area, over the circumference.
    let bears = 1e-3 * (RIM * RIM - BORE * BORE) / (2.0 * RIM);
    let loads = json!([
        { "traction": { "edge": ["edge_1", "edge_2"], "uniform": [0, bears] } },
        { "body_force": { "density": [0, -1e-3] } }
    ]);
    let mut case = case(ring(1.0), points, loads);
    case["limit"] = json!("local");
    solve(&case);
}

/// Places that a script writes by sine and cosine are on the border, whichever cell they fall into: those of probes, supports and loads.
#[test]
fn places_on_round_borders_are_of_the_body() {
    let hold = json!([{ "at": { "region": "bore" }, "ux": 0, "uy": 0 }]);
    let mut case = case(ring(0.5), hold, json!([{ "traction": { "edge": "edge_2", "uniform": [0, 3] } }]));
    let on = |radius: f64, degrees: u32| {
        let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
        json!({ "x": radius * cos, "y": radius * sin })
    };
    let places = (0..360).step_by(3).flat_map(|angle| [on(BORE, angle), on(RIM, angle)]);
    let probe = |(k, at): (usize, Value)| json!({ "name": k.to_string(), "at": at, "field": "uy" });
    case["probes"] = places.enumerate().map(probe).collect();
    assert_eq!(solve(&case).summary.probes.len(), 240);
    // Of these, 15°, 45° and 75° on the rim and 51° and 129° in the bore have no point within half a diagonal of a cell.
    case["probes"] = json!([]);
    for angle in [15, 45, 75] {
        case["loads"] = json!([{ "point": { "at": on(RIM, angle), "force_y": 2 } }]);
        solve(&case);
    }
    case["supports"] = json!([
        { "at": on(BORE, 129), "ux": 0, "uy": 0 }, { "at": on(BORE, 51), "ux": 0, "uy": 0 }
    ]);
    solve(&case);
}
