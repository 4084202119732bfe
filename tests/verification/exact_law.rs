//! The law `exact`: nodal values equal the local solution to rounding, whatever the spacing and the horizon.

use crate::support::run;
use crate::support::standard::{CASES, SECTIONS, Section, Standard};
use serde_json::json;

/// Largest error of w and φ over all standard cases on a section.
fn worst(section: &Section, cells: usize, horizon_ratio: f64) -> (f64, &'static str) {
    let mut worst = (0.0, "");
    for standard in CASES {
        let mut case = standard.case(section, "exact", cells);
        case["horizon_ratio"] = json!(horizon_ratio);
        for solver in ["band", "strain"] {
            case["solver"] = json!(solver);
            for error in run(&case).errors(standard.exact(section)) {
                if error > worst.0 {
                    worst = (error, standard.name);
                }
            }
        }
    }
    worst
}

#[test]
fn nodal_values_are_exact_for_all_standard_cases_and_slendernesses() {
    for section in SECTIONS {
        for cells in [10, 100, 1000] {
            let (error, name) = worst(&section, cells, 3.0);
            // A1, measured 1.2e-14 on the clamped and simply supported beam, whose closed form has cancellations; 2e-15
            // on the others.
            assert!(error <= 1e-13, "{name}, {section:?}, {cells} cells: {error:e}");
        }
    }
}

#[test]
fn nodal_values_are_exact_on_a_hundred_thousand_cells() {
    for section in [SECTIONS[1], SECTIONS[3]] {
        let (error, name) = worst(&section, 100_000, 3.0);
        // A2, measured 8e-14 (slenderness 1e4) and 1e-14 (20).
        assert!(error <= 1e-12, "{name}, {section:?}: {error:e}");
    }
}

#[test]
fn nodal_values_are_exact_on_a_million_cells() {
    let standard = Standard::named("cantilever under a uniform load");
    for section in [SECTIONS[1], SECTIONS[3]] {
        let mut case = standard.case(&section, "exact", 1_000_000);
        case["solver"] = json!("band");
        let errors = run(&case).errors(standard.exact(&section));
        // A3, measured 2.6e-14 (slenderness 1e4) and 5e-15 (20).
        assert!(errors.iter().all(|e| *e <= 1e-11), "{section:?}: {errors:?}");
    }
}

#[test]
fn nodal_values_are_exact_for_every_whole_horizon_ratio() {
    for section in SECTIONS {
        for m in [1, 2, 4, 5, 8, 12] {
            for cells in [4, 10, 60] {
                let (error, name) = worst(&section, cells, f64::from(m));
                // A6, measured 7e-15.
                assert!(error <= 1e-12, "{name}, {section:?}, m = {m}, {cells} cells: {error:e}");
            }
        }
    }
}

#[test]
fn nodal_values_are_exact_for_horizons_that_are_no_multiple_of_the_spacing() {
    for section in SECTIONS {
        for ratio in [3.015, 2.5, 1.3] {
            let (error, name) = worst(&section, 60, ratio);
            // Measured 7e-15.
            assert!(error <= 1e-12, "{name}, {section:?}, ratio {ratio}: {error:e}");
        }
    }
}

#[test]
fn a_force_shared_by_the_bonds_is_exact_on_and_between_points() {
    for section in SECTIONS {
        let standard = Standard::named("simple supports, force at mid-span");
        // On a point, and in the middle of a cell.
        for cells in [60, 61] {
            let errors = run(&standard.unsplit(&section, "exact", cells)).errors(standard.exact(&section));
            // Measured 7e-16.
            assert!(errors.iter().all(|e| *e <= 1e-13), "{section:?}, {cells}: {errors:?}");
        }
    }
}
