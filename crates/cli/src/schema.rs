//! The JSON Schema of cases and of studies, with what editors show beside what they check.

use peristat::model;
use schemars::transform::RecursiveTransform;
use schemars::{JsonSchema, Schema};
use serde_json::{Map, Value, json};

/// The schema of a file. Ranges follow from descriptions, so that neither says what the other does not.
pub(super) fn of<T: JsonSchema>() -> Schema {
    let settings =
        schemars::generate::SchemaSettings::draft2020_12().with_transform(RecursiveTransform(mend));
    let mut schema = settings.into_generator().into_root_schema_for::<T>();
    // Keys that editors know beyond the standard.
    schema.insert("allowComments".into(), true.into());
    schema.insert("allowTrailingCommas".into(), true.into());
    schema
}

/// The cases to begin with, for an editor to offer in an empty file.
pub(super) fn starts() -> Value {
    let snippet = |start: model::Start| {
        let body: Value = serde_json::from_str(start.case).unwrap_or_default();
        json!({ "label": start.name, "description": start.about, "body": body })
    };
    model::starts().map(snippet).collect()
}

/// Asks for no moduli of models: the `material` of a case may give them.
pub(super) fn without_moduli(schema: &mut Schema) {
    let definitions = schema.get_mut("$defs").and_then(Value::as_object_mut);
    for definition in definitions.into_iter().flat_map(Map::values_mut) {
        if let Some(required) = definition.get_mut("required").and_then(Value::as_array_mut) {
            required.retain(|key| {
                !["youngs_modulus", "poisson_ratio", "shear_modulus"].iter().any(|own| key == own)
            });
        }
    }
}

fn mend(schema: &mut Schema) {
    let Some(schema) = schema.as_object_mut() else { return };
    describe_variant(schema);
    if let Some(properties) = schema.get_mut("properties").and_then(Value::as_object_mut) {
        properties.values_mut().filter_map(Value::as_object_mut).for_each(bound);
    }
    if let Some(description) = schema.get("description").cloned() {
        schema.insert("markdownDescription".into(), description);
    }
}

/// A key that chooses a variant is described as the variant is.
fn describe_variant(schema: &mut Map<String, Value>) {
    let Some(description) = schema.get("description").cloned() else { return };
    let Some(properties) = schema.get_mut("properties").and_then(Value::as_object_mut) else { return };
    if properties.len() == 1 {
        for key in properties.values_mut().filter_map(Value::as_object_mut) {
            key.entry("description").or_insert(description.clone());
        }
    }
}

/// Bounds a number, or the numbers of a list, as its description does.
fn bound(key: &mut Map<String, Value>) {
    let Some((keyword, bound)) = key.get("description").and_then(Value::as_str).and_then(range) else {
        return;
    };
    let is_number = |schema: &Map<String, Value>| {
        let has = |name: &str| match schema.get("type") {
            Some(Value::Array(types)) => types.iter().any(|t| t == name),
            Some(single) => single == name,
            None => false,
        };
        has("number") || has("integer")
    };
    let numbers = match is_number(key) {
        true => Some(key),
        false => key.get_mut("items").and_then(Value::as_object_mut).filter(|items| is_number(items)),
    };
    if let Some(numbers) = numbers {
        numbers.insert(keyword.into(), bound);
    }
}

/// The keyword and the bound that a description gives as `, > 0` or `, >= 1`, also of a letter: `n >= 1`.
fn range(description: &str) -> Option<(&'static str, Value)> {
    let strict = description.split_once(", > ").map(|(_, bound)| ("exclusiveMinimum", bound));
    let (keyword, bound) =
        strict.or_else(|| description.split_once(" >= ").map(|(_, bound)| ("minimum", bound)))?;
    let end = bound.find(|c: char| !c.is_ascii_digit()).unwrap_or(bound.len());
    bound[..end].parse::<u32>().ok().map(|bound| (keyword, bound.into()))
}

#[cfg(test)]
mod tests {
    use super::range;

    #[test]
    fn descriptions_give_bounds() {
        for (description, expected) in [
            ("Young's modulus E, > 0; with `section`.", Some(("exclusiveMinimum", 0))),
            ("Number of cells, >= 1.", Some(("minimum", 1))),
            ("At every n-th step; n >= 1, default: 50.", Some(("minimum", 1))),
            ("Stretch at which a bond fails, > s_y.", None),
            ("In plane strain `blocks` for ν > 0.45.", None),
            ("A length.", None),
        ] {
            assert_eq!(range(description), expected.map(|(k, b)| (k, b.into())), "{description}");
        }
    }
}
