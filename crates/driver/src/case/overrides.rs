//! Overrides of a case, written into its text, so that lines, comments and all that is not overridden stay the author's.

use crate::diagnostic::locate::{Place, locate};
use crate::diagnostic::{self, Diagnostic, JsonPath, Report, Segment, without_comments};
use serde_json::Value;
use std::str::FromStr;

/// The text of a case with overrides of the form `path=value`.
///
/// # Errors
/// The text is no JSON, or an override does not fit it.
pub(super) fn with_overrides(file: &str, text: &str, overrides: &[String]) -> Result<String, Report> {
    let _: Value = diagnostic::parse(file, text)?;
    let mut text = text.to_string();
    for assignment in overrides {
        set(&mut text, assignment).map_err(|message| {
            let mut diagnostic = Diagnostic::error(JsonPath::default(), message);
            diagnostic.hint("for example `--set body.line.cells=200`");
            Report { file: format!("--set {assignment}"), text: String::new(), diagnostics: vec![diagnostic] }
        })?;
    }
    Ok(text)
}

/// Sets one value; missing keys are made, elements of lists must exist.
fn set(text: &mut String, assignment: &str) -> Result<(), String> {
    let (path, value) = assignment.split_once('=').ok_or("an override has the form path=value")?;
    let path = JsonPath::from_str(path.trim()).map_err(|e| e.to_string())?;
    // What is no JSON is meant as a text.
    let value = serde_json::from_str(value).unwrap_or_else(|_| Value::from(value));
    let (depth, place) = nearest(text, &path)?;
    let Some(missing) = path.0.get(depth) else {
        let lines = text[place.value.clone()].matches('\n').count();
        text.replace_range(place.value, &format!("{value}{}", "\n".repeat(lines)));
        return Ok(());
    };
    let parent: Value = serde_json::from_str(&without_comments(text)[place.value.clone()])
        .map_err(|e| format!("`{path}`: {e}"))?;
    match (missing, parent) {
        (Segment::Key(key), Value::Object(members)) => {
            let nested =
                path.0[depth + 1..].iter().rev().try_fold(value, |inner, segment| match segment {
                    Segment::Key(key) => Ok(Value::from_iter([(key.clone(), inner)])),
                    Segment::Index(_) => {
                        Err(format!("`{path}` names an element of a list that is not there"))
                    }
                })?;
            let (key, comma) = (Value::from(key.as_str()), if members.is_empty() { "" } else { ", " });
            text.insert_str(place.value.start + 1, &format!(" {key}: {nested}{comma}"));
            Ok(())
        }
        (Segment::Index(index), Value::Array(list)) => {
            Err(format!("`{path}` names element {index} of a list of {}", list.len()))
        }
        _ => Err(format!("`{path}` goes through a value that is neither an object nor a list")),
    }
}

/// The value that a path names or the nearest parent of it that is written, and how many segments lead there.
fn nearest(text: &str, path: &JsonPath) -> Result<(usize, Place), String> {
    let plain = without_comments(text);
    let exact = |depth: usize| {
        let place = locate(&plain, &JsonPath(path.0[..depth].to_vec()))?;
        place.exact.then_some((depth, place))
    };
    (0..=path.0.len()).rev().find_map(exact).ok_or_else(|| "the case is empty".into())
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "{\n  // Sizes.\n  \"a\": { \"b\": [1,\n    2] }, // last\n  \"d\": {},\n}";

    fn with(overrides: &[&str]) -> Result<String, String> {
        let mut text = TEXT.to_string();
        overrides.iter().try_for_each(|assignment| set(&mut text, assignment)).map(|()| text)
    }

    #[test]
    fn overrides_replace_and_add_values_where_they_belong() {
        let text = with(&["a.b[1]=5", "a.c=text", "d.e.f=[true]", "g=2"]).unwrap();
        let value: Value = serde_json::from_str(&without_comments(&text)).unwrap();
        let asked = serde_json::json!({"a": {"b": [1, 5], "c": "text"}, "d": {"e": {"f": [true]}}, "g": 2});
        assert_eq!(value, asked);
        // Comments stay, and lines are those of the author.
        assert!(text.contains("// Sizes.") && text.contains("// last"), "{text}");
        assert_eq!(text.lines().position(|line| line.contains("\"d\"")), Some(4), "{text}");
        let shorter = with(&["a={}", "a.x=1"]).unwrap();
        assert_eq!(shorter.lines().position(|line| line.contains("\"d\"")), Some(4), "{shorter}");
    }

    #[test]
    fn overrides_that_fit_nowhere_are_refused() {
        let refused = |assignment: &str| with(&[assignment]).unwrap_err();
        assert!(refused("a.b[2]=0").contains("a list of 2"));
        assert!(refused("a.b").contains("path=value"));
        assert!(refused("a.b[0].d=1").contains("goes through"));
        assert!(refused("a.b.c=1").contains("goes through"));
        assert!(refused("a.x[0]=1").contains("not there"));
    }
}
