//! Faults as other programs read them.

use super::fault::{Diagnostic, Report, Severity};
use crate::Error;
use serde::Serialize;

/// One fault or warning with its parts.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct FaultRecord {
    /// `error` or `warning`.
    pub severity: &'static str,
    /// What is wrong, in one line.
    pub message: String,
    /// The value at fault, such as `body.rectangle.size`; empty for what is no single value.
    pub path: String,
    /// Line of the text, from 1, where the text is known.
    pub line: Option<usize>,
    /// Column in characters, from 1.
    pub column: Option<usize>,
    /// What to do about it.
    pub hint: Option<String>,
    /// The tasks of a study that have it, in words.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tasks: Option<String>,
}

impl FaultRecord {
    fn of(report: &Report, diagnostic: &Diagnostic) -> Self {
        let place = report.line_and_column(diagnostic);
        Self {
            severity: if diagnostic.severity == Severity::Error { "error" } else { "warning" },
            message: diagnostic.message.clone(),
            path: diagnostic.path.to_string(),
            line: place.map(|(line, _)| line),
            column: place.map(|(_, column)| column),
            hint: diagnostic.hint.clone(),
            tasks: None,
        }
    }

    /// A fault of no single value. Its hint, if any, is the line after the message.
    fn plain(text: &str) -> Self {
        let (message, hint) = text.split_once("\nhint: ").map_or((text, None), |(m, h)| (m, Some(h.into())));
        let (message, path) = (message.into(), String::new());
        Self { severity: "error", message, path, line: None, column: None, hint, tasks: None }
    }
}

impl Report {
    /// All faults and warnings with their parts.
    pub fn records(&self) -> Vec<FaultRecord> {
        self.diagnostics.iter().map(|diagnostic| FaultRecord::of(self, diagnostic)).collect()
    }
}

impl Error {
    /// What is wrong, fault by fault.
    pub fn records(&self) -> Vec<FaultRecord> {
        match self {
            Self::Case(report) => report.records(),
            Self::Tasks(faults) => faults
                .groups()
                .flat_map(|(tasks, error)| {
                    error
                        .records()
                        .into_iter()
                        .map(move |record| FaultRecord { tasks: Some(tasks.clone()), ..record })
                })
                .collect(),
            other => vec![FaultRecord::plain(&other.to_string())],
        }
    }

    /// The error as one text: of a case, every fault in its place.
    pub fn text(&self) -> String {
        match self {
            Self::Case(report) => report.render(false).trim_end().to_string(),
            other => other.to_string(),
        }
    }
}
