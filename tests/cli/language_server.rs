//! The schema in an editor: what the JSON language service of VS Code marks and offers. `PERISTAT_LANGUAGE_SERVICE` names the
//! `node_modules` that it lies in; without it nothing is tested.

use super::support::{files, notice, root, run};
use serde_json::{Value, json};
use std::env;
use std::fs;
use std::io::Write;
use std::process::{Command, Stdio};

/// What the service says of texts, by their names; nothing where there is no service.
fn answers(texts: &Value) -> Option<Vec<Value>> {
    let Some(modules) = env::var_os("PERISTAT_LANGUAGE_SERVICE") else {
        notice(
            "no language service; PERISTAT_LANGUAGE_SERVICE names a `node_modules` with vscode-json-languageservice",
        );
        return None;
    };
    let folder = tempfile::tempdir().unwrap();
    let schema = folder.path().join("case.schema.json");
    fs::write(&schema, run(&root(), &["schema"]).stdout).unwrap();
    let mut child = Command::new("node")
        .arg(root().join("tests/cli/language_server.mjs"))
        .args([modules.as_os_str(), schema.as_os_str()])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("node starts");
    child.stdin.take().unwrap().write_all(texts.to_string().as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success());
    serde_json::from_slice(&output.stdout).unwrap()
}

/// A case with a model and a probe of a field.
fn case(model: &str, field: &str) -> String {
    format!(
        r#"{{
  // A comment, and a comma too many.
  "title": "a",
  "model": {{ {model} }},
  "body": {{ "rectangle": {{ "size": [4, 4], "spacing": 1 }} }},
  "probes": [ {{ "name": "p", "at": {{ "x": 1, "y": 1 }}, "field": "{field}" }} ],
}}"#
    )
}

const PLANE: &str = r#""bond_plane": { "youngs_modulus": 1, "state": "plane_stress" }"#;
const BEAM: &str =
    r#""timoshenko_beam": { "stiffness": { "bending": { "uniform": 1 }, "shear": { "uniform": 1 } } }"#;

#[test]
fn faults_are_marked_where_they_stand() {
    let faults = [
        ("none", case(PLANE, "ux"), None),
        ("negative modulus", case(&PLANE.replace(": 1,", ": -1,"), "ux"), Some(("-1", "below"))),
        (
            "missing key",
            case(&PLANE.replace(r#", "state": "plane_stress""#, ""), "ux"),
            Some(("\"bond_plane\"", "\"state\"")),
        ),
        ("unknown key", case(&PLANE.replace("state", "stage"), "ux"), Some(("\"stage\"", "stage"))),
        ("field of beams", case(PLANE, "M"), Some(("\"M\"", "\"stress_xx\""))),
        ("field of plates", case(BEAM, "stress_xx"), Some(("\"stress_xx\"", "\"stress_top\""))),
        ("no field", case(BEAM, "bend"), Some(("\"bend\"", "\"M\""))),
    ];
    let texts: Value = faults.iter().map(|(name, text, _)| json!({ "name": name, "text": text })).collect();
    let Some(answers) = answers(&texts) else { return };
    for (answer, (name, _, expected)) in answers.iter().zip(&faults) {
        let marks = answer["marks"].as_array().unwrap();
        assert_eq!(marks.is_empty(), expected.is_none(), "{name}: {marks:?}");
        if let Some((at, said)) = expected {
            let is_it = |mark: &&Value| mark["at"] == *at && mark["message"].as_str().unwrap().contains(said);
            assert!(marks.iter().any(|mark| is_it(&mark)), "{name}: {marks:?}");
        }
    }
}

#[test]
fn the_cases_of_the_gallery_have_no_marks() {
    let folders =
        ["antiplane", "axisymmetric", "beam", "frame", "orthotropic", "plate", "shell", "solid", "ductile"];
    let cases = folders.iter().flat_map(|folder| files(&root().join("cases").join(folder), ".json"));
    let text = |case: std::path::PathBuf| json!({ "name": case, "text": fs::read_to_string(&case).unwrap() });
    let texts: Vec<Value> =
        cases.map(text).filter(|case| case["text"].as_str().unwrap().contains("\"model\"")).collect();
    let Some(answers) = answers(&texts.into()) else { return };
    assert!(answers.len() > 150);
    for answer in answers {
        assert_eq!(answer["marks"], json!([]), "{}", answer["name"]);
    }
}

#[test]
fn starting_cases_keys_and_fields_of_the_model_are_offered() {
    let texts = json!([
        { "name": "empty", "text": "¦" },
        { "name": "model", "text": r#"{ "title": "a", "model": { ¦ } }"# },
        { "name": "plane", "text": case(PLANE, "¦") },
        { "name": "beam", "text": case(BEAM, "¦") },
    ]);
    let Some(answers) = answers(&texts) else { return };
    let labels = |k: usize| -> Vec<&str> {
        let offers = answers[k]["offers"].as_array().unwrap();
        offers.iter().map(|offer| offer["label"].as_str().unwrap().trim_matches('"')).collect()
    };
    for model in ["timoshenko_beam", "plane_frame", "bond_plane", "state_solid"] {
        let offers = answers[0]["offers"].as_array().unwrap();
        let snippet = offers
            .iter()
            .find(|offer| offer["label"] == model)
            .unwrap_or_else(|| panic!("{model}: {offers:?}"));
        let text = snippet["text"].as_str().unwrap();
        assert!(text.contains("\"title\"") && text.contains("\"probes\""), "{text}");
    }
    assert!(labels(1).contains(&"bond_plane") && labels(1).contains(&"timoshenko_beam"), "{:?}", labels(1));
    let (plane, beam) = (labels(2), labels(3));
    assert!(plane.contains(&"stress_xx") && !plane.contains(&"M") && !plane.contains(&"uz"), "{plane:?}");
    assert!(beam.contains(&"M") && !beam.contains(&"stress_xx"), "{beam:?}");
}
