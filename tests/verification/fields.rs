//! Every field asked of every model: a probe at a point and in a region, a line and a check get a finite number, or the case
//! is refused with the list of the fields that there are.

use crate::support::plane;
use peristat::case::FieldName;
use serde_json::{Value, json};

/// All names of fields in case files.
fn names() -> Vec<String> {
    let schema = serde_json::to_value(schemars::schema_for!(FieldName)).expect("a schema");
    let values = schema["oneOf"].as_array().expect("a list of names");
    let names: Vec<String> = values.iter().map(|v| v["const"].as_str().expect("a name").into()).collect();
    assert_eq!(names.len(), 75);
    names
}

/// A body of a model, held at its left side and pulled at its right one.
struct Model {
    case: Value,
    /// A point, and a region that supports hold.
    places: Vec<Value>,
    /// The fields that probes get.
    answered: Vec<&'static str>,
    /// Those of them that no table shows.
    hidden: Vec<&'static str>,
}

impl Model {
    /// Where a field is asked for: what is along a line at a point of it, what is at its ends at one of these.
    fn places_of(&self, name: &str) -> Vec<Value> {
        match name {
            _ if !self.answered.contains(&name) => self.places.clone(),
            "reaction_per_length" | "reaction_moment_per_length" => self.places[..1].to_vec(),
            "corner_force" => vec![json!({ "x": 0, "y": 0 })],
            _ => self.places.clone(),
        }
    }
}

const STRESSES: [&str; 9] = [
    "strain_xx",
    "strain_yy",
    "strain_xy",
    "stress_xx",
    "stress_yy",
    "stress_xy",
    "stress_zz",
    "von_mises",
    "energy_density",
];

/// Fields that are found on demand; solids do not have the last one.
const ON_DEMAND: [&str; 6] = [
    "principal_stress_1",
    "principal_stress_2",
    "principal_stress_3",
    "max_shear",
    "hydrostatic",
    "principal_direction",
];

/// Fields of a material with fibres and strengths.
const OF_FIBRES: [&str; 11] = [
    "stress_11",
    "stress_22",
    "stress_12",
    "strain_11",
    "strain_22",
    "strain_12",
    "tsai_hill",
    "tsai_wu",
    "hashin_fibre",
    "hashin_matrix",
    "utilisation",
];

const TURNS: [&str; 3] = ["phi_x", "phi_y", "phi_z"];

fn body(name: &str, model: Value, others: &[&'static str], hidden: &[&'static str]) -> Model {
    let case = json!({
        "title": name, "units": "mm-N-MPa", "model": { name: model },
        "body": { "rectangle": { "size": [10, 6], "spacing": 1 } },
        "supports": [ { "at": { "region": "left" }, "ux": 0, "uy": 0 } ],
        "loads": [ { "traction": { "edge": "right", "uniform": [10, 0] } } ]
    });
    let places = vec![json!({ "x": 0.5, "y": 2.5 }), json!({ "region": "left" })];
    let answered = ["ux", "uy", "damage", "reaction_x", "reaction_y"];
    let answered = answered.iter().chain(&STRESSES).chain(&ON_DEMAND).chain(others).copied().collect();
    Model { case, places, answered, hidden: [hidden, &ON_DEMAND].concat() }
}

fn models() -> Vec<Model> {
    let isotropic = |state: &str| json!({ "youngs_modulus": 7e4, "poisson_ratio": 0.3, "state": state });
    let central = |state: &str| json!({ "youngs_modulus": 7e4, "state": state });
    let flat = ["stress_zz", "damage"];
    let mut turning = body(
        "beam_bond_orthotropic",
        json!({ "youngs_modulus_1": 9e4, "youngs_modulus_2": 6e4, "poisson_ratio_12": 0.3,
                "shear_modulus_12": 2.5e4, "fibre_angle": 0 }),
        &["phi", "reaction_moment"],
        &flat,
    );
    turning.case["supports"][0]["phi"] = json!(0);
    turning.case["strengths"] = json!({ "fibre_tension": 1500, "fibre_compression": 900, "matrix_tension": 40,
        "matrix_compression": 200, "shear": 70 });
    turning.answered.extend(OF_FIBRES);
    turning.hidden.extend(OF_FIBRES);
    let mut ring =
        body("axisymmetric", json!({ "youngs_modulus": 7e4, "poisson_ratio": 0.3 }), &[], &["damage"]);
    ring.case["body"]["rectangle"]["from"] = json!([4, 0]);
    ring.case["strengths"] = json!({ "yield_stress": 240 });
    ring.answered.push("utilisation");
    ring.hidden.push("utilisation");
    ring.places[0] = json!({ "x": 4.5, "y": 2.5 });
    let mut shell = body(
        "shell_membrane",
        json!({ "youngs_modulus": 7e4, "radius": 40, "thickness": 1 }),
        &["w", "reaction_force"],
        &flat,
    );
    shell.case["supports"][0]["w"] = json!(0);
    let mut rigid = body("state_plane", isotropic("plane_strain"), &["phi"], &["damage", "phi"]);
    rigid.case["regions"] = json!({ "pin": { "box": { "from": [0, 0], "to": [2, 6] } } });
    rigid.case["rigid"] = json!([ { "region": "pin", "ux": 0, "uy": 0, "phi": 0 } ]);
    rigid.case["supports"] = json!([]);
    rigid.places = vec![json!({ "region": "pin" })];
    let mut all = vec![
        body("bond_plane", central("plane_stress"), &[], &flat),
        body("bond_plane", central("plane_strain"), &[], &["damage"]),
        body("state_plane", isotropic("plane_stress"), &[], &flat),
        body("state_plane", isotropic("plane_strain"), &[], &["damage"]),
        turning,
        ring,
        shell,
        rigid,
    ];
    all.extend(["bond_solid", "state_solid"].map(solid));
    let mut rigid = solid("bond_solid");
    rigid.case["rigid"] =
        json!([ { "region": "left", "ux": 0, "uy": 0, "uz": 0, "phi_x": 0, "phi_y": 0, "phi_z": 0 } ]);
    rigid.case["supports"] = json!([]);
    rigid.places = vec![json!({ "region": "left" })];
    rigid.answered.extend(TURNS);
    rigid.answered.extend(["reaction_moment_x", "reaction_moment_y", "reaction_moment_z"]);
    rigid.hidden.extend(TURNS);
    all.push(rigid);
    all.push(plate());
    all.extend(beams());
    all
}

/// A plate in bending, clamped at its left side.
fn plate() -> Model {
    let case = json!({
        "title": "plate_bending", "units": "mm-N-MPa",
        "model": { "plate_bending": { "youngs_modulus": 7e4, "poisson_ratio": 0.3, "thickness": 0.5 } },
        "body": { "rectangle": { "size": [10, 6], "spacing": 1 } },
        "supports": [ { "at": { "region": "left" }, "w": 0, "phi_n": 0, "phi_t": 0 } ],
        "loads": [ { "pressure": { "value": 1e-3 } } ]
    });
    let reactions = ["reaction_force", "reaction_moment_x", "reaction_moment_y"];
    let along_lines = ["reaction_per_length", "reaction_moment_per_length", "corner_force"];
    let fields = FieldName::PLATE.iter().map(|field| field.name());
    let answered = fields.chain(reactions).chain(along_lines).collect();
    let places = vec![json!({ "x": 0, "y": 2 }), json!({ "region": "left" })];
    Model { case, places, answered, hidden: vec!["damage"] }
}

fn solid(name: &str) -> Model {
    let mut model = json!({ "youngs_modulus": 7e4 });
    if name == "state_solid" {
        model["poisson_ratio"] = json!(0.3);
    }
    let case = json!({
        "title": name, "units": "mm-N-MPa", "model": { name: model },
        "body": { "block": { "size": [6, 4, 4], "spacing": 1 } },
        "supports": [ { "at": { "region": "left" }, "ux": 0, "uy": 0, "uz": 0 } ],
        "loads": [ { "traction": { "face": "right", "uniform": [10, 0, 0] } } ]
    });
    let places = vec![json!({ "x": 0.5, "y": 2.5, "z": 1.5 }), json!({ "region": "left" })];
    let others = ["ux", "uy", "uz", "damage", "reaction_x", "reaction_y", "reaction_z"];
    let across = ["strain_zz", "strain_xz", "strain_yz", "stress_xz", "stress_yz"];
    let on_demand = &ON_DEMAND[..5];
    let answered = STRESSES.iter().chain(&others).chain(&across).chain(on_demand).copied().collect();
    Model { case, places, answered, hidden: [&["damage"], on_demand].concat() }
}

fn beams() -> [Model; 3] {
    let model = json!({ "timoshenko_beam": { "youngs_modulus": 2e11, "poisson_ratio": 0.3,
        "section": { "rectangle": { "width": 0.05, "height": 0.05 } } } });
    let line = json!({
        "title": "beam", "model": model, "horizon_ratio": 3, "body": { "line": { "length": 1, "cells": 8 } },
        "supports": [ { "at": { "x": 0 }, "w": 0, "phi": 0 } ],
        "loads": [ { "point": { "at": { "x": 1 }, "force": 1000 } } ]
    });
    let mut stretched = line.clone();
    stretched["supports"][0]["ux"] = json!(0);
    let frame = json!({
        "title": "frame", "model": model, "horizon_ratio": 3,
        "body": { "frame": { "joints": [ { "name": "a", "x": 0, "y": 0 }, { "name": "b", "x": 1, "y": 0 } ],
            "members": [ { "name": "m", "from": "a", "to": "b", "cells": 8 } ] } },
        "supports": [ { "at": { "joint": "a" }, "ux": 0, "uy": 0, "phi": 0 } ],
        "loads": [ { "point": { "at": { "joint": "b" }, "force_x": 5, "force_y": 7 } } ]
    });
    let bending = ["w", "phi", "M", "V", "stress_top", "stress_bottom", "energy_density", "reaction_moment"];
    let with = |others: &[&'static str]| bending.iter().chain(others).copied().collect();
    let of = |case, at: Value, answered| Model { case, places: vec![at], answered, hidden: Vec::new() };
    [
        of(line, json!({ "x": 0 }), with(&["reaction_force"])),
        of(stretched, json!({ "x": 0 }), with(&["u", "N", "reaction_force", "reaction_x"])),
        of(frame, json!({ "joint": "a" }), with(&["ux", "uy", "u", "N", "reaction_x", "reaction_y"])),
    ]
}

/// The refusal of a case, or the value of its probe.
fn ask(case: &Value) -> Result<Option<f64>, String> {
    let solved = peristat::solve_text(&format!("{case:#}")).map_err(|error| format!("{error:?} {error}"))?;
    Ok(solved.summary.probes.first().map(|p| p.value))
}

/// Whether a refusal is that of a field, with all that there are.
fn lists(refusal: &str, model: &Model) -> bool {
    refusal.contains("there are") && model.answered.iter().all(|name| refusal.contains(name))
}

#[test]
fn every_field_of_every_model_is_a_number_or_refused_with_those_that_there_are() {
    for model in models() {
        for name in names() {
            for place in model.places_of(&name) {
                let mut case = model.case.clone();
                case["probes"] = json!([ { "name": "p", "at": place, "field": name } ]);
                let told = format!("{name} at {place} of {}", case["title"]);
                match (ask(&case), model.answered.contains(&name.as_str())) {
                    (Ok(Some(value)), true) => assert!(value.is_finite(), "{told}: {value}"),
                    (Err(refusal), false) => {
                        assert!(lists(&refusal, &model), "{told}: {refusal}");
                        assert!(refusal.contains("probes[0].field"), "{told}: {refusal}");
                    }
                    (other, _) => panic!("{told}: {other:?}"),
                }
            }
        }
    }
}

#[test]
fn every_field_of_every_model_can_be_checked_at_all_points_or_is_refused_with_those_that_there_are() {
    for model in models() {
        let of_points = |name: &str| {
            let of_regions = name.starts_with("reaction")
                || name == "corner_force"
                || name.starts_with("phi") && model.hidden.contains(&name);
            model.answered.contains(&name) && !of_regions
        };
        for name in names() {
            let told = format!("{name} of {}", model.case["title"]);
            let mut case = model.case.clone();
            case["checks"] =
                json!([ { "baseline": { "file": "nowhere.csv", "field": name, "tolerance": 1 } } ]);
            let refusal = ask(&case).expect_err("there is no such file");
            assert_eq!(refusal.contains("checks[0].baseline.field"), !of_points(&name), "{told}: {refusal}");
            assert_eq!(refusal.contains("there are"), !of_points(&name), "{told}: {refusal}");
            if model.case["model"].get("timoshenko_beam").is_some() || !of_points(&name) {
                continue;
            }
            let check = json!({ "field": name, "is": "1", "tolerance": 1, "source": "none" });
            case["checks"] = json!([ { "formula": check } ]);
            let solved = peristat::solve_text(&format!("{case:#}")).unwrap_or_else(|e| panic!("{told}: {e}"));
            let found = &solved.summary.checks[0];
            assert!(found.found.is_finite() && found.error.is_finite(), "{told}: {found:?}");
        }
    }
}

#[test]
fn every_field_that_tables_show_is_a_number_along_lines() {
    let is_body = |m: &Model| {
        ["timoshenko_beam", "plate_bending"].iter().all(|name| m.case["model"].get(*name).is_none())
    };
    for model in models().into_iter().filter(is_body) {
        let mut case = model.case.clone();
        let from = if model.case["title"] == "axisymmetric" { 4.1 } else { 0.1 };
        let is_solid = model.case["body"].get("block").is_some();
        let [from, to] = match is_solid {
            true => [json!([0.1, 2.2, 1.3]), json!([5.9, 2.2, 1.3])],
            false => [json!([from, 2.2]), json!([9.9, 2.2])],
        };
        case["lines"] = json!([ { "name": "l", "from": from, "to": to, "points": 7 } ]);
        let run = plane::solve(&case);
        let (scene, state) = (&run.scene, &run.states[0]);
        let shown: Vec<FieldName> = state.fields().collect();
        let expected = |name: &&&str| !name.starts_with("reaction") && !model.hidden.contains(*name);
        let mut names: Vec<&str> = shown.iter().map(|f| f.name()).collect();
        let mut wanted: Vec<&str> = model.answered.iter().filter(expected).copied().collect();
        names.sort_unstable();
        wanted.sort_unstable();
        assert_eq!(names, wanted, "{}", case["title"]);
        for point in &scene.lines[0].points {
            let weights = point.weights.as_ref().expect("the line is inside");
            for &field in &shown {
                let value = state.value(scene, field, weights).expect("a field that is shown");
                assert!(value.is_finite(), "{} of {}", field.name(), case["title"]);
            }
        }
    }
}

/// A square in plane strain whose boundary moves with one strain.
fn strained(model: Value) -> Value {
    json!({
        "title": "strained", "units": "mm-N-MPa", "model": model,
        "body": { "rectangle": { "size": [8, 8], "spacing": 1 } },
        "supports": [ { "at": { "x": 0.5, "y": 0.5 }, "ux": 0, "uy": 0 }, { "at": { "x": 7.5, "y": 0.5 }, "uy": 0 } ],
        "loads": [ { "traction": { "edge": "left", "uniform": [-30, 0] } },
            { "traction": { "edge": "right", "uniform": [30, 0] } },
            { "traction": { "edge": "top", "uniform": [0, 10] } },
            { "traction": { "edge": "bottom", "uniform": [0, -10] } } ],
        "probes": [ { "name": "zz", "at": { "x": 3.5, "y": 2.5 }, "field": "stress_zz" },
            { "name": "mean", "at": { "region": "top" }, "field": "stress_zz" } ]
    })
}

#[test]
fn the_stress_across_the_plane_is_that_of_its_state() {
    let family = |state: &str| json!({ "state_plane": { "youngs_modulus": 1e4, "poisson_ratio": 0.2, "state": state } });
    let central = |state: &str| json!({ "bond_plane": { "youngs_modulus": 1e4, "state": state } });
    // ν (σ_xx + σ_yy) with σ_xx + σ_yy = 40, and ν = 1/4 of central bonds; 2e-14 is found.
    for (model, expected) in [
        (family("plane_strain"), 8.0),
        (central("plane_strain"), 10.0),
        (family("plane_stress"), 0.0),
        (central("plane_stress"), 0.0),
    ] {
        let solved = peristat::solve_text(&strained(model).to_string()).expect("a case that can be solved");
        for probe in &solved.summary.probes {
            assert!((probe.value - expected).abs() < 1e-12, "{}: {}", probe.name, probe.value);
        }
    }
}

#[test]
fn damage_is_zero_where_nothing_breaks() {
    let mut case = strained(json!({ "bond_plane": { "youngs_modulus": 1e4, "state": "plane_stress" } }));
    case["probes"] = json!([ { "name": "d", "at": { "x": 0.5, "y": 0.5 }, "field": "damage" } ]);
    case["checks"] = json!([ { "limit": { "probe": "d", "at_most": 0.1, "why": "whole" } } ]);
    let summary = peristat::solve_text(&case.to_string()).expect("a case that can be solved").summary;
    assert_eq!(summary.probes[0].value, 0.0);
    assert!(summary.checks[0].passed);
}

#[test]
fn the_opening_is_that_of_a_crack() {
    let mut case = strained(json!({ "bond_plane": { "youngs_modulus": 1e4, "state": "plane_stress" } }));
    case["probes"] = json!([ { "name": "o", "at": { "x": 4, "y": 6 }, "field": "opening" } ]);
    let refusal = ask(&case).expect_err("there is no crack");
    assert!(refusal.contains("probes[0].field") && refusal.contains("there are ux"), "{refusal}");
    case["cracks"] = json!([ { "name": "c", "path": [[4, 8], [4, 5]] } ]);
    assert!(ask(&case).expect("a case that can be solved").expect("a value") > 0.0);
    // With a crack it is among the fields that there are.
    case["probes"][0]["field"] = json!("M");
    assert!(ask(&case).expect_err("a plate has no moment").contains("opening"));
}
