//! From a file, or a text, to a [`Case`].

use super::Case;
use crate::diagnostic::{self, Diagnostic, JsonPath, Report, Segment, decode, study_for_case};
use crate::input;
use serde_json::Value;
use std::path::Path;
use std::str::FromStr;

/// A case with the text it came from, for messages.
#[derive(Clone, Debug)]
pub struct Source {
    /// The case.
    pub case: Case,
    /// Its file, as the user wrote it.
    pub file: String,
    /// Its text, overrides included.
    pub text: String,
}

/// Reads a case and applies overrides of the form `path=value`; `max_memory` is in bytes, without it there is what the
/// machine has.
///
/// # Errors
/// A [`Report`] with the place of the fault.
pub fn read(path: &Path, overrides: &[String], max_memory: Option<u64>) -> Result<Source, Report> {
    from_text(&path.display().to_string(), read_text(path, max_memory)?, overrides)
}

/// The text of a case file, which is regular and fits into so many bytes of memory, or what the machine has.
///
/// # Errors
/// A [`Report`] that says why it cannot be read.
pub fn read_text(path: &Path, max_memory: Option<u64>) -> Result<String, Report> {
    let file = path.display().to_string();
    let bytes = input::file::read(path, max_memory).map_err(|refusal| {
        let (message, hint) = match path.try_exists() {
            _ if path.is_dir() => {
                ("this is a folder, not a case".into(), Some("`peristat verify` runs all cases of a folder"))
            }
            Ok(false) => (
                "there is no such file".into(),
                Some("`peristat new timoshenko_beam` prints a case to begin with"),
            ),
            _ => (format!("the file {}", refusal.reason), refusal.hint),
        };
        let mut diagnostic = Diagnostic::error(JsonPath::default(), message);
        diagnostic.hint = hint.map(Into::into);
        Report { file: file.clone(), text: String::new(), diagnostics: vec![diagnostic] }
    })?;
    decode(&file, bytes)
}

/// Reads a case from a text; `file` names it in messages.
///
/// # Errors
/// As [`read`].
pub fn from_text(file: &str, text: String, overrides: &[String]) -> Result<Source, Report> {
    if overrides.is_empty() {
        let case = diagnostic::parse(file, &text).map_err(|report| study_for_case(file, &text, report))?;
        return Ok(Source { case, file: file.into(), text });
    }
    let mut value: Value = diagnostic::parse(file, &text)?;
    for assignment in overrides {
        set(&mut value, assignment).map_err(|message| {
            let mut diagnostic = Diagnostic::error(JsonPath::default(), message);
            diagnostic.hint("for example `--set body.line.cells=200`");
            Report { file: format!("--set {assignment}"), text: String::new(), diagnostics: vec![diagnostic] }
        })?;
    }
    let changed = format!("{value:#}");
    let name = format!("{file} with --set");
    let case = diagnostic::parse(&name, &changed).map_err(|report| study_for_case(file, &text, report))?;
    let (file, text) = (name, changed);
    Ok(Source { case, file, text })
}

/// Sets one value; missing keys are made, elements of lists must exist.
fn set(root: &mut Value, assignment: &str) -> Result<(), String> {
    let (path, value) = assignment.split_once('=').ok_or("an override has the form path=value")?;
    let path = JsonPath::from_str(path.trim()).map_err(|e| e.to_string())?;
    // What is no JSON is meant as a text.
    let value = serde_json::from_str(value).unwrap_or_else(|_| Value::from(value));
    let mut place = root;
    for segment in &path.0 {
        place = match (segment, place) {
            (Segment::Key(key), Value::Object(map)) => {
                map.entry(key).or_insert(Value::Object(Default::default()))
            }
            (Segment::Index(index), Value::Array(list)) => {
                let length = list.len();
                list.get_mut(*index).ok_or(format!("`{path}` names element {index} of a list of {length}"))?
            }
            _ => {
                return Err(format!("`{path}` goes through a value that is neither an object nor a list"));
            }
        };
    }
    *place = value;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn overrides_replace_and_add_values() {
        let mut value: Value = serde_json::from_str(r#"{"a": {"b": [1, 2]}}"#).unwrap();
        set(&mut value, "a.b[1]=5").unwrap();
        set(&mut value, "a.c=text").unwrap();
        assert_eq!(value, serde_json::json!({"a": {"b": [1, 5], "c": "text"}}));
        assert!(set(&mut value, "a.b[2]=0").unwrap_err().contains("a list of 2"));
        assert!(set(&mut value, "a.b").unwrap_err().contains("path=value"));
        assert!(set(&mut value, "a.c.d=1").unwrap_err().contains("goes through"));
    }
}
