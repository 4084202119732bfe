//! What probes make of all points of a body, a region or a member: extremes with their places, means and integrals; principal
//! stresses and what follows from them.

use peristat::Solved;
use peristat::run::ProbeResult;
use serde_json::{Value, json};
use std::f64::consts::PI;
use std::fs;
use std::path::Path;

/// A case of the gallery.
fn gallery_case(file: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(file);
    let text = fs::read_to_string(path).expect("a case of the gallery");
    serde_json::from_str(&text).expect("a case")
}

/// Solves a case with other probes, which are named by their numbers, and without checks.
fn solve(mut case: Value, probes: &Value) -> Solved {
    let mut probes = probes.clone();
    for (k, probe) in probes.as_array_mut().expect("a list").iter_mut().enumerate() {
        probe["name"] = json!(k.to_string());
    }
    case["probes"] = probes;
    case["checks"] = json!([]);
    peristat::solve_text(&format!("{case:#}")).expect("a case that can be solved")
}

fn probes(file: &str, probes: &Value) -> Vec<ProbeResult> {
    solve(gallery_case(file), probes).summary.probes
}

fn assert_near(found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs() / if expected == 0.0 { 1.0 } else { expected.abs() };
    assert!(error <= tolerance, "{found} is not {expected}: {error:.1e}");
}

/// What uniaxial stress is over a volume.
fn assert_uniaxial(case: Value, region: &Value, field: &str, stress: f64, volume: f64) {
    let mut asked = json!([
        { "field": field, "of": "integral" },
        { "field": field, "of": "mean" },
        { "field": "principal_stress_1", "of": "largest" },
        { "field": "principal_stress_3", "of": "largest_magnitude" },
        { "field": "max_shear", "of": "smallest" },
        { "field": "hydrostatic", "of": "integral" },
        { "field": "von_mises", "of": "mean" }
    ]);
    if !region.is_null() {
        asked.as_array_mut().expect("a list").iter_mut().for_each(|probe| probe["at"] = region.clone());
    }
    let found = solve(case, &asked).summary.probes;
    let values: Vec<f64> = found.iter().map(|probe| probe.value).collect();
    assert_near(found[0].extent.expect("a volume"), volume, 1e-12);
    let expected = [stress * volume, stress, stress, 0.0, stress / 2.0, stress * volume / 3.0, stress];
    for (k, (found, expected)) in values.iter().zip(expected).enumerate() {
        // 4e-11 is found in the tube, rounding in others.
        let size = if expected == 0.0 { stress } else { expected };
        assert!((found - expected).abs() <= 1e-9 * size, "{k}: {found} is not {expected}");
    }
}

#[test]
fn the_integral_of_one_stress_is_the_stress_times_the_volume() {
    // Volumes from the sizes of the bodies: a plate, half of a round bar, an eighth of a block.
    for (file, field, volume) in [
        ("plate/uniaxial_tension.json", "stress_xx", 40.0 * 20.0 * 2.0),
        ("axisymmetric/solid_bar.json", "stress_yy", PI * 50.0_f64.powi(3)),
        ("solid/tension.json", "stress_xx", 40.0 * 20.0 * 10.0),
    ] {
        assert_uniaxial(gallery_case(file), &Value::Null, field, 100.0, volume);
    }
    // The part of an unrolled tube that its ends do not reach.
    let mut tube = gallery_case("shell/pulled_tube.json");
    tube["regions"]["inside"] = json!({ "box": { "from": [0, 0], "to": [0.3, 0.01] } });
    assert_uniaxial(tube, &json!({ "region": "inside" }), "stress_xx", 2e8, 0.3 * 0.01 * 0.01);
}

#[test]
fn principal_stresses_of_pure_shear_are_the_shear_and_its_opposite() {
    let asked = json!([
        { "field": "principal_stress_1", "of": "largest" },
        { "field": "principal_stress_1", "of": "smallest" },
        { "field": "principal_stress_2", "of": "largest_magnitude" },
        { "field": "principal_stress_3", "of": "mean" },
        { "field": "max_shear", "of": "mean" }
    ]);
    for (file, tau) in [("plate/shear.json", 10.0), ("antiplane/uniform_shear.json", 40.0)] {
        let found: Vec<f64> = probes(file, &asked).iter().map(|p| p.value).collect();
        // 4e-15 τ is found.
        for (found, expected) in found.iter().zip([tau, tau, 0.0, -tau, tau]) {
            assert!((found - expected).abs() < 1e-12 * tau, "{file}: {found} is not {expected}");
        }
    }
    // The direction of tension is half way between the axes, also of what a region has for a mean.
    let direction = json!([
        { "field": "principal_direction", "at": { "x": 10, "y": 20 } },
        { "field": "principal_direction", "at": { "region": "top" } }
    ]);
    probes("plate/shear.json", &direction).iter().for_each(|p| assert_near(p.value, PI / 4.0, 1e-12));
}

#[test]
fn a_solid_under_three_stresses_has_them_for_principal_ones() {
    // Diagonal tractions through planes of symmetry: one stress, to rounding.
    let mut case = gallery_case("solid/tension.json");
    case["loads"] = json!([
        { "traction": { "face": "right", "uniform": [30, 0, 0] } },
        { "traction": { "face": "top", "uniform": [0, -50, 0] } },
        { "traction": { "face": "front", "uniform": [0, 0, 80] } }
    ]);
    let at = json!({ "x": 21, "y": 7, "z": 3 });
    let names =
        ["principal_stress_1", "principal_stress_2", "principal_stress_3", "max_shear", "hydrostatic"];
    let asked: Vec<Value> = names.iter().map(|field| json!({ "field": field, "at": at })).collect();
    let solved = solve(case, &json!(asked));
    let expected = [80.0, 30.0, -50.0, 65.0, 20.0];
    for ((probe, name), expected) in solved.summary.probes.iter().zip(names).zip(expected) {
        assert_near(probe.value, expected, 1e-9);
        // Programs read the same by name, and no table has it.
        let values = solved.field(0, name).unwrap();
        assert!(values.iter().all(|value| (value - expected).abs() < 1e-7), "{name}");
        assert!(!solved.fields(0).unwrap().contains(&name));
        assert!(!solved.summary.states[0].extremes.contains_key(name));
    }
}

#[test]
fn the_largest_bending_stress_is_that_of_the_outermost_row() {
    let asked = json!([
        { "field": "stress_xx", "of": "largest", "at": { "region": "middle" } },
        { "field": "stress_xx", "of": "smallest", "at": { "region": "middle" } },
        { "field": "von_mises", "of": "largest" },
        { "field": "stress_xx", "of": "integral", "at": { "region": "middle" } }
    ]);
    let mut case = gallery_case("plate/bending_strip.json");
    case["regions"] = json!({ "middle": { "box": { "from": [30, 0], "to": [51, 21] } } });
    let solved = solve(case, &asked);
    let found = &solved.summary.probes;
    // σ (2 y/H − 1) in the rows at y = 20.5 and 0.5; 0.09 % is found.
    let row = 100.0 * 20.0 / 21.0;
    for (probe, value, y) in [(&found[0], row, 20.5), (&found[1], -row, 0.5)] {
        assert_near(probe.value, value, 2e-3);
        assert_eq!(probe.y, Some(y));
        assert!(probe.x.is_some_and(|x| (30.0..51.0).contains(&x)) && probe.place.is_none());
    }
    // Of the whole body it is the value of the table, at the same place.
    let table = &solved.summary.states[0].extremes["von_mises"].largest;
    assert_eq!((found[2].value, found[2].x, found[2].y), (table.value, Some(table.x), table.y));
    // A moment has no force: 3e-12 is found.
    assert!(found[3].value.abs() < 1e-8, "{}", found[3].value);
    assert_eq!((found[3].x, found[3].extent), (None, Some(441.0)));
    assert_eq!(found[3].place.as_deref(), Some("the region `middle`"));
}

#[test]
fn an_edge_is_read_where_it_is_and_its_points_half_a_spacing_inside() {
    // u = σ x/E from the middle of the left edge.
    let asked = json!([
        { "field": "ux", "at": { "edge": "right" } },
        { "field": "ux", "at": { "edge": "left" } },
        { "field": "ux", "at": { "region": "right" } },
        { "field": "ux", "at": { "region": "left" } },
        { "field": "stress_xx", "at": { "edge": "top" } }
    ]);
    for edges in ["overlay", "border", "none"] {
        let mut case = gallery_case("plate/uniaxial_tension.json");
        case["model"]["bond_plane"]["edges"] = json!(edges);
        let found = solve(case, &asked).summary.probes;
        let long = |a: usize, b: usize| found[a].value - found[b].value;
        if edges != "none" {
            assert_near(long(0, 1), 100.0 / 70000.0 * 40.0, 1e-10);
            assert_near(long(2, 3), 100.0 / 70000.0 * 39.0, 1e-10);
            assert_near(found[4].value, 100.0, 1e-10);
        }
        // Whatever the border does, they are not the same.
        assert!(long(0, 1) > 1.01 * long(2, 3), "{edges}");
        assert_eq!(found[0].place.as_deref(), Some("mean on the edge `right`, extrapolated"));
        let inside = "mean of the points of `right`, half a spacing inside";
        assert_eq!(found[2].place.as_deref(), Some(inside));
    }
}

#[test]
fn the_bending_stress_of_an_edge_is_that_of_the_outermost_fibre() {
    let asked = json!([
        { "field": "uy", "at": { "edge": "right" } },
        { "field": "energy_density", "at": { "edge": "top" } }
    ]);
    let found = solve(gallery_case("plate/bending_strip.json"), &asked).summary.probes;
    // v = −σ/(E H) (x² + ν (y² − H²/12)) about the middle, whose mean over the end has no second part; 0.11 % is found inside, too.
    let bent = |x: f64| 100.0 / (70000.0 * 21.0) * x * x;
    let middle = 100.0 / (70000.0 * 21.0) / 3.0 * 21.0_f64.powi(2) / 12.0;
    assert_near(-found[0].value, bent(40.5) + middle, 2e-3);
    // σ²/2E on the fibre, 10 % more than half a spacing inside.
    assert_near(found[1].value, 100.0_f64.powi(2) / 140000.0, 0.02);
}

#[test]
fn means_of_linear_fields_are_those_of_a_region_without_the_word() {
    let asked = json!([
        { "field": "stress_xx", "at": { "region": "hole" } },
        { "field": "stress_xx", "at": { "region": "hole" }, "of": "mean" },
        { "field": "stress_xx", "at": { "region": "hole" }, "of": "largest" },
        { "field": "von_mises", "at": { "region": "hole" } },
        { "field": "von_mises", "at": { "region": "hole" }, "of": "mean" }
    ]);
    let mut case = gallery_case("plate/plate_with_hole.json");
    case["body"]["rectangle"]["spacing"] = json!(4);
    let value: Vec<f64> = solve(case, &asked).summary.probes.iter().map(|p| p.value).collect();
    assert_near(value[1], value[0], 1e-14);
    assert!(value[2] > value[1]);
    // Stresses of different directions around a hole cancel in their mean, their von Mises stresses do not.
    assert!(value[4] > 1.05 * value[3], "{} and {}", value[3], value[4]);
}

#[test]
fn extremes_and_integrals_along_members_follow_from_statics() {
    let beam = json!({ "member": "beam" });
    let asked = json!([
        { "field": "M", "of": "largest", "at": beam },
        { "field": "M", "of": "largest_magnitude" },
        { "field": "V", "of": "integral", "at": beam },
        { "field": "V", "of": "mean", "at": beam },
        { "field": "M", "at": { "member": "beam", "x": 0 } },
        { "field": "M", "at": { "member": "beam", "x": 4 } },
        { "field": "N", "of": "smallest", "at": { "member": "right" } }
    ]);
    let solved = solve(gallery_case("frame/portal.json"), &asked);
    let found = &solved.summary.probes;
    assert_eq!(found[0].value, found[4].value);
    assert_eq!((found[0].x, found[0].place.as_deref()), (Some(0.0), Some("member `beam` at x = 0")));
    // The clamped foot, see the case.
    assert_near(found[1].value, 8.301123003294505, 1e-11);
    assert_eq!(found[1].place.as_deref(), Some("member `left` at x = 0"));
    // V = −M′.
    assert_near(found[2].value, found[4].value - found[5].value, 1e-11);
    assert_near(found[3].value, 3.361135316818125, 1e-11);
    assert_eq!((found[2].place.as_deref(), found[2].extent), (Some("member `beam`"), Some(4.0)));
    // The columns balance each other.
    assert_near(found[6].value, -3.361135316818125, 1e-10);
    assert_eq!(solved.probe_unit("2"), Some(""));
}

#[test]
fn both_sides_of_a_jump_count() {
    let force = json!([
        { "field": "V", "of": "largest" }, { "field": "V", "of": "smallest" }, { "field": "M", "of": "integral" }
    ]);
    let mut case = gallery_case("beam/simply_supported_mid_force.json");
    case["loads"] = json!([{ "point": { "at": { "x": 0.5 }, "force": 8.0 } }]);
    let length = case["body"]["line"]["length"].as_f64().unwrap();
    let solved = solve(case, &force);
    let value: Vec<f64> = solved.summary.probes.iter().map(|p| p.value).collect();
    assert_near(value[0], 4.0, 1e-11);
    assert_near(value[1], -4.0, 1e-11);
    // A triangle of −F L/4.
    assert_near(value[2], -8.0 * length * length / 8.0, 1e-11);
    assert_eq!(solved.probe_unit("2"), Some("N m²"));
}

#[test]
fn units_of_integrals_are_those_of_a_field_times_a_volume() {
    let asked = json!([
        { "field": "stress_xx", "of": "integral" }, { "field": "ux", "of": "integral" },
        { "field": "strain_xx", "of": "integral" }, { "field": "stress_xx", "of": "mean" }
    ]);
    let solved = solve(gallery_case("plate/uniaxial_tension.json"), &asked);
    let unit = |name: &str| solved.probe_unit(name).unwrap();
    assert_eq!(["0", "1", "2", "3"].map(unit), ["N mm", "mm⁴", "mm³", "MPa"]);
    assert_eq!(solved.probe_unit("4"), None);
}
