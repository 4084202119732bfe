//! The JSON Schema of cases as a page for people: every type with its keys, in the order in which a reader meets them.

use serde_json::{Map, Value};
use std::fmt::Write;

/// What the page of studies begins with.
pub(super) const STUDIES: &str = "\
# Keys of a study

Made by `peristat schema --study --markdown` from the program itself; it is read like the keys of a case.

";

/// What the page of cases begins with.
pub(super) const CASES: &str = "\
# Keys of a case

Made by `peristat schema --markdown` from the program itself; every case that it reads is of this form, and a key that is
not here is an error. The third column has `required`, the value that is taken if the key is left out, or nothing where
leaving it out means that there is none. Types with several forms take one of them: `{ \"rectangle\": { … } }` is an object
with that single key.

";

/// What comes before the name of a type in a reference to it.
const DEFINITIONS: &str = "#/$defs/";

/// The page of a schema whose types are in `$defs`.
pub(super) fn page(schema: &Value, head: &str) -> String {
    let mut page = Page { schema, text: head.into(), met: Vec::new() };
    page.section(text_of(schema, "title"), schema);
    page.text.trim_end().to_string() + "\n"
}

/// A page being written.
struct Page<'a> {
    schema: &'a Value,
    text: String,
    /// Types that have their section.
    met: Vec<&'a str>,
}

impl<'a> Page<'a> {
    /// Writes a type, and behind it those it names that have not come yet.
    fn section(&mut self, name: &str, schema: &'a Value) {
        let _ = write!(self.text, "## {name}\n\n{}\n\n", text_of(schema, "description"));
        let mut rows = String::new();
        let head = match schema["oneOf"].as_array() {
            Some(forms) if forms.iter().all(|form| form["properties"].is_null()) => {
                for word in forms {
                    rows += &row(&[&kind(word), text_of(word, "description")]);
                }
                "| one of | meaning |\n|---|---|"
            }
            Some(forms) => {
                forms.iter().for_each(|form| form_rows(form, &mut rows));
                "| one of | type | | meaning |\n|---|---|---|---|"
            }
            None => {
                key_rows(schema, "", &mut rows);
                "| key | type | | meaning |\n|---|---|---|---|"
            }
        };
        if !rows.is_empty() {
            let _ = write!(self.text, "{head}\n{rows}\n");
        }
        let mut named = Vec::new();
        references(schema, &mut named);
        for name in named {
            if !self.met.contains(&name)
                && let Some(definition) = self.schema["$defs"].get(name)
            {
                self.met.push(name);
                self.section(name, definition);
            }
        }
    }
}

/// Rows of the keys of an object, and of those of objects in it that have no name of their own.
fn key_rows(schema: &Value, prefix: &str, rows: &mut String) {
    let required: Vec<&str> =
        schema["required"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    for (key, value) in schema["properties"].as_object().into_iter().flatten() {
        let need = match value.get("default") {
            _ if required.contains(&key.as_str()) => "required".into(),
            // An empty list is what leaving it out means.
            Some(default) if default.as_array().is_none_or(|list| !list.is_empty()) => format!("`{default}`"),
            _ => String::new(),
        };
        let path = format!("{prefix}{key}");
        *rows += &row(&[&format!("`{path}`"), &kind(value), &need, text_of(value, "description")]);
        key_rows(value, &format!("{path}."), rows);
    }
}

/// Rows of one form of a type: a word, or an object with a single key.
fn form_rows(form: &Value, rows: &mut String) {
    let about = text_of(form, "description");
    match form["properties"].as_object().and_then(|keys| keys.iter().next()) {
        Some((key, value)) => {
            *rows += &row(&[&format!("`{key}`"), &kind(value), "", about]);
            key_rows(value, &format!("{key}."), rows);
        }
        None => *rows += &row(&[&kind(form), "", "", about]),
    }
}

fn row(cells: &[&str]) -> String {
    let cell = |text: &&str| text.replace("\n\n", "<br>").replace('\n', " ").replace('|', "\\|");
    format!("| {} |\n", cells.iter().map(cell).collect::<Vec<_>>().join(" | "))
}

fn text_of<'a>(schema: &'a Value, key: &str) -> &'a str {
    schema[key].as_str().unwrap_or_default()
}

/// What a value may be, in words.
fn kind(schema: &Value) -> String {
    let joined = |all: &[Value], one: &dyn Fn(&Value) -> String| -> String {
        let kinds: Vec<String> = all.iter().filter(|s| s["type"] != "null").map(one).collect();
        kinds.join(" or ")
    };
    if let Some(name) = name(schema) {
        return format!("[{name}](#{})", name.to_lowercase());
    }
    if let Some(any) = schema["anyOf"].as_array() {
        return joined(any, &kind);
    }
    if let Some(words) = schema["enum"].as_array() {
        return joined(words, &|word| format!("`{word}`"));
    }
    if let Some(word) = schema.get("const") {
        return format!("`{word}`");
    }
    match type_of(schema) {
        "number" => "number".into(),
        "integer" => "whole number".into(),
        "boolean" => "true or false".into(),
        "string" => "text".into(),
        "array" => {
            let (least, most) = (&schema["minItems"], &schema["maxItems"]);
            let count = if least.is_u64() && least == most { format!("{least} ") } else { String::new() };
            format!("list of {count}{}", plural(&kind(&schema["items"])))
        }
        "object" if schema["additionalProperties"].is_object() => {
            format!("{} by name", plural(&kind(&schema["additionalProperties"])))
        }
        "object" => "object".into(),
        other => other.into(),
    }
}

/// The type, whether or not `null` stands for leaving the key out.
fn type_of(schema: &Value) -> &str {
    let named = schema["type"].as_array().into_iter().flatten().filter_map(Value::as_str);
    schema["type"].as_str().or(named.into_iter().find(|t| *t != "null")).unwrap_or("any value")
}

fn plural(kind: &str) -> String {
    match kind.strip_prefix("list of ") {
        Some(rest) => format!("lists of {rest}"),
        None if kind.starts_with(['[', '`']) => kind.into(),
        None => format!("{kind}s"),
    }
}

/// Name of the type that a schema refers to.
fn name(schema: &Value) -> Option<&str> {
    schema.get("$ref")?.as_str()?.strip_prefix(DEFINITIONS)
}

/// Names of all types that a schema refers to, in their order.
fn references<'a>(schema: &'a Value, names: &mut Vec<&'a str>) {
    names.extend(name(schema));
    let inside: Vec<&Value> = match schema {
        Value::Object(keys) => own(keys).collect(),
        Value::Array(items) => items.iter().collect(),
        _ => Vec::new(),
    };
    inside.into_iter().for_each(|inner| references(inner, names));
}

/// Values of a schema but for the list of all types.
fn own(keys: &Map<String, Value>) -> impl Iterator<Item = &Value> {
    keys.iter().filter(|(key, _)| *key != "$defs").map(|(_, value)| value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn a_type_has_its_keys_and_comes_before_those_it_names() {
        let schema = json!({
            "title": "Box", "description": "A box.", "type": "object", "required": ["lid"],
            "properties": {
                "lid": { "$ref": "#/$defs/Lid", "description": "On top." },
                "size": { "type": "array", "items": { "type": "number" }, "minItems": 2, "maxItems": 2 },
                "colour": { "type": ["string", "null"], "default": "red", "description": "Red|green,\nor none." }
            },
            "$defs": { "Lid": { "description": "A lid.", "oneOf": [
                { "const": "flat", "description": "No dome." },
                { "properties": { "dome": { "type": "object", "required": ["height"],
                    "properties": { "height": { "type": "number", "description": "Its height." } } } },
                  "description": "Round." } ] } }
        });
        let expected = "\
## Box

A box.

| key | type | | meaning |
|---|---|---|---|
| `lid` | [Lid](#lid) | required | On top. |
| `size` | list of 2 numbers |  |  |
| `colour` | text | `\"red\"` | Red\\|green, or none. |

## Lid

A lid.

| one of | type | | meaning |
|---|---|---|---|
| `\"flat\"` |  |  | No dome. |
| `dome` | object |  | Round. |
| `dome.height` | number | required | Its height. |
";
        assert_eq!(page(&schema, CASES).strip_prefix(CASES), Some(expected));
    }
}
