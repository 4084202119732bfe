//! Compact tension specimens of bonds that yield, soften and fail (law of Yolum, Taştan and Güler 2016).
//!
//! Specimen and materials are choices of these tests: those of the source, and its curves, are not available. Expected
//! numbers are of an independent Python implementation of the same lattice, law and pins, to their printed digits.

use crate::support::plane::scene;
use peristat::run::path::{PathPoint, PathReport};
use peristat::run::{Advance, Restart, RunOptions, Sink, StateResult, body};
use serde_json::{Value, json};
use std::io;

/// A specimen of W = 50 with `cells` per quarter of it, whose pins open by `opening` at a load factor of one.
fn specimen(alloy: [f64; 3], cells: usize, opening: f64, law: &Value, path: &Value) -> Value {
    let [youngs, yields, toughness] = alloy;
    let mut bilinear = json!({ "yield_stress": yields,
        "energy_release_rate": toughness * toughness * 1000.0 * (1.0 - 1.0 / 16.0) / youngs });
    let mut followed = json!({ "no_damage": ["around_pins"], "load": "P", "record_every": 100_000 });
    for (into, from) in [(&mut bilinear, law), (&mut followed, path)] {
        let from = from.as_object().expect("keys");
        from.iter().for_each(|(key, value)| into[key] = value.clone());
    }
    json!({ "title": "specimen", "units": "mm-N-MPa",
        "model": { "bond_plane": { "youngs_modulus": youngs, "state": "plane_strain", "thickness": 25,
            "calibration": "published", "edges": "none", "bond_law": { "bilinear": bilinear } } },
        "body": { "compact_tension": { "width": 50, "crack_length": 25, "cells": cells, "opening": opening } },
        "path": followed,
        "probes": [ { "name": "P", "at": { "region": "upper_pin" }, "field": "reaction_y" },
            { "name": "CMOD", "at": { "x": -12.5, "y": 0 }, "field": "opening" } ] })
}

/// Young's modulus, yield stress (MPa) and K_Ic (MPa √m) of alloys like 2024 and 7075.
const DUCTILE: [f64; 3] = [73100.0, 325.0, 36.0];
const BRITTLE: [f64; 3] = [71700.0, 505.0, 27.0];

#[derive(Default)]
struct Told(Vec<PathPoint>);

impl Sink for Told {
    fn take(&mut self, _: StateResult) -> io::Result<()> {
        Ok(())
    }

    fn advance(&mut self, advance: Advance<'_>, _: Option<&dyn Fn() -> Restart>) -> io::Result<()> {
        let Advance::Path(point) = advance else { return Ok(()) };
        self.0.push(point.clone());
        Ok(())
    }
}

/// The states of a path, and what is reported of it.
struct Followed {
    points: Vec<PathPoint>,
    report: PathReport,
    opening: f64,
}

fn follow(case: &Value) -> Followed {
    let (scene, mut told) = (scene(case).unwrap_or_else(|faults| panic!("{faults}")), Told::default());
    let report = body::run_softening(
        &scene,
        &RunOptions { recover: false, max_memory: None, compare: false },
        None,
        &mut told,
    );
    let report = report.unwrap_or_else(|error| panic!("{error}: {case}"));
    assert!(report.converged, "not converged");
    let opening = case["body"]["compact_tension"]["opening"].as_f64().expect("a number");
    Followed { points: told.0, report: report.path.expect("a body that softens"), opening }
}

impl Followed {
    fn fact(&self, name: &str) -> f64 {
        self.report.facts[name].as_f64().expect("a number")
    }

    /// Load where the pins have opened by some length, between states.
    fn load_at(&self, opening: f64) -> f64 {
        let place = |p: &PathPoint| p.load_factor * self.opening;
        let pair = self.points.windows(2).find(|p| place(&p[0]) <= opening && opening <= place(&p[1]));
        let pair = pair.expect("the path gets there");
        let share = (opening - place(&pair[0])) / (place(&pair[1]) - place(&pair[0]));
        pair[0].load + share * (pair[1].load - pair[0].load)
    }

    fn peak(&self) -> &PathPoint {
        self.points.iter().max_by(|a, b| a.load.total_cmp(&b.load)).expect("states")
    }
}

fn near(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() <= tolerance, "{found} for {expected}");
}

#[test]
fn a_ductile_specimen_is_traced() {
    let traced = follow(&specimen(DUCTILE, 5, 1.5, &json!({}), &json!({ "control": "event" })));
    near(traced.fact("first_yield_load_factor") * 1.5, 0.21997, 1e-4);
    near(traced.fact("first_yield_load"), 9164.9, 1e-4);
    near(traced.peak().load, 15482.5, 1e-4);
    near(traced.peak().load_factor * 1.5, 0.4458, 1e-4);
    near(traced.load_at(0.6), 9865.2, 1e-4);
    near(traced.load_at(1.0), 2839.2, 1e-4);
    near(traced.fact("initial_stiffness") / 1.5, 41663.0, 1e-4);
    // 8e-14 found.
    assert!(traced.fact("energy_balance") < 1e-9);
    assert_eq!(traced.report.steps, 220);
}

#[test]
#[ignore = "570 events on 2400 points; of the long suite"]
fn a_ductile_specimen_is_traced_on_a_finer_lattice() {
    let traced = follow(&specimen(DUCTILE, 10, 3.0, &json!({}), &json!({ "control": "event" })));
    near(traced.fact("first_yield_load_factor") * 3.0, 0.14791, 1e-3);
    near(traced.fact("first_yield_load"), 6787.9, 1e-3);
    near(traced.peak().load, 16045.9, 1e-3);
    near(traced.peak().load_factor * 3.0, 0.43295, 1e-3);
    near(traced.peak().probes[1], 0.5939, 1e-3);
    near(traced.load_at(0.6), 9905.8, 1e-3);
    near(traced.load_at(1.0), 2878.5, 1e-3);
    // 4e-12 found.
    assert!(traced.fact("energy_balance") < 1e-6);
}

#[test]
fn a_ductile_specimen_is_pulled_apart_in_steps() {
    let path = json!({ "increment": 1.0 / 60.0 });
    for (unloading, peak, dissipated) in [("plastic", 15910.0, 9870.0), ("damage", 15902.0, 9746.0)] {
        let case = specimen(DUCTILE, 10, 3.0, &json!({ "unloading": unloading }), &path);
        let pulled = follow(&case);
        assert_eq!((pulled.report.steps, pulled.report.refused_steps), (60, 0));
        // 3.0 and 2.7 found, with 4.2 and 3.3 factorisations.
        assert!(pulled.report.mean_iterations <= 4.0 && pulled.report.mean_factorisations <= 5.0);
        near(pulled.peak().load, peak, 5e-3);
        near(pulled.load_at(0.6), 9863.0, 5e-3);
        near(pulled.load_at(1.0), 2871.0, 5e-3);
        near(pulled.fact("dissipated_energy"), dissipated, 0.02);
        // 2e-10 and 3.8e-3 found.
        assert!(pulled.fact("work_identity") < 1e-9 && pulled.fact("energy_balance") < 5e-3);
    }
}

#[test]
fn an_unloaded_specimen_keeps_the_stretch_of_its_bonds_or_none() {
    let path = json!({ "increment": 0.025 / 0.6, "turns": [ { "load_factor": 1 }, { "load": 0 } ] });
    for (unloading, left) in [("plastic", 0.3073), ("damage", 0.0)] {
        let end = follow(&specimen(DUCTILE, 5, 0.6, &json!({ "unloading": unloading }), &path));
        let last = end.points.last().expect("states");
        assert!(last.load.abs() < 1e-6 * end.peak().load, "{}", last.load);
        assert!((last.probes[1] - left).abs() <= 0.01 * left + 1e-6, "{unloading}: {}", last.probes[1]);
    }
}

#[test]
fn a_brittle_specimen_snaps_back() {
    let traced = follow(&specimen(BRITTLE, 5, 2.0, &json!({}), &json!({})));
    assert_eq!(traced.report.control, peristat::case::PathControl::Event);
    near(traced.peak().load, 14240.8, 1e-3);
    // 86 found, 83 in an independent Python implementation, which stops earlier.
    assert!(traced.fact("snap_back_steps") > 50.0);
    // 3e-13 found.
    assert!(traced.fact("energy_balance") < 1e-6);
}

#[test]
#[ignore = "24 steps on 5400 and 9600 points; of the long suite"]
fn peaks_converge_from_below() {
    let path = json!({ "increment": 1.0 / 24.0 });
    let peak = |cells| follow(&specimen(DUCTILE, cells, 1.2, &json!({}), &path)).peak().load;
    let found = [5, 10, 15, 20].map(peak);
    for (found, expected) in found.into_iter().zip([15420.0, 15910.0, 16053.0, 16185.0]) {
        near(found, expected, 0.01);
    }
    assert!(found.is_sorted());
}

#[test]
fn a_horizon_beyond_the_largest_is_refused_with_both() {
    // 16π/15 E G/σ_y² = 8.98 against 3 × 3.125.
    let mut case = specimen(BRITTLE, 5, 2.0, &json!({}), &json!({}));
    case["body"]["compact_tension"]["width"] = json!(62.5);
    let message = scene(&case).expect_err("it is refused").to_string();
    assert!(message.contains("the horizon 9.375 is not below 8.98"), "{message}");
}
