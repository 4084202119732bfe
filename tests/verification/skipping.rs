//! What a scene does not need is not done, and the counters of a run say so.

use crate::support::plane::{clamped_square, displacements};
use crate::support::run;
use crate::support::standard::{SECTIONS, Standard, steel};
use serde_json::json;

fn cantilever(cells: usize) -> serde_json::Value {
    Standard::named("cantilever under a uniform load").case(&SECTIONS[1], "corrected", cells)
}

#[test]
fn a_second_load_case_does_not_factor_again() {
    let mut case = steel(0.05, "corrected", 60);
    case["supports"] = json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }]);
    let load = |x: f64| json!([{ "point": { "at": { "x": x }, "force": 1.0 } }]);
    case["load_cases"] = json!([
        { "name": "tip", "loads": load(1.0) }, { "name": "middle", "loads": load(0.5) }
    ]);
    case["combinations"] = json!([{ "name": "both", "factors": { "tip": 1.35, "middle": 1.5 } }]);
    let report = run(&case).report;
    assert_eq!(report.counters.right_hand_sides, 3);
    assert_eq!((report.counters.factorisations, report.counters.analyses), (1, 0));
    let said = "2 factorisations: the stiffness does not depend on the load";
    assert!(report.skipped.iter().any(|s| s == said), "{:?}", report.skipped);
}

#[test]
fn load_steps_share_one_factor_and_one_analysis() {
    let mut case = cantilever(60);
    case["steps"] = json!({ "load_factors": [0.25, 0.5, 0.75, 1.0] });
    case["solver"] = json!("sparse");
    let report = run(&case).report;
    let counters = &report.counters;
    assert_eq!((counters.right_hand_sides, counters.factorisations, counters.analyses), (4, 1, 1));
    assert!(!report.skipped.iter().any(|s| s.contains("symbolic")), "{:?}", report.skipped);
}

#[test]
fn a_straight_beam_has_no_axial_unknowns_and_no_newton_iterations() {
    let run = run(&cantilever(60));
    // Two unknowns per point, less the two that the clamp holds.
    assert_eq!((run.report.sizes.points, run.report.sizes.unknowns), (61, 2 * 61 - 2));
    for start in ["axial unknowns", "Newton iterations", "symbolic analysis", "section forces"] {
        let said = run.report.skipped.iter().any(|s| s.starts_with(start));
        assert!(said, "{start}: {:?}", run.report.skipped);
    }
}

#[test]
fn a_uniform_beam_stores_nothing_per_bond_in_its_interior() {
    let counters = |cells| run(&cantilever(cells)).report.counters;
    let stored: Vec<usize> =
        [1_000, 10_000, 100_000].map(|cells| counters(cells).stored_bond_factors).to_vec();
    // A chunk of 64 points times three classes at each end.
    assert!(stored.iter().all(|s| *s <= 4 * 64 * 3), "{stored:?}");
    let largest = stored.iter().max().expect("three runs");
    let smallest = stored.iter().min().expect("three runs");
    // An end of the chain may lie close to the border of a chunk and touch two of them.
    assert!(largest - smallest <= 64 * 3, "{stored:?}");
    let said = |cells| {
        run(&cantilever(cells)).report.skipped.iter().any(|s| s.starts_with("factors of interior bonds"))
    };
    assert!(said(10_000));
}

#[test]
fn the_finish_takes_a_few_sweeps_over_the_bonds() {
    let run = run(&cantilever(10_000));
    let (counters, sizes) = (&run.report.counters, &run.report.sizes);
    let sweeps = counters.bond_evaluations / sizes.bonds as u64;
    // Two or three iterations, the residual, the certificate.
    assert!(counters.pcg_iterations <= 4, "{counters:?}");
    assert!(sweeps <= 10, "{counters:?}");
    assert_eq!(counters.bond_evaluations % sizes.bonds as u64, 0, "whole sweeps only");
}

#[test]
fn load_cases_and_steps_of_a_plate_share_one_analysis_and_one_factor() {
    for solver in ["sparse", "multigrid"] {
        let mut case = clamped_square(48);
        case["solver"] = json!(solver);
        let load = |x: f64, y: f64| json!([{ "traction": { "edge": "right", "uniform": [x, y] } }]);
        let mut steps = case.clone();
        case["loads"] = json!([]);
        case["load_cases"] = json!([{ "name": "pull", "loads": load(1e3, 0.0) }, { "name": "shear", "loads": load(0.0, 1e3) }]);
        case["combinations"] = json!([{ "name": "both", "factors": { "pull": 1.35, "shear": 1.5 } }]);
        steps["steps"] = json!({ "load_factors": [0.5, 1.0, 2.0] });
        for case in [case, steps] {
            let report = displacements(&case).report;
            let counters = &report.counters;
            assert_eq!(
                (counters.right_hand_sides, counters.factorisations, counters.analyses),
                (3, 1, 1),
                "{solver}"
            );
            assert_eq!(counters.stored_bond_factors, 0, "{solver}");
            let said = "2 factorisations: the stiffness does not depend on the load";
            assert!(report.skipped.iter().any(|s| s == said), "{:?}", report.skipped);
        }
    }
}
