//! The JSON Schema of cases, by a checker of the keywords that it uses.

use super::support::{files, json, root, run};
use serde_json::{Map, Value};

fn schema() -> Value {
    let outcome = run(&root(), &["schema"]);
    assert_eq!(outcome.code, 0);
    serde_json::from_str(&outcome.stdout).unwrap()
}

/// Keywords that only describe.
const SILENT: [&str; 12] = [
    "$schema",
    "$defs",
    "title",
    "description",
    "markdownDescription",
    "default",
    "format",
    "examples",
    "deprecated",
    "allowComments",
    "allowTrailingCommas",
    "defaultSnippets",
];

/// Faults of a value against a schema; a keyword that this does not know is a fault too.
fn faults(root: &Value, schema: &Value, value: &Value, path: &str) -> Vec<String> {
    let Some(schema) = schema.as_object() else {
        return if schema == &Value::Bool(false) {
            vec![format!("{path} is not allowed")]
        } else {
            Vec::new()
        };
    };
    let keywords = schema.iter().filter(|(k, _)| !SILENT.contains(&k.as_str()));
    keywords.flat_map(|(keyword, rule)| keyword_faults(root, schema, keyword, rule, value, path)).collect()
}

fn keyword_faults(
    root: &Value,
    schema: &Map<String, Value>,
    keyword: &str,
    rule: &Value,
    value: &Value,
    path: &str,
) -> Vec<String> {
    let none = Vec::new();
    let fault = |bad: bool, what: String| if bad { vec![format!("{path} {what}")] } else { Vec::new() };
    let matching = || {
        let options = rule.as_array().unwrap_or(&none);
        options.iter().filter(|s| faults(root, s, value, path).is_empty()).count()
    };
    match keyword {
        "$ref" => {
            let pointer = rule.as_str().unwrap().trim_start_matches('#');
            faults(root, root.pointer(pointer).expect("a reference points into the schema"), value, path)
        }
        "type" => {
            let single = std::slice::from_ref(rule);
            let types = rule.as_array().map_or(single, Vec::as_slice);
            fault(!types.iter().any(|t| is(value, t.as_str().unwrap())), format!("is not {rule}"))
        }
        "enum" => fault(!rule.as_array().unwrap().contains(value), format!("is none of {rule}")),
        "const" => fault(rule != value, format!("is not {rule}")),
        "oneOf" => fault(matching() != 1, format!("fits {} alternatives", matching())),
        "allOf" => {
            rule.as_array().unwrap_or(&none).iter().flat_map(|s| faults(root, s, value, path)).collect()
        }
        "if" => {
            let holds = faults(root, rule, value, path).is_empty();
            let then = schema.get(if holds { "then" } else { "else" });
            then.map_or_else(Vec::new, |then| faults(root, then, value, path))
        }
        "then" | "else" => Vec::new(),
        "minProperties" => {
            let count = value.as_object().map_or(u64::MAX, |keys| keys.len() as u64);
            fault(count < rule.as_u64().unwrap(), "has too few keys".into())
        }
        "anyOf" => fault(matching() == 0, "fits no alternative".into()),
        "required" => {
            let missing = |k: &&Value| value.is_object() && value.get(k.as_str().unwrap()).is_none();
            rule.as_array().unwrap().iter().filter(missing).map(|k| format!("{path} misses {k}")).collect()
        }
        "properties" | "additionalProperties" => {
            let empty = Map::new();
            let known = schema.get("properties").and_then(Value::as_object).unwrap_or(&empty);
            let mut all = Vec::new();
            for (key, value) in value.as_object().unwrap_or(&empty) {
                let at = format!("{path}.{key}");
                match (keyword, known.get(key)) {
                    ("properties", Some(inner)) => all.extend(faults(root, inner, value, &at)),
                    ("additionalProperties", None) => all.extend(faults(root, rule, value, &at)),
                    _ => {}
                }
            }
            all
        }
        "items" => {
            let values = value.as_array().unwrap_or(&none);
            values
                .iter()
                .enumerate()
                .flat_map(|(k, v)| faults(root, rule, v, &format!("{path}[{k}]")))
                .collect()
        }
        "minItems" => fault(
            value.as_array().is_some_and(|v| (v.len() as u64) < rule.as_u64().unwrap()),
            "is too short".into(),
        ),
        "maxItems" => fault(
            value.as_array().is_some_and(|v| v.len() as u64 > rule.as_u64().unwrap()),
            "is too long".into(),
        ),
        "minimum" => {
            fault(value.as_f64().is_some_and(|v| v < rule.as_f64().unwrap()), format!("is below {rule}"))
        }
        "exclusiveMinimum" => {
            fault(value.as_f64().is_some_and(|v| v <= rule.as_f64().unwrap()), format!("is not above {rule}"))
        }
        "maximum" => {
            fault(value.as_f64().is_some_and(|v| v > rule.as_f64().unwrap()), format!("is above {rule}"))
        }
        other => vec![format!("{path}: the keyword `{other}` is not known to this test")],
    }
}

fn is(value: &Value, name: &str) -> bool {
    match name {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        "integer" => value.is_u64() || value.is_i64(),
        "number" => value.is_number(),
        _ => false,
    }
}

#[test]
fn every_case_of_the_gallery_fits_the_schema() {
    let schema = schema();
    let folders = [
        "antiplane",
        "axisymmetric",
        "beam",
        "bench",
        "ductile",
        "frame",
        "orthotropic",
        "plate",
        "shell",
        "solid",
    ];
    let cases = folders.iter().flat_map(|folder| files(&root().join("cases").join(folder), ".json"));
    let cases: Vec<_> = cases.filter(|case| json(case).get("model").is_some()).collect();
    assert!(cases.len() >= 150, "{}", cases.len());
    for case in cases {
        let found = faults(&schema, &schema, &json(&case), "case");
        assert!(found.is_empty(), "{}: {found:#?}", case.display());
    }
}

#[test]
fn a_case_of_the_wrong_shape_does_not_fit_the_schema() {
    let schema = schema();
    let names = [
        "unknown_key",
        "unknown_section",
        "unknown_bond_law",
        "unknown_units",
        "wrong_type",
        "missing_field",
        "two_sections",
        "fractional_cells",
        "position_is_no_object",
        "not_an_object",
        "negative_modulus",
        "probe_of_unknown_field",
        "orthotropic_rotations",
    ];
    for name in names {
        let case = json(&root().join(format!("cases/invalid/{name}.json")));
        assert!(!faults(&schema, &schema, &case, "case").is_empty(), "{name}");
    }
}

#[test]
fn every_key_of_the_schema_is_described() {
    fn walk(value: &Value, path: &str, bare: &mut Vec<String>) {
        let Some(keys) = value.as_object() else { return };
        if let Some(properties) = keys.get("properties").and_then(Value::as_object) {
            for (key, schema) in properties {
                if schema.get("description").is_none() {
                    bare.push(format!("{path}.{key}"));
                }
            }
        }
        // Rules by model describe no keys of their own.
        for (key, inner) in keys.iter().filter(|(key, _)| *key != "allOf") {
            walk(inner, &format!("{path}.{key}"), bare);
            for (k, inner) in inner.as_array().into_iter().flatten().enumerate() {
                walk(inner, &format!("{path}.{key}[{k}]"), bare);
            }
        }
    }
    let mut bare = Vec::new();
    walk(&schema(), "", &mut bare);
    assert!(bare.is_empty(), "without a description: {bare:#?}");
}
