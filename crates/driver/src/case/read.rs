//! From a file, or a text, to a [`Case`].

use super::Case;
use super::library::Library;
use crate::diagnostic::{self, Diagnostic, Faults, JsonPath, Report, Segment, decode, root, study_for_case};
use crate::input::{self, Folder};
use serde_json::{Map, Value};
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

/// Reads a case and applies overrides of the form `path=value`; `folder` is where its library is looked for, `max_memory` is in
/// bytes, without it there is what the machine has.
///
/// # Errors
/// A [`Report`] with the place of the fault.
pub fn read(
    path: &Path,
    overrides: &[String],
    folder: &Folder,
    max_memory: Option<u64>,
) -> Result<Source, Report> {
    from_text(&path.display().to_string(), read_text(path, max_memory)?, overrides, folder)
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

/// Reads a case from a text; `file` names it in messages, `folder` is where its library is looked for.
///
/// # Errors
/// As [`read`].
pub fn from_text(file: &str, text: String, overrides: &[String], folder: &Folder) -> Result<Source, Report> {
    let (name, changed) = match overrides {
        [] => (file.to_string(), text.clone()),
        _ => (format!("{file} with --set"), with_overrides(file, &text, overrides)?),
    };
    let case = match changed.contains(LIBRARY) {
        true => with_library(&name, &changed, folder),
        false => diagnostic::parse(&name, &changed),
    };
    let case = case.map_err(|report| study_for_case(file, &text, report))?;
    Ok(Source { case, file: name, text: changed })
}

/// The text of a case with overrides.
fn with_overrides(file: &str, text: &str, overrides: &[String]) -> Result<String, Report> {
    let mut value: Value = diagnostic::parse(file, text)?;
    for assignment in overrides {
        set(&mut value, assignment).map_err(|message| {
            let mut diagnostic = Diagnostic::error(JsonPath::default(), message);
            diagnostic.hint("for example `--set body.line.cells=200`");
            Report { file: format!("--set {assignment}"), text: String::new(), diagnostics: vec![diagnostic] }
        })?;
    }
    Ok(format!("{value:#}"))
}

/// The key of a library as texts have it.
const LIBRARY: &str = "\"library\"";

/// A case with what it takes of its library. Faults of the form of what was filled in are shown in the filled text, all others in that
/// of the author.
fn with_library(file: &str, text: &str, folder: &Folder) -> Result<Case, Report> {
    let mut keys: Map<String, Value> = diagnostic::parse(file, text)?;
    let Some(library) = keys.get("library").and_then(Value::as_str) else {
        return diagnostic::parse(file, text);
    };
    let refuse = |faults: Faults| faults.into_report(file, text);
    let library = Library::read(library, folder, None).map_err(refuse)?;
    library.fill(&mut keys).map_err(refuse)?;
    let filled = format!("{:#}", Value::Object(keys));
    let case: Case = diagnostic::parse(&format!("{file} with its library"), &filled)?;
    let (own, of_case) = (library.units, case.units);
    if own != of_case {
        let mut faults = Faults::default();
        let message = format!("the library is in {}, and the case in {}", own.name(), of_case.name());
        faults.error(root("library"), message).hint("nothing is converted: give both the same `units`");
        return Err(refuse(faults));
    }
    Ok(case)
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
