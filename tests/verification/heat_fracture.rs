//! Heat that breaks bodies: with the stretches and the energies of closed forms, and as motions that strain them alike.

use crate::support::breaking::{broke, imbalance, solve};
use peristat::run::fracture::Event;
use serde_json::{Value, json};

const ALPHA: f64 = 1e-5;

fn case(body: &Value, loads: &Value, supports: &Value, fracture: &Value) -> Value {
    json!({
        "title": "heat", "units": "mm-N-MPa", "thermal_expansion": ALPHA,
        "model": { "bond_plane": { "youngs_modulus": 3000, "state": "plane_stress" } },
        "body": body, "loads": loads, "supports": supports,
        "probes": [ { "name": "pull", "at": { "x": 11, "y": 5 }, "field": "ux" } ],
        "fracture": fracture
    })
}

fn fracture(critical: f64, strategy: &str, most: usize) -> Value {
    json!({ "critical": { "stretch": critical }, "strategy": strategy, "load": "pull", "stop_below": 1e-9, "max_solves": most })
}

#[test]
fn a_bar_that_cools_between_walls_breaks_at_its_stretch() {
    // Pulled by E α T, so that bonds along it are strained by α T, with E (α T)²/2 per volume.
    let supports = json!([ { "at": { "region": "left" }, "ux": 0 }, { "at": { "region": "right" }, "ux": 0 },
        { "at": { "x": 0, "y": 0 }, "uy": 0 } ]);
    let loads = json!([ { "temperature": { "change": -300 } } ]);
    let body = json!({ "rectangle": { "size": [40, 12], "spacing": 1 } });
    let (events, _) = solve(&case(&body, &loads, &supports, &fracture(0.002, "worst", 1)));
    let first = events[0];
    let strain = 300.0 * ALPHA * first.load_factor;
    assert!((strain / 0.002 - 1.0).abs() < 1e-9, "{strain}");
    let energy = 0.5 * 3000.0 * 0.002_f64.powi(2) * 480.0;
    for found in [first.stored, first.work] {
        assert!((found / energy - 1.0).abs() < 1e-9, "{found} {energy}");
    }
}

#[test]
fn a_body_that_nothing_lets_move_breaks_at_its_strain() {
    // Displacements are zero, so that forces and energies are those of the held strain alone: E/(1 − ν²) times 0.002 on 6 mm².
    let supports = json!([ { "at": { "region": "left" }, "ux": 0 }, { "at": { "region": "right" }, "ux": 0 },
        { "at": { "region": "bottom" }, "uy": 0 }, { "at": { "region": "top" }, "uy": 0 } ]);
    for strain in [json!(-0.003), json!("-0.003*(1 + 1e-13*x)")] {
        let loads = json!([ { "initial_strain": { "xx": strain } } ]);
        let body = json!({ "rectangle": { "size": [8, 6], "spacing": 1 } });
        let mut case = case(&body, &loads, &supports, &fracture(0.002, "worst", 1));
        case["probes"][0] = json!({ "name": "pull", "at": { "region": "right" }, "field": "reaction_x" });
        // It asks for convergence.
        let (events, report) = solve(&case);
        // Measured: 0 and 6e-13, as the formula adds 4e-13 in the middle.
        let pairs = [(events[0].load_factor, 2.0 / 3.0), (events[0].load.abs(), 40.5)];
        assert!(pairs.iter().all(|(found, exact)| (found / exact - 1.0).abs() < 3e-12), "{pairs:?}");
        let warnings = report.warnings.into_report("case", "").to_string();
        assert!(!warnings.contains("rounding"), "{warnings}");
    }
}

#[test]
fn a_free_body_does_not_break_where_it_is_warm_everywhere() {
    let supports =
        json!([ { "at": { "x": 0, "y": 0 }, "ux": 0, "uy": 0 }, { "at": { "x": 20, "y": 0 }, "uy": 0 } ]);
    let loads = json!([ { "temperature": { "change": 1000 } } ]);
    let body = json!({ "rectangle": { "size": [20, 12], "spacing": 1 } });
    let (events, report) = solve(&case(&body, &loads, &supports, &fracture(1e-6, "worst", 9)));
    assert_eq!((events.len(), broke(&report).ending), (1, "the full load is reached"));
}

/// How much the equilibria of two runs differ: load factors, energies over the work, and the number of broken bonds.
fn difference(a: &[Event], b: &[Event]) -> f64 {
    assert_eq!(a.len(), b.len());
    let of = |(a, b): (&Event, &Event)| {
        assert_eq!((a.broken, a.broken_now, a.island_points), (b.broken, b.broken_now, b.island_points));
        let pairs = [
            (a.work, b.work),
            (a.stored, b.stored),
            (a.released, b.released),
            (a.bond_energy, b.bond_energy),
        ];
        let of = |(a, b): (f64, f64)| (a - b).abs();
        let energies = pairs.into_iter().map(of).fold(0.0, f64::max) / b.work;
        energies.max((a.load_factor / b.load_factor - 1.0).abs())
    };
    a.iter().zip(b).map(of).fold(0.0, f64::max)
}

#[test]
fn cold_breaks_a_held_body_as_motions_do() {
    // Where all of the outer border is held a change of temperature T is a motion of that border by −α T x.
    let outline = json!({ "outline": { "vertices": [[0, 0], [30, 3], [28, 31], [1, 29]], "spacing": 1.0,
        "holes": [ { "circle": { "centre": [9, 16], "radius": 4 } } ] } });
    let square = json!({ "rectangle": { "size": [24, 24], "spacing": 1 } });
    for (body, sides, strategy) in [
        (&outline, ["edge_1", "edge_2", "edge_3", "edge_4"], "worst"),
        (&outline, ["edge_1", "edge_2", "edge_3", "edge_4"], "batch"),
        (&square, ["left", "right", "top", "bottom"], "worst"),
    ] {
        let held = |ux: &Value, uy: &Value| -> Vec<Value> {
            sides.iter().map(|side| json!({ "at": { "region": side }, "ux": ux, "uy": uy })).collect()
        };
        let more = |mut case: Value| {
            case["cracks"] = json!([ { "name": "crack", "path": [[14, 10], [22, 14]] } ]);
            case["regions"] = json!({ "core": { "disc": { "centre": [20, 20], "radius": 5 } } });
            case["materials"] = json!({ "core": { "at": "core", "youngs_modulus": "6000*(1 + x/30)" } });
            case
        };
        let steps = fracture(0.002, strategy, 16);
        let cold = case(
            body,
            &json!([ { "temperature": { "change": -500 } } ]),
            &json!(held(&json!(0), &json!(0))),
            &steps,
        );
        let pulled = case(body, &json!([]), &json!(held(&json!("0.005*x"), &json!("0.005*y"))), &steps);
        let (cold, pulled) = (solve(&more(cold)).0, solve(&more(pulled)).0);
        let found = difference(&cold, &pulled);
        let most = if strategy == "worst" { 1e-9 } else { 1e-6 };
        assert!(found < most && cold.len() > 8, "{strategy} {}: {found:e}", cold.len());
        assert!(imbalance(&cold) < most, "{strategy}: {:e}", imbalance(&cold));
    }
}

#[test]
fn energies_of_heat_balance() {
    // A hot spot that bursts, in materials of other moduli and expansions, and an initial strain beside it.
    for (strategy, most) in [("worst", 1e-10), ("batch", 1e-6)] {
        let body = json!({ "outline": { "vertices": [[0, 0], [30, 3], [28, 31], [1, 29]], "spacing": 1.0 } });
        let supports = json!([ { "at": { "region": "edge_1" }, "ux": 0, "uy": 0 } ]);
        let loads = json!([ { "temperature": { "change": "900*exp(-((x - 15)^2 + (y - 18)^2)/30)" } },
            { "initial_strain": { "region": "core", "xx": 2e-3, "xy": 1e-3 } },
            { "traction": { "edge": "edge_3", "uniform": [0, 3] } } ]);
        let mut case = case(&body, &loads, &supports, &fracture(0.002, strategy, 60));
        case["regions"] = json!({ "core": { "disc": { "centre": [20, 15], "radius": 5 } } });
        case["materials"] = json!({ "core": { "at": "core", "youngs_modulus": "9000*(1 + x/30)", "thermal_expansion": 2e-5 } });
        let (events, _) = solve(&case);
        assert!(
            imbalance(&events) < most && events.len() > 20,
            "{strategy}: {} {:e}",
            events.len(),
            imbalance(&events)
        );
    }
}

#[test]
fn what_comes_off_takes_its_energy_along() {
    // A cold core in a frame that is held: it tears off all around.
    for strategy in ["worst", "all"] {
        let body = json!({ "rectangle": { "size": [20, 20], "spacing": 1 } });
        let supports: Vec<Value> = ["left", "right", "top", "bottom"]
            .iter()
            .map(|side| json!({ "at": { "region": side }, "ux": 0, "uy": 0 }))
            .collect();
        let loads = json!([ { "temperature": { "change": -900, "region": "core" } } ]);
        let mut case = case(&body, &loads, &json!(supports), &fracture(0.001, strategy, 600));
        case["regions"] = json!({ "core": { "disc": { "centre": [10, 10], "radius": 5 } } });
        case["materials"] = json!({ "core": { "at": "core", "youngs_modulus": 3000, "critical": { "stretch": 1 },
            "interface": { "stretch": 0.001 } } });
        let (events, report) = solve(&case);
        // 1e-13 and 2e-9 found.
        let most = if strategy == "worst" { 1e-11 } else { 1e-7 };
        assert!(imbalance(&events) < most, "{strategy}: {:e}", imbalance(&events));
        assert!(broke(&report).island_points > 60, "{strategy}: {}", broke(&report).island_points);
    }
}

#[test]
fn beam_bonds_break_by_cold_as_by_motions() {
    let sides = ["left", "right", "top", "bottom"];
    let of = |factor: Value, loads: Value, ux: Value, uy: Value| {
        let held: Vec<Value> = sides
            .iter()
            .map(|side| json!({ "at": { "region": side }, "ux": ux, "uy": uy, "phi": 0 }))
            .collect();
        let steps = json!({ "critical": { "fibre_stretch": 0.004, "matrix_stretch": 0.002 }, "strategy": "worst",
            "load": "pull", "max_solves": 30 });
        let mut case =
            case(&json!({ "rectangle": { "size": [20, 16], "spacing": 1 } }), &loads, &json!(held), &steps);
        case["model"] = json!({ "beam_bond_orthotropic": { "youngs_modulus_1": 105000, "youngs_modulus_2": 8400,
            "poisson_ratio_12": 0.32, "shear_modulus_12": 4000, "thickness": 0.6, "fibre_angle": 45 } });
        case["thermal_expansion"] = json!([ALPHA, ALPHA]);
        case["cracks"] = json!([ { "name": "crack", "path": [[6, 7.7], [14, 7.7]] } ]);
        case["regions"] = json!({ "part": { "box": { "from": [10, 4], "to": [20, 12] } } });
        case["materials"] =
            json!({ "other": { "at": "part", "stiffness_factor": factor, "thermal_expansion": ALPHA } });
        solve(&case).0
    };
    for factor in [json!(1), json!(3), json!("1 + x/20")] {
        let cold = of(factor.clone(), json!([ { "temperature": { "change": -500 } } ]), json!(0), json!(0));
        let pulled = of(factor, json!([]), json!("0.005*x"), json!("0.005*y"));
        let found = difference(&cold, &pulled);
        assert!(found < 1e-9 && cold.len() > 10, "{} {found:e}", cold.len());
    }
}
