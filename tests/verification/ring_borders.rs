//! Bodies of revolution whose bonds end on their border, from the cases of the gallery.

use serde_json::Value;
use std::path::Path;

/// The found and the expected values of the checks of a case with the edges `border` and a horizon ratio.
fn checked(name: &str, ratio: f64) -> Vec<(String, f64, f64)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/axisymmetric");
    let file = folder.join(name).with_extension("json");
    let text = std::fs::read_to_string(&file).expect("the case can be read");
    let mut case: Value = serde_json::from_str(&text).expect("a case is JSON");
    case["model"]["axisymmetric"]["edges"] = "border".into();
    case["horizon_ratio"] = ratio.into();
    let solved = peristat::solve_text(&case.to_string()).unwrap_or_else(|error| panic!("{error}"));
    let checks = solved.summary.checks.iter();
    checks.map(|check| (check.name.clone(), check.found, check.expected)).collect()
}

/// The inner and the outer border of a hollow body are parts by themselves, and both have the volumes that their rings have.
#[test]
fn pressure_all_around_is_exact_on_both_borders_of_a_hollow_cylinder() {
    for ratio in [2.0, 3.0] {
        for (name, found, expected) in checked("hydrostatic", ratio) {
            // 7e-15 measured.
            assert!((found / expected - 1.0).abs() < 1e-11, "{ratio} {name}: {found} {expected}");
        }
    }
}

#[test]
fn a_thick_tube_under_pressure_is_that_of_lame() {
    for ratio in [2.0, 3.0] {
        for (name, found, expected) in checked("lame", ratio) {
            // 1.9e-3 measured of the radial stress, 3.4e-4 of the hoop stress, 1.6e-4 of displacements.
            assert!((found / expected - 1.0).abs() < 2.5e-3, "{ratio} {name}: {found} {expected}");
        }
    }
}
