//! What acts one way: against every set of what may act, statics, and a beam on ground that does not pull.

use crate::support::{Run, largest, run, run_recovered, scene};
use peristat::case::FieldName;
use peristat::run::RunOptions;
use serde_json::{Value, json};

/// Numbers between −1 and 1 from a seed (Knuth's linear congruence).
fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// A clamped beam over bearings at 1, 2, 3 and 4.
fn beam(supports: &[Value], loads: &[Value]) -> Value {
    let clamp = json!({ "at": { "x": 0 }, "w": 0, "phi": 0 });
    let supports: Vec<&Value> = std::iter::once(&clamp).chain(supports).collect();
    json!({
        "title": "test", "model": crate::support::sections::model("exact"), "body": { "line": { "length": 4, "cells": 16 } },
        "supports": supports, "loads": loads
    })
}

fn deflections(run: &Run) -> Vec<f64> {
    run.states[0].values(FieldName::W, 0).expect("there").into_owned()
}

#[test]
fn the_set_that_acts_is_the_only_one_of_all_that_fits() {
    let mut seen = [0; 5];
    for seed in 0..25 {
        let mut number = numbers(seed);
        let loads: Vec<Value> = (1..=4)
            .map(|k| json!({ "point": { "at": { "x": f64::from(k) - 0.5 }, "force": number(), "moment": 0.3 * number() } }))
            .collect();
        let gaps: Vec<f64> = (0..4).map(|_| 0.02 * number().max(0.0)).collect();
        let signs: Vec<f64> = (0..4).map(|_| number().signum()).collect();
        let one_way: Vec<Value> = (0..4)
            .map(|k| {
                let only = if signs[k] > 0.0 { "positive" } else { "negative" };
                json!({ "at": { "x": k + 1 }, "w": 0, "only": only, "gap": gaps[k] })
            })
            .collect();
        let found = run(&beam(&one_way, &loads));
        let mut fitting = Vec::new();
        for set in 0..16_usize {
            let acts = |k: &usize| set >> k & 1 == 1;
            let held: Vec<Value> = (0..4)
                .filter(acts)
                .map(|k| json!({ "at": { "x": k + 1 }, "w": -signs[k] * gaps[k] }))
                .collect();
            let two_way = run(&beam(&held, &loads));
            let w = deflections(&two_way);
            let forces = two_way.states[0].reactions[1..].iter().map(|r| r.force);
            let push = (0..4).filter(acts).zip(forces).all(|(k, force)| signs[k] * force >= 0.0);
            let clear = (0..4).filter(|k| !acts(k)).all(|k| signs[k] * w[4 * (k + 1)] + gaps[k] >= 0.0);
            if push && clear {
                fitting.push((set, w));
            }
        }
        let [(set, w)] = &fitting[..] else { panic!("seed {seed}: {} sets fit", fitting.len()) };
        seen[set.count_ones() as usize] += 1;
        let forces: Vec<bool> = found.states[0].reactions[1..].iter().map(|r| r.force != 0.0).collect();
        assert_eq!(forces, (0..4).map(|k| set >> k & 1 == 1).collect::<Vec<_>>(), "seed {seed}");
        let difference: Vec<f64> = deflections(&found).iter().zip(w).map(|(a, b)| a - b).collect();
        // 2e-15 is found.
        assert!(largest(&difference) <= 1e-13 * largest(w), "seed {seed}: {:e}", largest(&difference));
        let of = found.states[0].one_way.as_ref().expect("a state of what acts");
        assert!(of.settled && of.parts[0].act == set.count_ones() as usize && of.parts[0].all == 4);
    }
    assert!(seen.iter().filter(|count| **count > 0).count() >= 3, "{seen:?}");
}

#[test]
fn play_between_two_stops_is_passed_by_the_load() {
    // A hinge at 0 and two stops at 4: without them it would turn.
    for (force, at) in [(-3.0, -0.02), (3.0, 0.05)] {
        let case = json!({
            "title": "test", "model": crate::support::sections::model("exact"), "body": { "line": { "length": 4, "cells": 8 } },
            "supports": [
                { "at": { "x": 0 }, "w": 0 },
                { "at": { "x": 4 }, "w": 0, "only": "positive", "gap": 0.02 },
                { "at": { "x": 4 }, "w": 0, "only": "negative", "gap": 0.05 }
            ],
            "loads": [ { "point": { "at": { "x": 1 }, "force": force } } ]
        });
        let run = run(&case);
        assert_eq!(deflections(&run)[8], at);
        let total: f64 = run.states[0].reactions[1..].iter().map(|r| r.force).sum();
        // Statics: a quarter of the force; 1e-16 is found.
        assert!((total + 0.25 * force).abs() <= 1e-13);
    }
}

#[test]
fn a_spring_that_acts_one_way_lifts_off_or_is_one_that_acts_both_ways() {
    let spring = |only: Option<&str>| {
        let mut spring = json!({ "at": { "x": 4 }, "w_spring": 0.7 });
        if let Some(only) = only {
            spring["only"] = json!(only);
        }
        spring
    };
    let loads = [json!({ "point": { "at": { "x": 3 }, "force": -1 } })];
    let [both, push, pull] =
        [None, Some("positive"), Some("negative")].map(|only| run_recovered(&beam(&[spring(only)], &loads)));
    let none = run_recovered(&beam(&[], &loads));
    for (one_way, two_way) in [(&push, &both), (&pull, &none)] {
        let (a, b) = (deflections(one_way), deflections(two_way));
        let difference: Vec<f64> = a.iter().zip(&b).map(|(a, b)| a - b).collect();
        // 4e-16 is found: one is solved in strains, the other one is not.
        assert!(largest(&difference) < 1e-13 * largest(&b), "{:e}", largest(&difference));
    }
    let [a, b] = [&push, &both].map(|run| run.states[0].reactions[1].force);
    // 1e-15 is found.
    assert!(a > 0.1 && (a - b).abs() < 1e-13, "{a} {b}");
    assert_eq!(pull.states[0].reactions[1].force, 0.0);
    let moments = |run: &Run| run.states[0].values(FieldName::M, 0).expect("recovered").into_owned();
    // 2e-15 is found, of 3.
    assert!(moments(&pull).iter().zip(moments(&none)).all(|(a, b)| (a - b).abs() < 1e-12));
}

#[test]
fn ground_that_does_not_pull_bears_a_long_beam_over_pi_of_its_own_length() {
    // β = 1: Hetényi's beam of the length π under a force in its middle, whose ends do not sink: P β/(2 k) coth(π/2).
    let exact = -1.0 / (std::f64::consts::FRAC_PI_2).tanh();
    for (cells, tolerance) in [(100, 1e-3), (400, 1e-4)] {
        let case = json!({
            "title": "test", "horizon_ratio": 1,
            "model": { "timoshenko_beam": { "stiffness": { "bending": { "uniform": 1 }, "shear": { "uniform": 1e8 } } } },
            "body": { "line": { "length": 8, "from": -4, "cells": cells } },
            "foundation": [ { "stiffness": { "uniform": 4 }, "only": "positive" } ],
            "loads": [ { "point": { "at": { "x": 0 }, "force": -8 } } ]
        });
        let run = run(&case);
        let w = deflections(&run)[cells / 2];
        // 8e-5 and 2e-6 are found; a foundation that pulls sinks by 1.
        assert!((w - exact).abs() < tolerance, "{cells}: {w}");
        let balance = run.states[0].record.certificate.resultants.as_ref().expect("resultants");
        assert!(balance.difference < 1e-12);
        let count = &run.states[0].one_way.as_ref().expect("a state of what acts").parts[0];
        let length = 8.0 * count.act as f64 / cells as f64;
        assert!((length - std::f64::consts::PI).abs() <= 16.0 / cells as f64, "{cells}: {length}");
    }
}

#[test]
fn a_bar_that_becomes_warmer_presses_a_wall_once_its_gap_is_closed() {
    // EA = 200 and a length of 4 with α = 1e-3: by 2 K it grows by 0.008, by 10 K by 0.04.
    for (change, axial, way) in [(2, 0.0, 0.008), (10, -200.0 * (0.01 - 0.01 / 4.0), 0.01)] {
        let wall = json!({ "at": { "x": 4 }, "ux": 0, "only": "negative", "gap": 0.01 });
        let hold = json!({ "at": { "x": 0 }, "ux": 0 });
        let mut case = beam(&[hold, wall], &[json!({ "temperature": { "change": change } })]);
        case["thermal_expansion"] = json!(1e-3);
        let run = run_recovered(&case);
        let value = |field: FieldName, point: usize| run.states[0].value(field, 0, point).expect("recovered");
        // 3e-16 is found.
        assert!(
            (value(FieldName::N, 8) - axial).abs() < 1e-12 && (value(FieldName::U, 16) - way).abs() < 1e-14
        );
        assert!((value(FieldName::ReactionX, 16) - axial).abs() < 1e-12);
    }
}

#[test]
fn what_tips_over_is_named() {
    let case = json!({
        "title": "test", "model": crate::support::sections::model("exact"), "body": { "line": { "length": 4, "cells": 8 } },
        "supports": [ { "at": { "x": 0 }, "w": 0, "only": "positive" }, { "at": { "x": 2 }, "w": 0 } ],
        "loads": [ { "point": { "at": { "x": 4 }, "force": -1 } } ]
    });
    let options = RunOptions { recover: false, max_memory: None, compare: false };
    let error = peristat::run::beam::run(&scene(&case), &options, &mut |_| Ok(()));
    let Err(peristat::run::RunError::Case(faults)) = error else { panic!("a fault of the case") };
    let text = format!("{faults:?}");
    assert!(
        text.contains(
            "leaves the support at x = 0 without force; then the beam from x = 0 to 4 is free to rotate about x = 2"
        ),
        "{text}"
    );
}
