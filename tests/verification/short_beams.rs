//! Beams of one, two or three cells, shorter than their horizon.

use crate::support::standard::{CASES, SECTIONS, Standard};
use crate::support::{Run, error, run, scene};
use peristat::diagnostic::Severity;
use serde_json::json;

/// Largest error of w/L and φ relative to the largest of both: one of them may vanish at all points.
fn joint_error(run: &Run, exact: impl Fn(f64) -> (f64, f64)) -> f64 {
    let expected = run.x().into_iter().map(exact);
    let (w, phi): (Vec<f64>, Vec<f64>) = expected.unzip();
    error(&run.unknowns(0).concat(), &[w, phi].concat())
}

#[test]
fn beams_shorter_than_their_horizon_are_exact() {
    for section in SECTIONS {
        for standard in CASES {
            for cells in [1, 2, 3] {
                for m in [1, 2, 3, 7] {
                    let clamped = standard.name == "clamped ends, uniform load";
                    if cells == 1 && clamped {
                        // Both points are held: nothing is left to solve.
                        continue;
                    }
                    let mut case = standard.unsplit(&section, "exact", cells);
                    case["horizon_ratio"] = json!(m);
                    let error = joint_error(&run(&case), standard.exact(&section));
                    // Measured 2e-15.
                    assert!(
                        error <= 1e-13,
                        "{}, {section:?}, {cells} cells, m = {m}: {error:e}",
                        standard.name
                    );
                }
            }
        }
    }
}

#[test]
fn one_cell_is_one_element_of_the_textbook() {
    // Every law: the bond of the only cell carries the whole beam. With S_b the bond's shear stiffness,
    // w = F (L³/4B + L/S_b) and φ = F L²/2B at the tip.
    let section = SECTIONS[0];
    let (b, s) = section.stiffness();
    let standard = Standard::named("cantilever under a tip force");
    // ⟨ξ²⟩ = h² Σ n³ α_n / Σ n α_n: 1 for m = 1, (1 + 4)/2 for m = 2, 5 for m = 3, of the full family.
    for (law, m, shear) in [
        ("published", 3, s),
        ("exact", 3, 1.0 / (1.0 / s + 1.0 / (12.0 * b))),
        ("corrected", 1, 1.0 / (1.0 / s + 1.0 / (12.0 * b))),
        ("corrected", 2, 1.0 / (1.0 / s + 2.5 / (12.0 * b))),
        ("corrected", 3, 1.0 / (1.0 / s + 5.0 / (12.0 * b))),
    ] {
        let mut case = standard.case(&section, law, 1);
        case["horizon_ratio"] = json!(m);
        let run = run(&case);
        let [w, phi] = run.unknowns(0).map(|plane| plane[1]);
        let (w_expected, phi_expected) = (section.force * (0.25 / b + 1.0 / shear), section.force * 0.5 / b);
        assert!((w / w_expected - 1.0).abs() <= 1e-14, "{law}, m = {m}: {w} for {w_expected}");
        assert!((phi / phi_expected - 1.0).abs() <= 1e-14, "{law}, m = {m}: {phi} for {phi_expected}");
    }
}

#[test]
fn a_horizon_longer_than_the_beam_is_a_warning_where_it_counts() {
    let standard = Standard::named("cantilever under a tip force");
    let corrected = [(3, 3, false), (2, 3, true), (1, 1, false), (1, 2, true)];
    let laws = corrected.map(|row| ("corrected", row)).into_iter().chain([("exact", (1, 3, false))]);
    for (law, (cells, m, expected)) in laws {
        let mut case = standard.case(&SECTIONS[0], law, cells);
        case["horizon_ratio"] = json!(m);
        let report = scene(&case).warnings.into_report("case", "");
        let longer = |d: &peristat::diagnostic::Diagnostic| {
            d.severity == Severity::Warning && d.message.contains("longer than the beam")
        };
        assert_eq!(report.diagnostics.iter().any(longer), expected, "{cells} cells, m = {m}");
    }
}
