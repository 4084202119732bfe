//! What a program reads from a solved case by name is what the tables of a run say, for all models.

use peristat::input::Folder;
use peristat::results::{Claim, FieldFiles, Results};
use peristat::run::RunOptions;
use peristat::{FieldError, Loaded, Solved};
use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::path::Path;

/// What four fillets fill, over the square of their radius.
const CORNERS: f64 = 4.0 - std::f64::consts::PI;

/// Cases of the gallery and the volumes of their bodies, by hand.
const CASES: [(&str, Option<f64>); 12] = [
    ("plate/uniaxial_tension", Some(40.0 * 20.0 * 2.0)),
    ("plate/scattered_points", Some(40.0 * 20.0 * 2.0)),
    ("plate/state_tension", Some(40.0 * 20.0 * 2.0)),
    ("plate/breaking_plate", Some(24.0 * 24.0)),
    ("ductile/panel", Some(40.0 * 60.0 * 2.0)),
    // The half on one side of the line of symmetry, and a quarter.
    ("axisymmetric/solid_bar", Some(PI * 50.0 * 50.0 * 50.0)),
    ("orthotropic/mirrors", Some(20.0 * 10.0)),
    ("shell/clamped_tube", Some(1.0 * 1.0 * 0.01)),
    ("beam/breaking_cantilever", Some(0.02 * 0.005 * 0.5)),
    // Width and height halve along 2 m: ∫ 0.1 · 0.2 (1 − s/4)² ds.
    ("beam/tapered_rectangle", Some(0.02 * 2.0 * 7.0 / 12.0)),
    // Columns of 4 m and a beam of 8 m, each of two flanges, a web and four fillets (1 − π/4) r².
    (
        "frame/steel_portal",
        Some(
            8.0 * (0.006 + 0.17 * 0.009 + CORNERS * 3.24e-4)
                + 8.0 * (0.3 * 0.0107 + 0.2786 * 0.0071 + CORNERS * 2.25e-4),
        ),
    ),
    // A frame of stiffnesses has no areas.
    ("frame/portal", None),
];

/// Solves a case, and writes its first and last states as a run would.
fn solved(name: &str, folder: &Path) -> Solved {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(format!("{name}.json"));
    let loaded = Loaded::read(&file, &[], None).expect("a case");
    let options = RunOptions { recover: true, max_memory: None, compare: false };
    let solved = loaded.solve(&options).expect("a case that can be solved");
    let claim = Claim::new(folder, true, None).expect("a folder");
    let mut results = Results::begin(&claim, &solved.scene, FieldFiles::default()).expect("a folder");
    let ends = [0, solved.states.len() - 1];
    for k in ends {
        results.take(&solved.scene, &solved.states[k]).expect("a state is written");
    }
    solved
}

/// The columns of a table, without their units.
fn table(file: &Path) -> BTreeMap<String, Vec<f64>> {
    let text = std::fs::read_to_string(file).expect("a table");
    let mut lines = text.lines();
    let names = lines.next().expect("names").split(',').map(|head| head.split(" [").next().unwrap_or(head));
    let mut columns: Vec<(String, Vec<f64>)> = names.map(|name| (name.into(), Vec::new())).collect();
    for line in lines {
        let values = line.split(',').map(|value| value.parse().expect("a number"));
        columns.iter_mut().zip(values).for_each(|((_, column), value)| column.push(value));
    }
    columns.into_iter().collect()
}

#[test]
fn fields_by_name_are_the_columns_of_the_tables() {
    for (name, volume) in CASES {
        let folder = tempfile::tempdir().expect("a folder");
        let solved = solved(name, folder.path());
        let points = solved.points();
        for (k, state) in solved.states.iter().enumerate() {
            assert_eq!((state.record().index, &state.record().name), (k, &solved.summary.states[k].name));
            if k != 0 && k + 1 != solved.states.len() {
                continue;
            }
            let table = table(&folder.path().join(format!("fields/step_{k:03}.csv")));
            let fields = solved.fields(k).expect("a state");
            for field in &fields {
                assert_eq!(solved.field(k, field).expect("a field")[..], table[*field], "{name} {k} {field}");
            }
            // Beside places and the values to the left of points a table has nothing else.
            let places = ["x", "y", "member", "s"];
            let others = |column: &String| !places.contains(&&column[..]) && !column.ends_with("_left");
            assert_eq!(table.keys().filter(|column| others(column)).count(), fields.len(), "{name}");
            assert!(points.iter().map(|p| p[0]).eq(table["x"].iter().copied()), "{name}");
            if let Some(y) = table.get("y") {
                assert!(points.iter().map(|p| p[1]).eq(y.iter().copied()), "{name}");
            }
        }
        assert_eq!(solved.states.len(), solved.summary.states.len(), "{name}");
        let volumes = solved.volumes();
        assert_eq!(volumes.is_some(), volume.is_some(), "{name}");
        if let (Some(volumes), Some(volume)) = (volumes, volume) {
            assert_eq!(volumes.len(), points.len(), "{name}");
            // Measured: 1e-15.
            let sum: f64 = volumes.iter().sum();
            assert!((sum / volume - 1.0).abs() < 1e-13, "{name}: {sum} for {volume}");
        }
    }
}

#[test]
fn a_field_that_is_not_there_is_refused_with_those_that_are() {
    let folder = tempfile::tempdir().expect("a folder");
    let solved = solved("plate/uniaxial_tension", folder.path());
    let known = solved.fields(0).expect("a state");
    assert_eq!(known[..4], ["ux", "uy", "strain_xx", "strain_yy"]);
    for name in ["sigma", "M", "phi", ""] {
        let refusal = FieldError::Field { name: name.into(), known: known.clone() };
        assert_eq!(solved.field(0, name), Err(refusal));
    }
    assert_eq!(solved.field(1, "ux"), Err(FieldError::State { state: 1, states: 1 }));
    assert_eq!(solved.fields(1), Err(FieldError::State { state: 1, states: 1 }));
    // Plane stress: zero by nature, and in no table.
    assert!(!known.contains(&"stress_zz"));
    assert!(solved.field(0, "stress_zz").expect("zeros").iter().all(|&value| value == 0.0));
}

#[test]
fn fields_that_a_run_did_not_recover_are_refused() {
    let case = r#"{ "title": "A bar", "model": { "bond_plane": { "youngs_modulus": 1, "state": "plane_stress" } },
        "body": { "rectangle": { "size": [8, 8], "spacing": 1 } },
        "supports": [ { "at": { "region": "left" }, "ux": 0, "uy": 0 } ],
        "loads": [ { "traction": { "edge": "right", "uniform": [1, 0] } } ] }"#;
    let source = peristat::case::from_text("case", case.into(), &[], &Folder::default()).expect("a case");
    let loaded = Loaded::from_source(source, Path::new(".").into(), None).expect("a case");
    let solved = loaded.solve(&RunOptions::default()).expect("a case that can be solved");
    let refusal = solved.field(0, "von_mises").expect_err("nothing was recovered");
    assert_eq!(refusal, FieldError::Field { name: "von_mises".into(), known: vec!["ux", "uy"] });
    assert_eq!(refusal.to_string(), "there is no field `von_mises`; there are ux, uy");
}
