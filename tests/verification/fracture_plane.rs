//! Bodies in the plane that break: what energies must do, what is known in closed form, what holds nothing any more.

use crate::support::breaking::{broke, fact, imbalance, solve};
use serde_json::{Value, json};

/// A plate with an edge crack between two clamps that move apart.
fn pulled() -> Value {
    json!({
        "title": "pulled", "units": "mm-N-MPa",
        "model": { "bond_plane": { "youngs_modulus": 70000, "state": "plane_stress", "thickness": 1 } },
        "body": { "rectangle": { "size": [8, 14], "spacing": 1 } },
        "cracks": [ { "path": [[-1, 7], [2, 7]] } ],
        "regions": { "low": { "box": { "from": [0, 0], "to": [8, 3] } }, "high": { "box": { "from": [0, 11], "to": [8, 14] } } },
        "supports": [ { "at": { "region": "low" }, "ux": 0, "uy": 0 }, { "at": { "region": "high" }, "ux": 0, "uy": 0.3 } ],
        "probes": [ { "name": "pull", "at": { "region": "high" }, "field": "reaction_y" } ],
        "fracture": { "critical": { "energy_release_rate": 5 }, "strategy": "worst", "load": "pull" }
    })
}

/// The same held below and loaded above.
fn loaded(strategy: &str) -> Value {
    let mut case = pulled();
    case["supports"] = json!([{ "at": { "region": "low" }, "ux": 0, "uy": 0 }]);
    case["loads"] = json!([{ "point": { "at": { "region": "high" }, "force_y": 6000 } }]);
    case["probes"] = json!([{ "name": "pull", "at": { "region": "low" }, "field": "reaction_y" }]);
    case["fracture"]["strategy"] = strategy.into();
    case["fracture"]["no_fail"] = json!(["high"]);
    case["fracture"]["stop_below"] = json!(1e-6);
    case
}

#[test]
fn energies_balance_at_every_equilibrium_of_single_bonds() {
    let (events, report) = solve(&pulled());
    assert!(events.len() > 30 && broke(&report).ending == "the load fell below its part of the peak");
    // Found 3e-13: the residual.
    assert!(imbalance(&events) < 1e-10, "{:e}", imbalance(&events));
    for pair in events.windows(2) {
        assert!(pair[1].released > pair[0].released && pair[1].bond_energy > pair[0].bond_energy);
        assert_eq!(pair[1].broken, pair[0].broken + pair[0].broken_now);
    }
    // What comes free beyond the energy of the bonds is no gain.
    assert!(events.iter().all(|e| e.unstable_release > -1e-12 * e.work));
}

#[test]
fn strategies_agree_on_the_first_break_and_nearly_on_the_peak() {
    let of = |strategy: &str| {
        let mut case = pulled();
        case["fracture"]["strategy"] = strategy.into();
        if strategy != "worst" {
            // The peak is no sharper than the step.
            case["fracture"]["increment"] = json!(0.004);
        }
        let (events, report) = solve(&case);
        assert!(imbalance(&events) < 1e-8, "{strategy}: {:e}", imbalance(&events));
        ["first_break_load_factor", "peak_load"].map(|name| fact(&report, name))
    };
    let worst = of("worst");
    for strategy in ["batch", "all"] {
        let found = of(strategy);
        // The others go a ten-millionth beyond the first break.
        assert!((found[0] / worst[0] - 1.0).abs() < 2e-7, "{strategy}: {found:?} {worst:?}");
        assert!((found[1] / worst[1] - 1.0).abs() < 0.05, "{strategy}: {found:?} {worst:?}");
    }
}

#[test]
fn a_body_under_uniform_stress_breaks_first_where_its_strain_is_critical() {
    // Bonds along the pull have the stretch σ/E all over the plate, all others less.
    let (stretch, stress) = (0.004, 500.0);
    let case = json!({
        "title": "uniform stress", "units": "mm-N-MPa",
        "model": { "bond_plane": { "youngs_modulus": 70000, "state": "plane_stress", "thickness": 2, "edges": "overlay" } },
        "body": { "rectangle": { "size": [8, 9], "spacing": 1 } },
        "supports": [ { "at": { "x": 0.5, "y": 0.5 }, "ux": 0, "uy": 0 }, { "at": { "x": 7.5, "y": 0.5 }, "uy": 0 } ],
        "loads": [
            { "traction": { "edge": "top", "uniform": [0, stress] } },
            { "traction": { "edge": "bottom", "uniform": [0, -stress] } }
        ],
        "probes": [ { "name": "lift", "at": { "x": 4, "y": 8.5 }, "field": "uy" } ],
        "fracture": { "critical": { "stretch": stretch }, "strategy": "worst", "load": "lift", "max_solves": 1 }
    });
    let (events, report) = solve(&case);
    let expected = 70000.0 * stretch / stress;
    assert!((events[0].load_factor / expected - 1.0).abs() < 1e-10, "{}", events[0].load_factor);
    assert!((events[0].load / (stretch * 8.0) - 1.0).abs() < 1e-10, "{}", events[0].load);
    assert!(events[0].broken_now > 20, "{} break together", events[0].broken_now);
    assert_eq!(broke(&report).ending, "as many equilibria as allowed were found");
}

#[test]
fn a_load_that_does_not_follow_ends_with_nothing_that_bears_it() {
    for strategy in ["worst", "batch", "all"] {
        let (events, report) = solve(&loaded(strategy));
        assert_eq!(broke(&report).ending, "nothing carries the load any more", "{strategy}");
        let last = events.last().unwrap();
        assert!(last.load.abs() < 1e-9 * events[0].load.abs() && last.broken > 20, "{strategy}: {last:?}");
        assert!(imbalance(&events) < 1e-8, "{strategy}: {:e}", imbalance(&events));
        // The body carried no more than at the first break: from there on it unloads.
        assert!(events.iter().all(|e| e.load.abs() < 1.05 * events[0].load.abs()), "{strategy}");
    }
}

#[test]
fn a_loaded_part_that_comes_off_takes_its_loads_and_energy_with_it() {
    let mut case = loaded("all");
    case["cracks"] = json!([]);
    case["horizon_ratio"] = json!(1.5);
    case["loads"] = json!([{ "body_force": { "density": [0, 60] } }]);
    // One row of bonds after the other breaks at the same load.
    case["fracture"]["no_fail"] = json!([]);
    case["fracture"]["critical"] = json!({ "stretch": 1e-4 });
    case["fracture"]["increment"] = json!(0.99);
    let (events, report) = solve(&case);
    // Ten rows of eight points come off; the four rows that are held bear their own load.
    let last = events.last().unwrap();
    assert_eq!((last.island_points, fact(&report, "island_points")), (80, 80.0));
    assert!((last.load / -(60.0 * 32.0) - 1.0).abs() < 1e-9 && last.load_factor == 1.0, "{last:?}");
    assert!(imbalance(&events) < 1e-8, "{:e}", imbalance(&events));
}

#[test]
fn what_comes_off_by_cracks_and_breaks_is_counted_and_bears_nothing() {
    // A block of 2 × 2 points is tied by the bonds of one gap in the cracks around it.
    let mut case = pulled();
    case["cracks"] = json!([{ "path": [[-0.1, 4.9], [2.01, 4.9], [2.01, 6.9], [1.1, 6.9]] }]);
    case["horizon_ratio"] = json!(1.5);
    case["fracture"]["strategy"] = "all".into();
    let (events, report) = solve(&case);
    assert!(imbalance(&events) < 1e-8, "{:e}", imbalance(&events));
    assert!(events.windows(2).all(|pair| pair[0].island_points <= pair[1].island_points));
    assert_eq!(fact(&report, "island_points"), events.last().unwrap().island_points as f64);
}

#[test]
fn a_body_that_cannot_break_bears_the_full_load() {
    let mut whole = pulled();
    whole["regions"]["all"] = json!({ "box": { "from": [-1, -1], "to": [9, 15] } });
    whole["fracture"]["no_fail"] = json!(["all"]);
    let mut strong = pulled();
    strong["fracture"]["critical"] = json!({ "stretch": 10.0 });
    let mut still = pulled();
    still["supports"][1]["uy"] = json!(0);
    for case in [whole, strong, still] {
        for strategy in ["worst", "batch", "all"] {
            let mut case = case.clone();
            case["fracture"]["strategy"] = strategy.into();
            let (events, report) = solve(&case);
            assert_eq!((events.len(), broke(&report).ending), (1, "the full load is reached"));
            assert_eq!((events[0].load_factor, events[0].broken_now), (1.0, 0));
        }
    }
}

#[test]
fn one_bond_of_a_ligament_after_the_other_until_the_halves_are_apart() {
    let mut case = pulled();
    case["cracks"] = json!([{ "path": [[-1, 7], [4.01, 7]] }, { "path": [[4.99, 7], [9, 7]] }]);
    case["fracture"]["stop_below"] = json!(1e-6);
    let (events, report) = solve(&case);
    assert_eq!(broke(&report).ending, "nothing carries the load any more");
    assert!(imbalance(&events) < 1e-10, "{:e}", imbalance(&events));
}
