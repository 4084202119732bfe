//! Cases and studies that are taken for each other.

use super::{Diagnostic, JsonPath, Report, without_comments};
use serde_json::{Map, Value};

/// The report of a study that was read as a case, in place of its unknown keys.
pub(crate) fn study_for_case(file: &str, text: &str, report: Report) -> Report {
    let is_study = |keys: &Map<String, Value>| keys.contains_key("case") && !keys.contains_key("model");
    let message = ("case", "this is a study, not a case", format!("`peristat study {file}` solves it"));
    misread(file, text, is_study, message).unwrap_or(report)
}

/// The report of a case that was read as a study.
pub(crate) fn case_for_study(file: &str, text: &str, report: Report) -> Report {
    let is_case = |keys: &Map<String, Value>| keys.contains_key("model") && !keys.contains_key("case");
    let message = ("model", "this is a case, not a study", format!("`peristat run {file}` solves it"));
    misread(file, text, is_case, message).unwrap_or(report)
}

fn misread(
    file: &str,
    text: &str,
    is_other: impl Fn(&Map<String, Value>) -> bool,
    (key, message, hint): (&str, &str, String),
) -> Option<Report> {
    let keys: Map<String, Value> = serde_json::from_str(&without_comments(text)).ok()?;
    is_other(&keys).then(|| {
        let mut diagnostic = Diagnostic::error(JsonPath::default().key(key), message);
        diagnostic.hint(hint);
        Report::of(file, text, diagnostic)
    })
}
