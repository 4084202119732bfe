//! Everything that a case can say is said by some case of the gallery.

use super::support::{files, gallery, load, root};
use peristat::case::{Case, Check};
use peristat::reference;
use peristat_assembly::model::timoshenko_beam::{bond_law, end_treatment};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;

/// What may be missing: it is for editors.
const SPARED: [&str; 1] = ["Case.$schema"];

/// All keys and named values below a schema, by the name of the type they are in.
fn spots(schema: &Value, name: &str, found: &mut BTreeSet<String>) {
    for (key, inner) in schema["properties"].as_object().into_iter().flatten() {
        found.insert(format!("{name}.{key}"));
        spots(inner, &format!("{name}.{key}"), found);
    }
    for value in schema["enum"].as_array().into_iter().flatten().chain(schema.get("const")) {
        found.insert(format!("{name} {value}"));
    }
    for inner in alternatives(schema).chain(schema.get("items")) {
        spots(inner, name, found);
    }
}

fn alternatives(schema: &Value) -> impl Iterator<Item = &Value> {
    let lists = ["oneOf", "anyOf"].into_iter().filter_map(|key| schema[key].as_array());
    lists.flatten()
}

/// The same of a value that fits the schema.
fn visit(root: &Value, schema: &Value, name: &str, value: &Value, found: &mut BTreeSet<String>) {
    if let Some(reference) = schema["$ref"].as_str() {
        let name = reference.rsplit('/').next().unwrap_or_default();
        visit(root, &root["$defs"][name], name, value, found);
    }
    for (key, inner) in schema["properties"].as_object().into_iter().flatten() {
        if let Some(value) = value.get(key) {
            found.insert(format!("{name}.{key}"));
            visit(root, inner, &format!("{name}.{key}"), value, found);
        }
    }
    let is_table = name == "Rolled";
    let names =
        schema["enum"].as_array().filter(|_| !is_table).into_iter().flatten().chain(schema.get("const"));
    for named in names.filter(|named| *named == value) {
        found.insert(format!("{name} {named}"));
    }
    for inner in alternatives(schema) {
        visit(root, inner, name, value, found);
    }
    for value in value.as_array().into_iter().flatten() {
        visit(root, &schema["items"], name, value, found);
    }
    // Maps such as `regions` hold values by names of the author.
    for value in value.as_object().into_iter().flat_map(|map| map.values()) {
        visit(root, &schema["additionalProperties"], name, value, found);
    }
}

#[test]
fn every_key_and_every_named_value_occurs_in_a_case() {
    let schema = schemars::schema_for!(Case).to_value();
    let mut known = BTreeSet::new();
    spots(&schema, "Case", &mut known);
    // The names of a table are not the words of a case.
    let definitions = schema["$defs"].as_object().unwrap().iter().filter(|(name, _)| *name != "Rolled");
    for (name, definition) in definitions {
        spots(definition, name, &mut known);
    }
    assert!(known.len() > 100, "the schema has only {} spots", known.len());
    let mut used: BTreeSet<String> = SPARED.iter().map(ToString::to_string).collect();
    for case in gallery() {
        // The resolved case: a default that no author writes is used all the same.
        let value = serde_json::to_value(load(&case).scene.case()).unwrap();
        visit(&schema, &schema, "Case", &value, &mut used);
    }
    let missing: Vec<&String> = known.difference(&used).collect();
    assert!(missing.is_empty(), "in no case: {missing:#?}");
    let unknown: Vec<&String> = used.difference(&known).collect();
    assert!(unknown.is_empty(), "in no schema: {unknown:#?}");
}

#[test]
fn every_registered_reference_bond_law_and_end_treatment_has_a_case() {
    let (mut references, mut laws, mut treatments) = (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
    for case in gallery() {
        let Some(scene) = load(&case).scene.into_beam() else { continue };
        laws.insert(scene.beam.parameters().bond_law.name);
        treatments.insert(scene.beam.parameters().end_treatment.name);
        let named = scene.case.checks.into_iter().filter_map(|check| match check {
            Check::ClosedForm(closed_form) => Some(closed_form.name),
            _ => None,
        });
        references.extend(named);
    }
    assert_eq!(references, reference::TABLE.iter().map(|r| r.name.to_string()).collect());
    assert_eq!(laws, bond_law::TABLE.iter().map(|l| l.name).collect());
    assert_eq!(treatments, end_treatment::TABLE.iter().map(|t| t.name).collect());
}

#[test]
fn the_table_of_cases_has_every_case_and_no_other() {
    let text = fs::read_to_string(root().join("cases/README.md")).unwrap();
    let rows = text.lines().filter_map(|line| line.strip_prefix("| `cases/")?.split(".json`").next());
    let rows: Vec<String> = rows.map(ToString::to_string).collect();
    let studies = files(&root().join("cases"), ".study.json");
    let cases = gallery().into_iter().chain(studies).map(|case| {
        let path = case.strip_prefix(root().join("cases")).unwrap().with_extension("");
        path.display().to_string()
    });
    let (listed, cases): (BTreeSet<String>, BTreeSet<String>) =
        (rows.iter().cloned().collect(), cases.collect());
    assert_eq!(listed, cases);
    assert_eq!(listed.len(), rows.len(), "a case has two rows");
}
