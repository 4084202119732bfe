//! Values that are JSON but do not fit the type of the case, in plain words.

use super::Diagnostic;
use super::excerpt::{clip, quote};
use super::locate::{Place, locate};
use super::misspelt::misspelt;
use super::path::{JsonPath, Segment};
use super::words::choice;

/// Longest value that a message repeats.
const FOUND: usize = 40;
const ONE_KEY: &str = "an object with one key";
const NO_VALUES: &str = "no values";
/// What is expected where a variant stands; their names follow, with blanks between them.
pub(super) const VARIANT: &str = "string or map: ";

/// The diagnostic of what `serde` says of a value that does not fit, at `path`; up to the byte `at` the text was read.
pub(super) fn diagnose(text: &str, path: JsonPath, raw: &str, at: usize) -> Diagnostic {
    let named = |start: &str| raw.strip_prefix(start)?.strip_suffix('`');
    if let Some(rest) = raw.strip_prefix("unknown field `") {
        let (name, allowed) = unknown(rest);
        return at_key(text, path, misspelt("key", name, &allowed));
    }
    if let Some(rest) = raw.strip_prefix("unknown variant `") {
        let (name, allowed) = unknown(rest);
        let child = path.key(name);
        return match locate(text, &child).filter(|place| place.exact) {
            Some(_) => at_key(text, child, misspelt("key", name, &allowed)),
            None => Diagnostic { path, ..misspelt("value", name, &allowed) },
        };
    }
    if let Some(name) = named("missing field `") {
        let hint = of_probes(text, &path, name);
        return Diagnostic { hint, ..Diagnostic::error(path, format!("`{name}` is missing")) };
    }
    if let Some(name) = named("duplicate field `") {
        let mut diagnostic = Diagnostic::error(path.key(name), format!("`{name}` stands twice"));
        // The path leads to the first of the two; the text was read up to the end of the second.
        let quote = at.saturating_sub(1);
        let start = text.get(..quote).and_then(|before| before.rfind('"'));
        diagnostic.span = start.map(|start| start..at).filter(|span| text.get(span.clone()).is_some());
        return diagnostic;
    }
    misfit(text, path, raw)
}

/// The name before its closing backtick, and the names that were expected instead.
fn unknown(rest: &str) -> (&str, Vec<&str>) {
    // The user's name may hold anything; what `serde` adds holds only names of our own.
    let end = rest.rfind("`, expected ").or_else(|| rest.rfind("`, there are no "));
    let (name, allowed) = rest.split_at(end.unwrap_or(rest.len()));
    (name, allowed.split('`').skip(2).step_by(2).collect())
}

/// What to write where the name of a probe is missing: as `load` of a body that breaks or softens, or as `probe` of a check.
fn of_probes(text: &str, path: &JsonPath, name: &str) -> Option<String> {
    let is_of = |key: &str| path.0.last() == Some(&Segment::Key(key.into()));
    let role = match name {
        "load" if is_of("fracture") || is_of("path") => {
            "it is the name of the probe that the curve shows as load, such as one of a `reaction_y`"
        }
        "probe" => "it is the name of a probe",
        _ => return None,
    };
    let case: serde_json::Value = serde_json::from_str(text).ok()?;
    let probes = case["probes"].as_array().map_or(&[][..], Vec::as_slice);
    let names: Vec<&str> = probes.iter().filter_map(|probe| probe["name"].as_str()).collect();
    Some(match choice(&names) {
        Some(names) => clip(&format!("{role}: here {names}"), 5 * FOUND),
        None => format!("{role}; the case has no `probes` yet"),
    })
}

/// Underlines the key at `path` and not its value.
fn at_key(text: &str, path: JsonPath, diagnostic: Diagnostic) -> Diagnostic {
    let span = locate(text, &path).filter(|place| place.exact).and_then(|place| place.key);
    Diagnostic { path, span, ..diagnostic }
}

/// `invalid type: string "a", expected f64` and its kin.
fn misfit(text: &str, path: JsonPath, raw: &str) -> Diagnostic {
    let Some((found, expected)) =
        raw.strip_prefix("invalid ").and_then(|rest| rest.rsplit_once(", expected "))
    else {
        // A message of our own types.
        return Diagnostic::error(path, raw);
    };
    let place = locate(text, &path);
    let value = place.as_ref().filter(|place| place.exact).map(|place| &text[place.value.clone()]);
    if found == "type: unit variant" {
        // The name alone stands where an object with that key is expected; its path ends with the name.
        let name = string_at(text, place.as_ref());
        let mut diagnostic =
            Diagnostic::error(path, format!("{} needs its values, found only the name", quote(name)));
        diagnostic.hint(format!("write {{\"{}\": {{...}}}}", clip(name, FOUND)));
        return diagnostic;
    }
    if let Some(length) = found.strip_prefix("length ").filter(|_| !expected.contains("struct")) {
        return Diagnostic::error(path, list_length(length, expected));
    }
    let is_position = expected == "struct At";
    let variants = expected.strip_prefix(VARIANT);
    let expected = expectation(expected);
    let message = match value {
        Some(value) if value.bytes().all(|b| b.is_ascii_digit()) && expected.contains("whole") => {
            return Diagnostic::error(path, format!("{} is too large", quote(value)));
        }
        Some(value) => format!("expected {expected}, found {}", describe(value, &expected)),
        None => format!("expected {expected}"),
    };
    let mut diagnostic = Diagnostic::error(path, message);
    if let Some(x) = value.filter(|v| is_position && v.parse::<f64>().is_ok()) {
        diagnostic.hint(format!("a position is written {{ \"x\": {} }}", clip(x, FOUND)));
    } else if let Some(name) = value.filter(|v| is_position && v.starts_with('"')) {
        let name = clip(name, FOUND);
        diagnostic.hint(format!(
            "a region or an edge is written {{ \"region\": {name} }}, a joint {{ \"joint\": {name} }}"
        ));
    } else if let Some(variants) = variants {
        diagnostic.hint(match value.filter(|v| v.parse::<f64>().is_ok()) {
            Some(x) if variants.split(' ').any(|name| name == "uniform") => {
                format!("what is the same everywhere is written {{ \"uniform\": {} }}", clip(x, FOUND))
            }
            _ => format!("allowed here: `{}`", variants.replace(' ', "`, `")),
        });
    } else if expected == NO_VALUES {
        diagnostic.hint("write the name alone, as a string");
    } else if expected.contains("whole") && value.is_some_and(|v| v.contains(['.', 'e', 'E'])) {
        diagnostic.hint("write it without a point or exponent");
    }
    diagnostic
}

/// The content of a string, as it is written.
fn string_at<'a>(text: &'a str, place: Option<&Place>) -> &'a str {
    place.map_or("", |place| text[place.value.clone()].trim_matches('"'))
}

fn list_length(found: &str, expected: &str) -> String {
    format!("expected a list of {} values, found {found}", last_word(expected))
}

fn last_word(text: &str) -> &str {
    text.rsplit(' ').next().unwrap_or_default()
}

/// What `serde` expected, in the words of a case file.
fn expectation(serde: &str) -> String {
    let words = match serde {
        "f64" | "f32" => "a number",
        "usize" | "u64" | "u32" | "u16" | "u8" => "a whole number from 0",
        "isize" | "i64" | "i32" | "i16" | "i8" => "a whole number",
        "a nonzero usize" | "a nonzero u64" | "a nonzero u32" => "a whole number from 1",
        "a boolean" => "`true` or `false`",
        "a sequence" => "a list [...]",
        "a map" | "map" | "struct variant" | "newtype variant" => "an object {...}",
        "map with a single key" => ONE_KEY,
        _ if serde.starts_with(VARIANT) => "a name, or an object with one key",
        "unit" | "unit variant" => NO_VALUES,
        _ if serde.starts_with("struct ") => "an object {...}",
        _ if serde.starts_with("an array of length ") || serde.starts_with("a tuple of size ") => {
            return format!("a list of {} values", last_word(serde));
        }
        other => other,
    };
    words.to_string()
}

/// The value as it is written; of objects and lists only the kind, and the keys where one is too many.
fn describe(value: &str, expected: &str) -> String {
    let keys = || serde_json::from_str::<serde_json::Map<_, _>>(value).unwrap_or_default();
    match value.as_bytes().first() {
        Some(b'{') if value[1..].trim_start().starts_with('}') => "an empty object".to_string(),
        Some(b'{') if expected == ONE_KEY => {
            let names: Vec<_> = keys().keys().map(|key| quote(key)).collect();
            format!("{}: {}", names.len(), clip(&names.join(", "), 2 * FOUND))
        }
        Some(b'{') => "an object".to_string(),
        Some(b'[') => "a list".to_string(),
        Some(b'"') => format!("the string {}", clip(value, FOUND)),
        _ => clip(value, FOUND),
    }
}

#[cfg(test)]
mod tests {
    use super::super::parse::tests::{check, fault};

    #[test]
    fn a_misspelt_name_is_underlined_and_the_nearest_is_offered() {
        check(
            r#"
            "length" => "lenght" | unknown key `lenght` | "lenght" | did you mean `length`?
            "w" => "W" | unknown key `W` | "W" | did you mean `w`?
            "rectangle" => "rectangel" | unknown key `rectangel` | "rectangel" | did you mean `rectangle`?
            "corrected" => "correcte" | unknown value `correcte` | "correcte" | did you mean `corrected`?
            "timoshenko_beam" => "Timoshenko-Beam" | unknown key `Timoshenko-Beam` | "Timoshenko-Beam" | did you mean `timoshenko_beam`?
            "#,
        );
    }

    #[test]
    fn a_name_like_none_lists_what_is_allowed() {
        check(
            r#"
            "rectangle" => "pipe" | unknown key `pipe` | "pipe" | allowed here: `rectangle`, `circle`
            "w" => "q`, expected `z" | unknown key `q`, expected `z` | "q`, expected `z" | allowed here: `at`, `w`
            "#,
        );
    }

    #[test]
    fn a_missing_or_doubled_key_is_shown_in_its_object() {
        check(
            r#"
            , "height": 2 => | `height` is missing | "rectangle"
            "horizon_ratio": 3, => | `horizon_ratio` is missing | {
            "at": { "x": 0 }, => | `at` is missing | {
            "height": 2 => "width": 2 | `width` stands twice | "width"
            "#,
        );
        // The second of the two is underlined: in column 15 of its line.
        let text = "{ \"cells\": 1,\n \"title\": \"\", \"cells\": 2 }";
        let report = super::super::parse::<super::super::parse::tests::Case>("x", text).unwrap_err();
        assert_eq!(report.line_and_column(&report.diagnostics[0]), Some((2, 15)));
    }

    #[test]
    fn a_value_of_the_wrong_type_is_repeated_as_it_was_written() {
        check(
            r#"
            : 3, => : "a, expected b", | expected a number, found the string "a, expected b" | "a, expected b" |
            : 3, => : [3], | expected a number, found a list | "horizon_ratio"
            : 3, => : null, | expected a number, found null | null
            : 8, => : -1, | expected a whole number from 0, found -1 | -1
            : 8, => : 1e3, | expected a whole number from 0, found 1e3 | 1e3 | write it without a point or exponent
            : 8, => : 99999999999, | `99999999999` is too large | 99999999999 |
            "title": "a" => "title": 3 | expected a string, found 3 | 3
            "x": 0 => "x": true | expected a number, found true | true
            [ { "at": { "x": 0 }, "w": 0 } ] => {} | expected a list [...], found an empty object | "supports"
            "#,
        );
    }

    #[test]
    fn lists_of_fixed_length_say_how_many() {
        check(
            r#"
            [0, 0, 1] => [0, 0] | expected a list of 3 values, found 2 | "direction"
            [0, 0, 1] => [0, 0, 1, 2] | expected a list of 3 values, found 4 | "direction"
            [0, 0, 1] => 7 | expected a list of 3 values, found 7 | 7
            "#,
        );
    }

    #[test]
    fn an_enum_says_what_it_needs() {
        check(
            r#"
            { "rectangle" => { "circle": { "radius": 1 }, "rectangle" | expected an object with one key, found 2: `circle`, `rectangle` | "section"
            { "rectangle": { "width": 1, "height": 2 } } => {} | expected an object with one key, found an empty object | "section"
            { "rectangle": { "width": 1, "height": 2 } } => 7 | expected a name, or an object with one key, found 7 | 7
            { "rectangle": { "width": 1, "height": 2 } } => "circle" | `circle` needs its values, found only the name | "circle" | write {"circle": {...}}
            { "width": 1, "height": 2 } => "a" | expected an object {...}, found the string "a" | "a"
            "corrected" => { "corrected": 3 } | expected no values, found 3 | 3 | write the name alone, as a string
            "#,
        );
        let (message, ..) = fault("\"title\": \"a\"", "\"title\": {}");
        assert_eq!(message, "expected a string, found an empty object");
    }
}
