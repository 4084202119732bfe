//! Supports of plates in bending that move with the load factor, and springs on edges of which the cells are steps.

use crate::support::bending::{model, probe, solved, square};
use serde_json::{Value, json};

/// Values of a probe in all states.
fn in_steps(case: &Value, name: &str) -> Vec<f64> {
    let found = solved(case);
    found.summary.probes.iter().filter(|probe| probe.name == name).map(|probe| probe.value).collect()
}

/// A strip between an edge that moves and one that turns.
fn strip(deflection: Value, rotation: Value) -> Value {
    let mut case = square(
        16,
        0.05,
        json!([ { "at": { "region": "left" }, "w": deflection, "phi_n": 0, "phi_t": 0 },
            { "at": { "region": "right" }, "w": 0, "phi_n": rotation, "phi_t": 0 } ]),
    );
    let wall = json!({ "name": "wall", "at": { "region": "left" }, "field": "reaction_force" });
    case["probes"].as_array_mut().expect("probes").push(wall);
    case
}

#[test]
fn motions_of_supports_follow_the_load_factor() {
    let factors = [0.5, 1.0, 0.25];
    let mut moved = strip(json!("0.01*load_factor^2*(1 + y)"), json!("0.02*sin(load_factor)"));
    moved["steps"] = json!({ "load_factors": factors });
    for name in ["middle", "moment", "wall"] {
        for (found, f) in in_steps(&moved, name).into_iter().zip(factors) {
            let deflection = json!(format!("{}*(1 + y)", 0.01 * f * f));
            let mut own = strip(deflection, json!(0.02 * f64::sin(f)));
            own["loads"][0]["pressure"]["value"] = json!(f);
            let expected = probe(&solved(&own), name);
            assert!((found - expected).abs() < 1e-10 * expected.abs(), "{name}: {found} {expected}");
        }
    }
    // One that follows the load factor and one in proportion agree in the corner that both hold, whatever the last factor is.
    let mut corner = strip(json!("0.01*load_factor"), json!(0));
    corner["supports"].as_array_mut().expect("supports").push(json!({ "at": { "x": 0, "y": 0 }, "w": 0.01 }));
    corner["steps"] = json!({ "load_factors": factors });
    let expected = in_steps(&corner, "wall").into_iter().zip(factors).map(|(wall, f)| wall / f);
    let walls: Vec<f64> = expected.collect();
    assert!((walls[0] / walls[2] - 1.0).abs() < 1e-9, "{walls:?}");
    // One motion that follows the load factor leaves the other in proportion.
    let mut both = strip(json!("0.01*load_factor^2"), json!(0.02));
    both["steps"] = json!({ "load_factors": factors });
    for (found, f) in in_steps(&both, "middle").into_iter().zip(factors) {
        let mut own = strip(json!(0.01 * f * f), json!(0.02 * f));
        own["loads"][0]["pressure"]["value"] = json!(f);
        let expected = probe(&solved(&own), "middle");
        assert!((found - expected).abs() < 1e-10 * expected.abs(), "{found} {expected}");
    }
}

/// Deflection and moment in the middle of a round plate of radius one, D = 1 and ν = 0.3 under a unit pressure whose edge a spring
/// keeps from turning: `ψ = q r³/16 + 2 C r` with `M_r + k ψ = 0` at the edge, and shear.
fn restrained(k: f64, t: f64) -> [f64; 2] {
    let c = -(3.3 + k) / 16.0 / (2.0 * (1.3 + k));
    let shear = t * t / 3.5;
    [-(1.0 / 64.0 + c) + 0.25 * shear, 2.0 * 1.3 * c]
}

#[test]
fn a_spring_resists_the_rotation_across_a_round_edge() {
    let t = 0.01;
    let round = |cells: usize, stiffness: f64, solver: &str| {
        let spring = json!([ { "at": { "region": "all" }, "w": 0, "phi_n_spring": stiffness } ]);
        let mut case = square(1, t, spring);
        case["model"] = model(t);
        case["solver"] = json!(solver);
        case["body"] = json!({ "outline": { "spacing": 1.0 / cells as f64,
            "vertices": [ { "arc_to": [1, 0], "through": [0, -1] }, { "arc_to": [-1, 0], "through": [0, 1] } ] } });
        case["probes"][0]["at"] = json!({ "x": 0, "y": 0 });
        case["probes"][1]["at"] = json!({ "x": 0, "y": 0 });
        solved(&case)
    };
    // Measured: -1.2e-3, 2.2e-4, 3.7e-3 with 20 cells per radius; 3.0e-4, 4.5e-4, 4.3e-3 with 40; 1.9e-4, 9.3e-5, 1.1e-3 with 80.
    for (stiffness, limit) in [(0.3, 6e-4), (2.0, 9e-4), (20.0, 6e-3)] {
        let found = round(40, stiffness, "auto");
        let [w, moment] = restrained(stiffness, t);
        let errors = [probe(&found, "middle") / w - 1.0, probe(&found, "moment").abs() / moment.abs() - 1.0];
        errors.iter().for_each(|error| assert!(error.abs() < limit, "{stiffness}: {errors:?}"));
    }
    let [factor, cycles] = ["sparse", "multigrid"].map(|solver| probe(&round(40, 2.0, solver), "middle"));
    assert!((factor / cycles - 1.0).abs() < 1e-8, "{factor} {cycles}");
    let warned = |cells: usize| {
        round(cells, 50.0, "auto")
            .summary
            .warnings
            .iter()
            .any(|warning| warning.contains("the spring resists more"))
    };
    // 0.5 % there, twice as stiff as a cell bends, and a tenth of a per cent where it is half of that.
    assert!(warned(20) && !warned(128));
}
