//! Estimated errors of single runs against true ones, where the gallery knows the local solution.

use peristat::Loaded;
use peristat::run::{RunOptions, taking};
use std::path::Path;

/// Cases with the quantity whose true error is the largest of the case; its exact value is that of the check of the case.
/// Left out are cases whose checks hold numbers of the discretised body, of another form or of an infinite body, values that
/// depend on the spacing (the clamps of `case_a`, the diaphragms), and those that break or soften.
const QUICK: [(&str, &str); 15] = [
    ("beam/cantilever_uniform", "energy"),
    ("beam/clamped_clamped_uniform", "energy"),
    ("beam/clamped_guided_uniform", "energy"),
    ("beam/clamped_simply_supported_uniform", "energy"),
    ("beam/distributed_moment", "energy"),
    ("beam/distributed_moment_simply_supported", "energy"),
    ("beam/foundation_table", "turn"),
    ("beam/simply_supported_sine", "energy"),
    ("beam/simply_supported_uniform", "energy"),
    ("beam/two_span", "energy"),
    ("frame/foundation_beam", "edge"),
    ("axisymmetric/lame", "radial stress"),
    ("plate/bending_strip", "stress in the middle"),
    ("plate/state_ring", "widening inside"),
    ("shell/ovalling", "w of the first row"),
];

/// The same, of the long suite.
const LONG: [(&str, &str); 17] = [
    ("axisymmetric/closed_ends", "axial stress"),
    ("axisymmetric/external_pressure", "radial stress"),
    ("axisymmetric/incompressible_4999", "widening inside"),
    ("axisymmetric/incompressible_499999", "widening inside"),
    ("axisymmetric/open_cylinder", "axial stress"),
    ("axisymmetric/open_cylinder_moment_plus", "axial displacement of the end"),
    ("axisymmetric/open_ends", "axial displacement"),
    ("axisymmetric/sphere", "rise on the axis"),
    ("axisymmetric/spinning", "widening"),
    ("plate/cantilever", "tip"),
    ("plate/hanging_strip", "tip"),
    ("plate/plate_with_hole", "stress at the hole"),
    ("plate/plate_with_hole_off_lines", "stress above the hole"),
    ("plate/ring", "hoop stress"),
    ("plate/state_bending", "rise of the upper edge"),
    ("plate/state_incompressible", "widening inside"),
    ("plate/stretched_in_steps", "contraction"),
];

/// Beams with other laws: their exact values are those of the law `exact`, which has no error at points.
const LAWS: [(&str, &str, &str); 6] = [
    ("beam/cantilever", "tip", "corrected"),
    ("beam/graded_geometric", "largest w", "corrected"),
    ("beam/load_steps", "tip [step 4]", "corrected"),
    ("beam/published", "tip", "published"),
    ("beam/slender_corrected", "largest w", "corrected"),
    ("beam/slender_published", "middle", "published"),
];

fn load(case: &str, overrides: &[&str]) -> Loaded {
    let driver = Path::new(env!("CARGO_MANIFEST_DIR"));
    let file = driver.join("../../cases").join(case).with_extension("json");
    let overrides: Vec<String> = overrides.iter().map(ToString::to_string).collect();
    Loaded::read(&file, &overrides, None).unwrap_or_else(|error| panic!("{error}"))
}

fn solve(loaded: &Loaded) -> peristat::summary::Summary {
    loaded
        .run(&RunOptions::default(), None, &mut taking(|_| Ok(())))
        .unwrap_or_else(|error| panic!("{error}"))
}

/// Estimated over true error of a quantity whose exact value is `exact`, or that of the check of the case.
fn ratio(case: &str, quantity: &str, exact: Option<f64>, overrides: &[&str]) -> f64 {
    let loaded = load(case, overrides);
    let summary = solve(&loaded);
    let estimates = loaded.estimate(&summary, None).unwrap_or_else(|reason| panic!("{case}: {reason}"));
    let of = estimates
        .quantities
        .iter()
        .rfind(|e| e.name == quantity || e.name.starts_with(&format!("{quantity} [")));
    let of = of.unwrap_or_else(|| panic!("{case} has no estimate of {quantity}: {estimates:#?}"));
    let checked = || {
        let named = |name: &str| name == quantity || (quantity == "energy" && name.starts_with("energy "));
        summary.checks.iter().find(|c| named(&c.name)).map(|c| c.expected)
    };
    let exact = exact.or_else(checked).unwrap_or_else(|| panic!("{case} does not know {quantity}"));
    let error = (of.value - exact).abs();
    assert!(error > 1e-10 * exact.abs(), "{case}, {quantity}: nothing to estimate");
    of.error / error
}

fn exact_law(case: &str, quantity: &str) -> f64 {
    let loaded = load(case, &["model.timoshenko_beam.bond_law=exact", "checks=[]"]);
    let estimates =
        loaded.estimate(&solve(&loaded), None).unwrap_or_else(|reason| panic!("{case}: {reason}"));
    let of = estimates.quantities.iter().find(|e| e.name == quantity);
    of.unwrap_or_else(|| panic!("{case} has no {quantity}")).value
}

fn ratios(cases: &[(&str, &str)]) -> Vec<(String, f64)> {
    cases.iter().map(|(case, quantity)| ((*case).to_string(), ratio(case, quantity, None, &[]))).collect()
}

fn of_laws() -> Vec<(String, f64)> {
    let of = |(case, quantity, law): &(&str, &str, &str)| {
        let law = format!("model.timoshenko_beam.bond_law={law}");
        ((*case).to_string(), ratio(case, quantity, Some(exact_law(case, quantity)), &[&law]))
    };
    LAWS.iter().map(of).collect()
}

/// Cases whose estimate is off by more than a factor of two.
fn off(ratios: &[(String, f64)]) -> Vec<&(String, f64)> {
    ratios.iter().filter(|(_, ratio)| !(0.5..=2.0).contains(ratio)).collect()
}

#[test]
fn estimates_are_within_a_factor_of_two() {
    let found = [ratios(&QUICK), of_laws()].concat();
    // 0.95 to 1.78, `slender_published`, which locks.
    assert!(off(&found).is_empty(), "{found:#?}");
}

#[test]
#[ignore = "spacings a third of those of the gallery; of the long suite"]
fn nine_of_ten_estimates_are_within_a_factor_of_two_and_none_is_too_small() {
    let found = [ratios(&QUICK), of_laws(), ratios(&LONG)].concat();
    // 34 of 38. The others, values that happen to be better than their neighbours, are told 2.4 to 4.4 times too large.
    assert!(found.iter().all(|(_, ratio)| (0.5..=5.0).contains(ratio)), "{found:#?}");
    assert!(found.len() - off(&found).len() >= 34, "{found:#?}");
}
