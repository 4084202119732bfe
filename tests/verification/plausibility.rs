//! Answers that their models cannot give: what is reported of them, and where nothing is.

use peristat::Loaded;
use peristat::run::{RunOptions, taking};
use std::path::Path;

/// All warnings of a run of a case of the gallery with all its fields.
fn case_warnings(case: &str, overrides: &[&str]) -> Vec<String> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(case).with_extension("json");
    let overrides: Vec<String> = overrides.iter().map(ToString::to_string).collect();
    let loaded = Loaded::read(&file, &overrides, None).unwrap_or_else(|error| panic!("{case}: {error}"));
    let options = RunOptions { recover: true, max_memory: None, compare: true };
    let summary = loaded.run(&options, None, &mut taking(|_| Ok(())));
    summary.unwrap_or_else(|error| panic!("{case}: {error}")).warnings
}

/// Warnings on the answer: those that name what is not small.
fn doubts(case: &str, overrides: &[&str]) -> Vec<String> {
    let all = case_warnings(case, overrides);
    all.into_iter().filter(|text| text.contains("check the units of loads")).collect()
}

#[test]
fn strains_that_are_not_small_are_told_once() {
    assert!(doubts("plate/uniaxial_tension", &[]).is_empty());
    // 100 MPa over 210 MPa, as of gigapascals taken for megapascals. The stress goes with it.
    let soft = ["model.bond_plane.youngs_modulus=210", "checks=[]"];
    let found = doubts("plate/uniaxial_tension", &soft);
    assert!(found.len() == 1 && found[0].contains("a strain of 47.619 %"), "{found:#?}");
    // ν times this across leaves no rotation.
    let state = ["model.state_plane.youngs_modulus=210", "checks=[]"];
    assert!(doubts("plate/state_tension", &state)[0].contains("a strain of 47.619 %"));
}

#[test]
fn a_shaft_of_a_density_in_other_units_is_told() {
    let found = doubts("axisymmetric/spinning", &["density=7.85e-3", "checks=[]"]);
    // 1e6 times the largest displacement of the case.
    assert!(
        found.iter().any(|text| text.contains("a displacement of 5219.08 is larger than the body, 100")),
        "{found:#?}"
    );
    assert!(found.iter().any(|text| text.contains("a strain of")), "{found:#?}");
}

#[test]
fn a_girder_that_sags_beyond_its_length_is_told_in_three_ways() {
    let found = doubts("beam/tube", &["loads[0].distributed.force.uniform=1.5e4", "checks=[]"]);
    let has = |words: &str| found.iter().any(|text| text.contains(words));
    // 1e4 times 5.14 mm of 1500; the stress of 45.6 MPa over 7e4; q L³/(24 EI) in degrees.
    assert!(has("at 750: a displacement of 51400.8 is larger than the body, 1500"), "{found:#?}");
    assert!(has("at 750: a strain of 652.098 %"), "{found:#?}");
    assert!(has("a rotation of 6"), "{found:#?}");
    assert_eq!(found.len(), 3);
}

#[test]
fn rotations_are_those_of_the_body_and_turned_points_are_held_to_them() {
    assert!(doubts("plate/turned_points", &[]).is_empty());
    let found = doubts(
        "frame/steel_portal",
        &["load_cases[0].loads[0].distributed.force_y.uniform=-4e6", "checks=[]"],
    );
    assert!(found.iter().any(|text| text.contains("a rotation of")), "{found:#?}");
}

#[test]
fn numbers_without_units_are_not_doubted() {
    let large = ["model.bond_plane.youngs_modulus=2.6", "checks=[]"];
    assert_eq!(doubts("plate/uniaxial_tension", &large).len(), 2);
    let none = ["model.bond_plane.youngs_modulus=2.6", "checks=[]", "units=none"];
    let all = case_warnings("plate/uniaxial_tension", &none);
    assert!(all.is_empty(), "{all:#?}");
}

#[test]
fn tips_of_cracks_are_left_out() {
    assert!(doubts("plate/crack_tips", &[]).is_empty());
}

/// Warnings that hold some words.
fn told(case: &str, overrides: &[&str], words: &str) -> usize {
    case_warnings(case, overrides).iter().filter(|text| text.contains(words)).count()
}

#[test]
fn weight_and_spin_across_mirrors_are_told() {
    let across = "stands across the weight";
    assert_eq!(told("solid/own_weight", &["checks=[]"], across), 0);
    // Beyond `left` a weight along x acts the other way, beyond `back` not.
    let sideways = ["loads[0].gravity.along=[1,-1,0]", "checks=[]"];
    assert_eq!(told("solid/own_weight", &sideways, across), 1);
    let beside = "does not lie in the mirror";
    assert_eq!(told("plate/spinning_ring", &["checks=[]"], beside), 0);
    assert_eq!(told("plate/spinning_ring", &["loads[0].spin.about=[1,0]", "checks=[]"], beside), 1);
    assert_eq!(told("solid/spinning_bar", &["checks=[]"], beside), 0);
    // About x the mirrors `bottom` and `back` have to hold the axis, about z `left` and `bottom`.
    let moved = "loads[0].spin.about=[1,2,3]";
    assert_eq!(told("solid/spinning_bar", &[moved, "checks=[]"], beside), 2);
    assert_eq!(told("solid/spinning_bar", &[moved, "loads[0].spin.axis=x", "checks=[]"], beside), 2);
}

#[test]
fn a_density_that_no_material_has_is_told() {
    let unusual = "is an unusual density";
    assert_eq!(told("beam/own_weight", &["checks=[]"], unusual), 0);
    // Kilograms in a case in millimetres, and the other way round.
    assert_eq!(told("axisymmetric/spinning", &["density=7850", "checks=[]"], unusual), 1);
    assert_eq!(told("beam/own_weight", &["density=7.85e-9", "checks=[]"], unusual), 1);
    assert_eq!(
        told(
            "beam/own_weight",
            &["density=7.85e-9", "units=none", "loads[0].gravity.acceleration=9.81", "checks=[]"],
            unusual
        ),
        0
    );
}
