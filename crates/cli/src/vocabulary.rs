//! The words of cases, as the schema describes them.

use super::schema;
use peristat::case::Case;
use serde_json::Value;

/// The variants of a type of cases, or else its keys: name, and what it is.
pub(super) fn of(definition: &str) -> Vec<(String, String)> {
    let schema = schema::of::<Case>().to_value();
    let definition = &schema["$defs"][definition];
    match definition["oneOf"].as_array() {
        Some(variants) => variants.iter().flat_map(variant).collect(),
        None => keys(definition),
    }
}

/// A variant, which is a word or an object of one key; several words may share a description.
fn variant(variant: &Value) -> Vec<(String, String)> {
    if let Some(word) = variant["const"].as_str() {
        return vec![(word.into(), words(variant))];
    }
    match variant["enum"].as_array() {
        Some(all) => all.iter().filter_map(Value::as_str).map(|word| (word.into(), words(variant))).collect(),
        None => keys(variant),
    }
}

fn keys(object: &Value) -> Vec<(String, String)> {
    let keys = object["properties"].as_object().into_iter().flatten();
    keys.map(|(key, value)| (key.clone(), words(value))).collect()
}

/// A description on one line.
fn words(value: &Value) -> String {
    value["description"].as_str().unwrap_or_default().split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_list_has_words_with_descriptions() {
        for definition in ["Body", "Section", "FieldName", "Check", "Probe"] {
            let found = super::of(definition);
            assert!(found.len() >= 3, "{definition}: {found:?}");
            assert!(found.iter().all(|(name, about)| !name.is_empty() && !about.is_empty()), "{found:?}");
        }
    }
}
