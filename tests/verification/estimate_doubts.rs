//! Estimated errors where grids are coarse, or values no power of the spacing: beams with other laws and ends, plates of few
//! rows. And what estimates cost.
#![allow(clippy::print_stdout)]

use crate::support;
use peristat::case::from_text;
use peristat::input::Folder;
use peristat::run::{RunOptions, taking};
use peristat::summary::{Estimates, Grids, Summary};
use peristat::{Loaded, run};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use std::time::Instant;

const LENGTH: f64 = 2.0;
const BENDING: f64 = 100.0;
const SHEAR: f64 = 1e6;

fn load(case: &Value) -> Loaded {
    let source = from_text("case", format!("{case:#}"), &[], &Folder::default())
        .unwrap_or_else(|error| panic!("{error}"));
    Loaded::from_source(source, Path::new(".").into(), None).unwrap_or_else(|error| panic!("{error}"))
}

fn solve(loaded: &Loaded) -> Summary {
    let options = RunOptions { recover: true, max_memory: None, compare: true };
    loaded.run(&options, None, &mut taking(|_| Ok(()))).unwrap_or_else(|error| panic!("{error}"))
}

fn estimates(case: &Value) -> Estimates {
    let loaded = load(case);
    loaded.estimate_cheaply(&solve(&loaded), None).unwrap_or_else(|reason| panic!("{reason}: {case}"))
}

/// Estimated over true error of a quantity.
fn ratio(estimates: &Estimates, name: &str, truth: f64) -> f64 {
    let of = estimates.quantities.iter().find(|e| e.name == name).expect("an estimate of this name");
    of.error / (of.value - truth).abs()
}

/// A beam under a uniform load with a probe near its middle, at the position that is returned.
fn beam(is_clamped: bool, law: &str, treatment: &str, cells: usize) -> (Value, f64) {
    let on_cells = treatment == "cells";
    let x = LENGTH / 2.0 + if on_cells { LENGTH / (2 * cells) as f64 } else { 0.0 };
    let end = |x: f64| match is_clamped {
        true => json!({ "at": { "x": x }, "w": 0, "phi": 0 }),
        false => json!({ "at": { "x": x }, "w": 0 }),
    };
    let mut case = json!({
        "title": "t",
        "model": { "timoshenko_beam": { "bond_law": law,
            "stiffness": { "bending": { "uniform": BENDING }, "shear": { "uniform": SHEAR } } } },
        "body": { "line": { "length": LENGTH, "cells": cells, "grid": if on_cells { "cells" } else { "nodes" } } },
        "supports": [end(0.0), end(LENGTH)],
        "loads": [{ "distributed": { "force": { "uniform": 1 } } }],
        "probes": [{ "name": "w", "at": { "x": x }, "field": "w" }]
    });
    if !on_cells {
        case["model"]["timoshenko_beam"]["end_treatment"] = json!(treatment);
    }
    (case, x)
}

/// Deflection at x, and stored energy, of that beam as the local theory has them.
fn local(is_clamped: bool, x: f64) -> [f64; 2] {
    let (l, rest) = (LENGTH, LENGTH - x);
    let sheared = x * rest / (2.0 * SHEAR);
    let bent = match is_clamped {
        true => [x * x * rest * rest / 24.0, l.powi(5) / 1440.0],
        false => [x * (l.powi(3) - 2.0 * l * x * x + x.powi(3)) / 24.0, l.powi(5) / 240.0],
    };
    [bent[0] / BENDING + sheared, bent[1] / BENDING + l.powi(3) / (24.0 * SHEAR)]
}

#[test]
fn errors_of_beams_with_other_laws_ends_and_grids_are_known() {
    let mut furthest: f64 = 1.0;
    for is_clamped in [true, false] {
        for law in ["exact", "corrected", "published"] {
            for treatment in ["cover", "truncated", "ghost", "cells"] {
                for cells in [4, 6, 32] {
                    let (case, x) = beam(is_clamped, law, treatment, cells);
                    let [deflection, energy] = local(is_clamped, x);
                    let told = estimates(&case);
                    if (law, treatment) == ("exact", "cover") {
                        continue;
                    }
                    assert_eq!(told.kind, Grids::ExactBeam);
                    let of_w = ratio(&told, "w", deflection);
                    assert!((of_w - 1.0).abs() < 1e-6, "{of_w}: {case}");
                    let of_energy = ratio(&told, "energy", energy);
                    furthest = furthest.max(of_energy).max(1.0 / of_energy);
                    assert!((0.5..=2.0).contains(&of_energy), "{of_energy}: {case}");
                }
            }
        }
    }
    println!("energies within a factor of {furthest:.2}");
}

#[test]
fn on_a_foundation_no_error_is_below_the_distance_from_the_exact_beam() {
    let on_foundation = |law: &str, cells: usize| {
        let (mut case, _) = beam(true, law, "cover", cells);
        case["foundation"] = json!([{ "stiffness": { "uniform": 100.0 } }]);
        case
    };
    let truth = solve(&load(&on_foundation("exact", 512))).probes[0].value;
    for (law, cells) in [("published", 4), ("published", 8), ("published", 12)] {
        let told = ratio(&estimates(&on_foundation(law, cells)), "w", truth);
        println!("{told:.2} {law}, {cells} cells");
        // 1.00 each. From the coarser grids alone 0.00, 0.03 and 0.16.
        assert!((0.5..=2.0).contains(&told), "{told}: {law}, {cells} cells");
    }
}

/// A strip in pure bending, loaded on both ends or mirrored at the left one; probes with their exact values.
fn bent(size: [f64; 2], h: f64, is_mirrored: bool) -> (Value, Vec<(&'static str, f64)>) {
    let ([l, height], rows) = (size, (size[1] / h).round());
    let y = height / 2.0 - if rows % 2.0 == 0.0 { h / 2.0 } else { 0.0 };
    let top = height - h / 2.0;
    let mut case = json!({
        "title": "t",
        "model": { "bond_plane": { "youngs_modulus": 70000, "state": "plane_stress" } },
        "body": { "rectangle": { "size": size, "spacing": h } },
        "loads": [{ "traction": { "edge": "right", "linear": [[-100, 0], [100, 0]] } }],
        "probes": [
            { "name": "end deflection", "at": { "x": l - h / 2.0, "y": y }, "field": "uy" },
            { "name": "stress", "at": { "x": h / 2.0, "y": top }, "field": "stress_xx" },
            { "name": "end turn", "at": { "x": l - h / 2.0, "y": top }, "field": "ux" }
        ]
    });
    if is_mirrored {
        case["symmetry"] = json!(["left"]);
        case["supports"] = json!([{ "at": { "x": h / 2.0, "y": y }, "uy": 0 }]);
    } else {
        let left = json!({ "traction": { "edge": "left", "linear": [[100, 0], [-100, 0]] } });
        case["loads"].as_array_mut().expect("a list").push(left);
        case["supports"] = json!([{ "at": { "x": h / 2.0, "y": y }, "ux": 0, "uy": 0 },
                                  { "at": { "x": h / 2.0, "y": y + 2.0 * h }, "ux": 0 }]);
    }
    let (start, slope) = (if is_mirrored { 0.0 } else { h / 2.0 }, 200.0 / height);
    let k = slope / 70000.0;
    let rise = |x: f64| -k / 2.0 * (x - start) * (x - start);
    let known = vec![
        ("end deflection", rise(l - h / 2.0) - rise(h / 2.0)),
        ("stress", slope * (top - height / 2.0)),
        ("end turn", k * (l - h / 2.0 - start) * (top - height / 2.0)),
    ];
    (case, known)
}

#[test]
fn of_plates_of_few_rows_no_error_is_told_far_too_small() {
    let sizes = [([20.0, 8.0], [0.5, 1.0]), ([21.0, 9.0], [0.5, 1.0]), ([12.0, 12.0], [0.75, 1.5])];
    let mut ratios = Vec::new();
    for (size, spacings) in sizes {
        for (h, is_mirrored) in spacings.into_iter().flat_map(|h| [(h, true), (h, false)]) {
            let (case, known) = bent(size, h, is_mirrored);
            let told = estimates(&case);
            for (name, truth) in known {
                let ratio = ratio(&told, name, truth);
                println!("{ratio:.2} {size:?}, {h}, mirrored {is_mirrored}: {name}");
                ratios.push(ratio);
            }
        }
    }
    let enough = ratios.iter().filter(|ratio| **ratio >= 1.0 / 3.0).count() as f64 / ratios.len() as f64;
    let least = ratios.iter().copied().fold(f64::INFINITY, f64::min);
    println!("{} quantities, {enough:.3}, the smallest {least:.3}", ratios.len());
    // 36 quantities, 0.92, the smallest 0.13. Without a floor under what agrees by chance 0.78 and 0.04.
    assert!(enough >= 0.85 && least >= 0.1, "{enough}, {least}");
}

#[test]
fn many_probes_of_many_load_cases_are_estimated_in_no_time() {
    let (mut case, _) = beam(true, "exact", "cover", 96);
    let uniform = json!([{ "distributed": { "force": { "uniform": 1 } } }]);
    case["loads"] = json!([]);
    case["load_cases"] = (0..200).map(|k| json!({ "name": format!("case {k}"), "loads": uniform })).collect();
    let probe =
        |k: usize| json!({ "name": format!("probe {k}"), "at": { "x": 0.5 * (k % 4) as f64 }, "field": "w" });
    case["probes"] = (0..200).map(probe).collect();
    let loaded = load(&case);
    let summary = solve(&loaded);
    let begin = Instant::now();
    let found = loaded.estimate_cheaply(&summary, None).unwrap_or_else(|reason| panic!("{reason}"));
    let seconds = begin.elapsed().as_secs_f64();
    println!("{} quantities in {seconds:.2} s", found.quantities.len());
    assert_eq!(found.quantities.len(), 200 * 201);
    // 0.12 s; each quantity looked for among all of them took 32 s for a third as many.
    assert!(seconds < 10.0, "{seconds} s");
}

#[test]
fn a_beam_is_not_compared_where_nobody_asks() {
    let (case, _) = beam(true, "published", "truncated", 8);
    let scene = support::scene(&case);
    let report = |compare: bool| {
        let options = RunOptions { recover: false, max_memory: None, compare };
        run::beam::run(&scene, &options, &mut |_| Ok(())).unwrap_or_else(|error| panic!("{error}"))
    };
    let [alone, compared] = [false, true].map(report);
    assert!(alone.exact.is_none() && alone.timing.compare == 0.0 && alone.warnings.is_empty());
    assert!(compared.exact.is_some() && compared.timing.compare > 0.0 && !compared.warnings.is_empty());
}

#[test]
fn a_state_based_plate_without_a_grid_of_twice_the_spacing_takes_one_that_is_cheap() {
    // 81 by 21 points: 0.4 of the instructions of the run. Those of 3/2 and 3 times the spacing were 1.3 of it.
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/plate/state_bending.json");
    let mut case: Value = serde_json::from_str(&fs::read_to_string(file).unwrap()).unwrap();
    case["checks"] = json!([]);
    let spacings = estimates(&case).spacings;
    assert_eq!(spacings, [3.0]);
}
