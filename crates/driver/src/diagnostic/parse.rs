//! Bytes to text to a typed case, with every fault as a [`Report`].

use serde::de::{DeserializeOwned, IgnoredAny};
use serde_json::Value;

use super::json::{self, Fault};
use super::path::JsonPath;
use super::{Diagnostic, Report, data, syntax, without_comments};

/// The text of a file: UTF-8, without a byte order mark.
///
/// # Errors
/// The first byte that is not UTF-8, with its place.
pub fn decode(file: &str, mut bytes: Vec<u8>) -> Result<String, Report> {
    if bytes.starts_with(b"\xEF\xBB\xBF") {
        bytes.drain(..3);
    }
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let utf16 = matches!(error.as_bytes(), [0xFF, 0xFE, ..] | [0xFE, 0xFF, ..]);
        let message = format!("the file is not UTF-8 text: byte 0x{:02X}", error.as_bytes()[at]);
        let mut diagnostic = Diagnostic::error(JsonPath::default(), message);
        diagnostic.hint(if utf16 { "this is UTF-16: save it as UTF-8" } else { "save it as UTF-8" });
        // Up to the fault nothing is replaced, so its offset holds in the lossy text too.
        diagnostic.span = Some(at..at + char::REPLACEMENT_CHARACTER.len_utf8());
        Report::of(file, String::from_utf8_lossy(error.as_bytes()), diagnostic)
    })
}

/// Reads a case, comments and trailing commas aside. `file` is only named in messages.
///
/// # Errors
/// The first fault of syntax, or else the first value that does not fit the type.
pub fn parse<T: DeserializeOwned>(file: &str, text: &str) -> Result<T, Report> {
    let plain = without_comments(text);
    json::read(&plain).map_err(|fault| Report::of(file, text, diagnose(&plain, &fault)))
}

/// A fault of syntax comes first, wherever it stands; `serde_json` has the words for it.
fn diagnose(text: &str, fault: &Fault) -> Diagnostic {
    let misfit = fault.misfit();
    let mut syntax_error = serde_json::from_str::<IgnoredAny>(text).err();
    if syntax_error.is_none() && (misfit.is_none() || json::read::<IgnoredAny>(text).is_err()) {
        // What is only found in values that are kept: 1e999, a lone surrogate, nesting beyond the limit.
        syntax_error = serde_json::from_str::<Value>(text).err();
    }
    match syntax_error {
        Some(error) => {
            let diagnostic = syntax::diagnose(text, &error);
            // A string without an end may have begun anywhere before.
            let is_placed = misfit.is_none() && !diagnostic.message.contains("inside a string");
            if is_placed { Diagnostic { path: fault.path(), ..diagnostic } } else { diagnostic }
        }
        None => data::diagnose(text, fault.path(), misfit.unwrap_or_default(), fault.at()),
    }
}

#[cfg(test)]
pub(super) mod tests {
    use serde::Deserialize;

    use super::*;

    /// A case in the form of the real ones, small.
    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields)]
    #[allow(dead_code, reason = "read by serde only")]
    pub(crate) struct Case {
        model: Model,
        #[serde(default)]
        supports: Vec<Support>,
        horizon_ratio: f64,
        cells: Option<u32>,
        #[serde(default)]
        direction: [f64; 3],
        title: Option<String>,
    }

    #[derive(Debug, Deserialize)]
    #[serde(rename_all = "snake_case", deny_unknown_fields)]
    #[allow(dead_code, reason = "read by serde only")]
    enum Model {
        TimoshenkoBeam { section: Section, length: f64, bond_law: Option<BondLaw> },
        Membrane(Membrane),
    }

    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields)]
    #[allow(dead_code, reason = "read by serde only")]
    struct Membrane {
        thickness: f64,
    }

    #[derive(Debug, Deserialize)]
    #[serde(rename_all = "snake_case", deny_unknown_fields)]
    #[allow(dead_code, reason = "read by serde only")]
    enum Section {
        Rectangle { width: f64, height: f64 },
        Circle { radius: f64 },
    }

    #[derive(Debug, Deserialize)]
    #[serde(rename_all = "snake_case")]
    enum BondLaw {
        Corrected,
        Published,
    }

    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields)]
    #[allow(dead_code, reason = "read by serde only")]
    struct Support {
        at: std::collections::BTreeMap<String, f64>,
        w: Option<f64>,
    }

    pub(crate) const GOOD: &str = r#"{ "model": { "timoshenko_beam": {
    "section": { "rectangle": { "width": 1, "height": 2 } }, "length": 1.0, "bond_law": "corrected" } },
  "supports": [ { "at": { "x": 0 }, "w": 0 } ], "horizon_ratio": 3, "cells": 8, "direction": [0, 0, 1], "title": "a" }"#;

    /// Message, underlined text and hint of [`GOOD`] with one piece replaced.
    pub(crate) fn fault(old: &str, new: &str) -> (String, String, String) {
        assert!(GOOD.contains(old), "{old}");
        let text = GOOD.replacen(old, new, 1);
        let report = parse::<Case>("x.json", &text).expect_err(&text);
        let shown = report.to_string();
        let lines: Vec<_> = shown.lines().collect();
        let from = lines[4].find('^').expect(&shown);
        let marked: String = lines[3].chars().skip(from).take(lines[4].matches('^').count()).collect();
        let [diagnostic] = &report.diagnostics[..] else { panic!("{shown}") };
        (diagnostic.message.clone(), marked, diagnostic.hint.clone().unwrap_or_default())
    }

    /// Checks lines `old => new | message | underlined | hint`, an empty hint being none given.
    #[track_caller]
    pub(crate) fn check(table: &str) {
        for line in table.lines().map(str::trim).filter(|line| !line.is_empty()) {
            let (old, rest) = line.split_once(" =>").expect(line);
            let mut expected = rest.split('|').map(str::trim);
            let found = fault(old, expected.next().expect(line));
            assert_eq!(Some(found.0.as_str()), expected.next(), "{line}");
            assert_eq!(Some(found.1.as_str()), expected.next(), "{line}");
            expected.for_each(|hint| assert_eq!(found.2, hint, "{line}"));
        }
    }

    #[test]
    fn a_good_case_is_read() {
        let case = parse::<Case>("x.json", GOOD).unwrap();
        assert_eq!((case.horizon_ratio, case.cells, case.direction), (3.0, Some(8), [0.0, 0.0, 1.0]));
    }

    #[test]
    fn syntax_comes_before_data_even_when_it_stands_later() {
        let (message, marked, _) = fault("\"width\": 1, \"height\": 2", "\"wdth\": 1, \"height\" 2");
        assert_eq!((message.as_str(), marked.as_str()), ("expected `:` after a key, found `2`", "2"));
    }

    #[test]
    fn one_wrong_character_anywhere_is_reported_and_never_a_panic() {
        for (at, old) in GOOD.char_indices() {
            for new in ["", "é", "\"", "{", "]", ",", "\\", "-", ".", "\n", "x", "1e999", "\u{0}"] {
                let text = format!("{}{new}{}", &GOOD[..at], &GOOD[at + old.len_utf8()..]);
                if let Err(report) = parse::<Case>("x.json", &text) {
                    let shown = report.to_string();
                    assert!(shown.contains("--> x.json:") && shown.contains('^'), "{text}\n{shown}");
                }
            }
        }
    }

    #[test]
    fn bytes_that_are_no_text_are_refused_with_their_place() {
        assert_eq!(decode("x", b"\xEF\xBB\xBF{}".to_vec()), Ok("{}".to_string()));
        let report = decode("x", b"{\n \"t\": \"B\xF6gen\" }".to_vec()).unwrap_err();
        assert_eq!(report.line_and_column(&report.diagnostics[0]), Some((2, 9)));
        assert!(report.to_string().contains("not UTF-8 text: byte 0xF6"), "{report}");
        assert!(decode("x", b"\xFF\xFE{\0".to_vec()).unwrap_err().to_string().contains("UTF-16"));
    }
}
