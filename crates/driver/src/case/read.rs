//! From a file, or a text, to a [`Case`].

use super::Case;
use super::library::Library;
use super::overrides::with_overrides;
use crate::diagnostic::{self, Diagnostic, Faults, JsonPath, Report, decode, root, study_for_case};
use crate::input::{self, Folder};
use serde_json::{Map, Value};
use std::path::Path;

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
