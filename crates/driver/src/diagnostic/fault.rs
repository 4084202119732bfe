//! Faults and their reports.

use super::path::JsonPath;
use std::collections::HashSet;
use std::fmt;
use std::ops::Range;

/// How much a fault weighs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The case cannot be run.
    Error,
    /// The case can be run, but probably does not say what was meant.
    Warning,
}

impl fmt::Display for Severity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Severity::Error => "error",
            Severity::Warning => "warning",
        })
    }
}

/// One fault: reason, place, hint.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// Error or warning.
    pub severity: Severity,
    /// One line of reason, without a final period.
    pub message: String,
    /// The value at fault; empty for the whole case.
    pub path: JsonPath,
    /// Bytes of the text to underline where the path does not say it well: a syntax error, a misspelt key.
    pub span: Option<Range<usize>>,
    /// What to do about it.
    pub hint: Option<String>,
    /// Whether the case is refused only because it needs more memory than it may use.
    pub lacks_memory: bool,
    /// Whether it is an error only for who solves the case: its stiffness can be built.
    pub in_solution_only: bool,
}

impl Diagnostic {
    /// An error at `path`, without a hint.
    pub fn error(path: impl Into<JsonPath>, message: impl Into<String>) -> Self {
        Diagnostic {
            severity: Severity::Error,
            message: message.into(),
            path: path.into(),
            span: None,
            hint: None,
            lacks_memory: false,
            in_solution_only: false,
        }
    }

    /// Says that only memory is lacking.
    pub fn for_lack_of_memory(&mut self) -> &mut Self {
        self.lacks_memory = true;
        self
    }

    /// Says that the stiffness can be built all the same.
    pub fn in_solution_only(&mut self) -> &mut Self {
        self.in_solution_only = true;
        self
    }

    /// Says what to do about it.
    pub fn hint(&mut self, hint: impl Into<String>) -> &mut Self {
        self.hint = Some(hint.into());
        self
    }
}

/// Collects the faults of one case, so that they come in one report.
///
/// ```
/// # use peristat::diagnostic::{Faults, JsonPath};
/// let mut faults = Faults::default();
/// let model = JsonPath::default().key("model");
/// faults.error(model.key("length"), "`length` must be positive, found 0").hint("lengths are in metres");
/// assert!(faults.has_errors());
/// ```
#[derive(Debug, Clone, Default)]
pub struct Faults {
    diagnostics: Vec<Diagnostic>,
}

impl Faults {
    /// Adds an error; the answer takes a hint.
    pub fn error(&mut self, path: impl Into<JsonPath>, message: impl Into<String>) -> &mut Diagnostic {
        self.add(Diagnostic::error(path, message))
    }

    /// Adds a warning; the answer takes a hint.
    pub fn warning(&mut self, path: impl Into<JsonPath>, message: impl Into<String>) -> &mut Diagnostic {
        self.add(Diagnostic { severity: Severity::Warning, ..Diagnostic::error(path, message) })
    }

    /// Adds those of others.
    pub fn append(&mut self, others: Faults) {
        self.diagnostics.extend(others.diagnostics);
    }

    fn add(&mut self, diagnostic: Diagnostic) -> &mut Diagnostic {
        self.diagnostics.push(diagnostic);
        self.diagnostics.last_mut().expect("one was pushed in the line above")
    }

    /// Moves faults to other places, where `place` has one for theirs.
    pub fn relocate(&mut self, place: impl Fn(&JsonPath) -> Option<JsonPath>) {
        for diagnostic in &mut self.diagnostics {
            if let Some(path) = place(&diagnostic.path) {
                diagnostic.path = path;
            }
        }
    }

    /// Whether there is no scene of the case.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|d| d.severity == Severity::Error && !d.in_solution_only)
    }

    /// Why a scene that there is has no solution.
    pub(crate) fn obstacles(&self) -> Option<Self> {
        let obstacles = self.diagnostics.iter().filter(|d| d.in_solution_only).cloned();
        let diagnostics: Vec<Diagnostic> = obstacles.collect();
        (!diagnostics.is_empty()).then_some(Self { diagnostics })
    }

    /// Number of errors so far.
    pub fn errors(&self) -> usize {
        self.diagnostics.iter().filter(|d| d.severity == Severity::Error).count()
    }

    /// Whether nothing was found.
    pub fn is_empty(&self) -> bool {
        self.diagnostics.is_empty()
    }

    /// The report on `file`, whose source is `text` (empty if it has none). A fault that many lines of a body share is
    /// reported once.
    pub fn into_report(mut self, file: impl Into<String>, text: impl Into<String>) -> Report {
        let mut told = HashSet::new();
        self.diagnostics.retain(|d| told.insert((d.path.to_string(), d.message.clone())));
        Report { file: file.into(), text: text.into(), diagnostics: self.diagnostics }
    }
}

/// All faults of one case, or its one syntax error. `Display` is [`Report::render`] without colour.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Report {
    /// The file, as the user wrote it.
    pub file: String,
    /// Its source; empty if there is none.
    pub text: String,
    /// The faults, in any order.
    pub diagnostics: Vec<Diagnostic>,
}

impl Report {
    /// The report of a single fault.
    pub(crate) fn of(file: &str, text: impl Into<String>, diagnostic: Diagnostic) -> Self {
        Report { file: file.to_string(), text: text.into(), diagnostics: vec![diagnostic] }
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.render(false))
    }
}

impl std::error::Error for Report {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_are_collected_with_severity_and_hint() {
        let mut faults = Faults::default();
        assert!(faults.is_empty());
        faults.warning("units", "a label only");
        assert!(!faults.has_errors(), "a warning alone lets the case run");
        faults.error("model.length", "must be positive").hint("use 1");
        assert!(faults.has_errors());
        let report = faults.into_report("a.json", "{}");
        assert_eq!(report.diagnostics[0].severity, Severity::Warning);
        assert_eq!(report.diagnostics[1].hint.as_deref(), Some("use 1"));
        assert_eq!(report.diagnostics[1].path.to_string(), "model.length");
    }
}
