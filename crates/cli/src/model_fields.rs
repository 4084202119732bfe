//! Fields by model in the schema of cases: an editor offers those that the model of the case has, and marks others.

use peristat::case::{self, FieldName};
use peristat::input::Folder;
use peristat::model::{self, Entry};
use peristat::{Error, Loaded};
use schemars::Schema;
use serde_json::{Map, Value, json};

/// Where cases name fields: lists, and objects in their elements.
const PLACES: [(&str, &[&str]); 2] = [("probes", &[]), ("checks", &["baseline", "formula"])];
/// The types of these elements.
const TYPES: [&str; 3] = ["Probe", "Baseline", "Formula"];

/// Makes `field` depend on the model.
///
/// # Errors
/// A starting case is at fault.
pub(super) fn add(schema: &mut Schema) -> Result<(), Error> {
    let names = names(schema);
    let mut rules = vec![json!({ "if": chosen(None), "else": fields("FieldName") })];
    for entry in model::TABLE {
        let known = of_model(entry)?;
        let index = |field: &FieldName| names.iter().position(|name| name == field.name());
        let options: Vec<Value> = known
            .iter()
            .filter_map(index)
            .map(|k| json!({ "$ref": format!("#/$defs/FieldName/oneOf/{k}") }))
            .collect();
        let definition = format!("{}_fields", entry.name);
        rules.push(json!({ "if": chosen(Some(entry.name)), "then": fields(&definition) }));
        if let Some(all) = definitions(schema) {
            all.insert(definition, json!({ "oneOf": options }));
        }
    }
    for name in TYPES {
        let of_type = definitions(schema).and_then(|all| all.get_mut(name)?.pointer_mut("/properties/field"));
        if let Some(Value::Object(field)) = of_type {
            field.remove("$ref");
            field.insert("type".into(), "string".into());
        }
    }
    schema.insert("allOf".into(), rules.into());
    Ok(())
}

fn definitions(schema: &mut Schema) -> Option<&mut Map<String, Value>> {
    schema.get_mut("$defs")?.as_object_mut()
}

/// All fields, in the order of the schema.
fn names(schema: &Schema) -> Vec<String> {
    let variants = schema.pointer("/$defs/FieldName/oneOf").and_then(Value::as_array);
    let name = |variant: &Value| variant["const"].as_str().unwrap_or_default().to_string();
    variants.into_iter().flatten().map(name).collect()
}

/// The fields of a model: its starting cases know them.
fn of_model(entry: &Entry) -> Result<Vec<FieldName>, Error> {
    let mut all = Vec::new();
    for start in entry.starts {
        let source = case::from_text(start.name, start.case.into(), &[], &Folder::default())?;
        let known = Loaded::from_source(source, Folder::default(), None)?.scene.askable();
        all.extend(known.into_iter().filter(|field| !all.contains(field)).collect::<Vec<_>>());
    }
    Ok(all)
}

/// The condition that a case has this model, or any.
fn chosen(model: Option<&str>) -> Value {
    let of_model = match model {
        Some(name) => json!({ "type": "object", "required": [name] }),
        None => json!({ "type": "object", "minProperties": 1 }),
    };
    json!({ "type": "object", "properties": { "model": of_model }, "required": ["model"] })
}

/// A case whose fields are as defined.
fn fields(definition: &str) -> Value {
    let field = json!({ "properties": { "field": { "$ref": format!("#/$defs/{definition}") } } });
    let of_place = |(list, inside): &(&str, &[&str])| {
        let named = inside.iter().map(|name| ((*name).to_string(), field.clone()));
        let items = if inside.is_empty() {
            field.clone()
        } else {
            json!({ "properties": named.collect::<Map<_, _>>() })
        };
        ((*list).to_string(), json!({ "items": items }))
    };
    json!({ "properties": PLACES.iter().map(of_place).collect::<Map<_, _>>() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::schema;
    use peristat::case::Case;

    #[test]
    fn every_model_has_fields_of_its_own_and_every_field_a_model() {
        let mut schema = schema::of::<Case>();
        let all = names(&schema);
        add(&mut schema).unwrap();
        let text = schema.as_value().to_string();
        assert!(
            !text.contains("\"#/$defs/FieldName\"}") || text.matches("\"#/$defs/FieldName\"}").count() == 3
        );
        let mut used = vec![false; all.len()];
        for entry in model::TABLE {
            let definition = schema.pointer(&format!("/$defs/{}_fields/oneOf", entry.name)).unwrap();
            let options = definition.as_array().unwrap();
            assert!((5..all.len()).contains(&options.len()), "{}: {}", entry.name, options.len());
            for option in options {
                let pointer = option["$ref"].as_str().unwrap().trim_start_matches('#');
                let name = schema.pointer(pointer).unwrap()["const"].as_str().unwrap();
                used[all.iter().position(|n| n == name).unwrap()] = true;
            }
        }
        let unused: Vec<_> = all.iter().zip(used).filter(|(_, used)| !used).collect();
        assert!(unused.is_empty(), "{unused:?}");
    }
}
