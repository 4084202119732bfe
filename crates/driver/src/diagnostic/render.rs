//! Reports as text, in the form of rustc: reason, place, the line with a caret, hint.

use std::ops::Range;

use super::excerpt::{Excerpt, clip, escape};
use super::locate::{line_and_column, locate};
use super::{Diagnostic, Report, Severity, without_comments};

/// Most faults of a report that are shown.
const SHOWN: usize = 100;
/// Longest path that is shown whole.
const PATH: usize = 100;
/// Columns at which a hint is wrapped.
const WIDTH: usize = 100;
const BOLD: &str = "1";
const RED: &str = "1;31";
const YELLOW: &str = "1;33";
const CYAN: &str = "36";

impl Report {
    /// The whole report: errors in the order of the file, then warnings, then a count if several.
    pub fn render(&self, color: bool) -> String {
        // Nobody reads more, and to find the places of very many takes long.
        let mut shown: Vec<_> = self.diagnostics.iter().collect();
        shown.sort_by_key(|d| d.severity);
        shown.truncate(SHOWN);
        let mut located: Vec<_> = shown.into_iter().map(|d| (self.span(d), d)).collect();
        let start = |span: &Option<Range<usize>>| span.as_ref().map_or(usize::MAX, |s| s.start);
        located.sort_by_key(|(span, diagnostic)| (diagnostic.severity, start(span)));
        let mut parts: Vec<_> = located.into_iter().map(|(s, d)| self.one(d, s, color)).collect();
        if parts.len() > 1 {
            let rest = if parts.len() < self.diagnostics.len() {
                format!(", {SHOWN} are shown")
            } else {
                String::new()
            };
            parts.push(format!("{} in {}{rest}\n", self.count(), escape(&self.file)));
        }
        parts.join("\n")
    }

    /// Line and column of a fault of this report, both from 1; `None` without a source.
    pub fn line_and_column(&self, diagnostic: &Diagnostic) -> Option<(usize, usize)> {
        let span = self.span(diagnostic)?;
        Some(line_and_column(&self.text, span.start))
    }

    fn span(&self, diagnostic: &Diagnostic) -> Option<Range<usize>> {
        let by_path = || {
            let plain = without_comments(&self.text);
            locate(&plain, &diagnostic.path).map(|place| place.span(&plain))
        };
        let span = diagnostic.span.clone().or_else(by_path)?;
        (!self.text.is_empty() && self.text.get(span.clone()).is_some()).then_some(span)
    }

    fn count(&self) -> String {
        let errors = self.diagnostics.iter().filter(|d| d.severity == Severity::Error).count();
        let warnings = self.diagnostics.len() - errors;
        let words = [(errors, "error"), (warnings, "warning")].into_iter().filter(|(n, _)| *n > 0);
        let words = words.map(|(n, word)| format!("{n} {word}{}", if n == 1 { "" } else { "s" }));
        words.collect::<Vec<_>>().join(" and ")
    }

    /// One fault, with a line break at its end.
    fn one(&self, diagnostic: &Diagnostic, span: Option<Range<usize>>, color: bool) -> String {
        let paint = |code: &str, text: &str| match color {
            true => format!("\x1b[{code}m{text}\x1b[0m"),
            false => text.to_string(),
        };
        let alarm = match diagnostic.severity {
            Severity::Error => RED,
            Severity::Warning => YELLOW,
        };
        let severity = paint(alarm, &diagnostic.severity.to_string());
        let mut lines = vec![format!("{severity}: {}", paint(BOLD, &escape(&diagnostic.message)))];

        let place = span.map(|span| (line_and_column(&self.text, span.start), span));
        let gutter = " ".repeat(1 + place.as_ref().map_or(1, |((n, _), _)| n.to_string().len()));
        let mut at = format!("{gutter}{} {}", paint(CYAN, "-->"), escape(&self.file));
        if let Some(((line, column), _)) = place {
            at += &format!(":{line}:{column}");
        }
        if !diagnostic.path.is_root() {
            at += &format!(", at `{}`", clip(&diagnostic.path.to_string(), PATH));
        }
        lines.push(at);
        if let Some(((line, _), span)) = place {
            let excerpt = Excerpt::new(&self.text, span);
            let bar = paint(CYAN, "|");
            let indent = " ".repeat(excerpt.indent);
            lines.push(format!("{gutter} {bar}"));
            lines.push(format!(" {} {bar} {}", paint(CYAN, &line.to_string()), excerpt.line));
            let carets = paint(alarm, &"^".repeat(excerpt.carets));
            lines.push(format!("{gutter} {bar} {indent}{carets}"));
        }
        if let Some(hint) = &diagnostic.hint {
            lines.push(format!("{}: {}", paint(CYAN, "hint"), wrap(&escape(hint))));
        }
        lines.join("\n") + "\n"
    }
}

/// Breaks a long hint between words; further lines stand below its first word.
fn wrap(text: &str) -> String {
    let indent = "hint: ".len();
    let mut out = String::new();
    let mut column = indent;
    for (position, word) in text.split(' ').enumerate() {
        let length = 1 + word.chars().count();
        if position > 0 && column + length > WIDTH {
            out += &format!("\n{:indent$}", "");
            column = indent;
        } else if position > 0 {
            out.push(' ');
        }
        out.push_str(word);
        column += length;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Faults;

    const TEXT: &str = "{\n  \"title\": \"x\",\n\n\n\n\n  \"horizon_ratio\": 0.5,\n  \"cells\": 0\n}\n";

    fn one(text: &str, path: &'static str) -> String {
        let mut faults = Faults::default();
        faults.error(path, "wrong");
        faults.into_report("x.json", text).to_string()
    }

    #[test]
    fn one_error_has_reason_place_caret_and_hint() {
        let mut faults = Faults::default();
        let message = "`horizon_ratio` must be at least 1, found 0.5";
        faults.error("horizon_ratio", message).hint("use 3, the usual choice");
        let expected = "\
error: `horizon_ratio` must be at least 1, found 0.5
  --> cases/x.json:7:20, at `horizon_ratio`
   |
 7 |   \"horizon_ratio\": 0.5,
   |                    ^^^
hint: use 3, the usual choice
";
        let report = faults.into_report("cases/x.json", TEXT);
        assert_eq!(report.render(false), expected);
        assert_eq!(report.line_and_column(&report.diagnostics[0]), Some((7, 20)));
    }

    #[test]
    fn errors_come_in_the_order_of_the_file_then_warnings_then_a_count() {
        let mut faults = Faults::default();
        faults.warning("title", "third");
        faults.error("cells", "second");
        faults.error("horizon_ratio", "first");
        let text = faults.into_report("x.json", TEXT).to_string();
        let order: Vec<_> = ["first", "second", "warning: third", "2 errors and 1 warning in x.json"]
            .iter()
            .map(|word| text.find(word).unwrap())
            .collect();
        assert!(order.is_sorted(), "{text}");
        assert_eq!(text.matches("\n\n").count(), 3, "an empty line between them\n{text}");
    }

    #[test]
    fn a_case_without_source_names_file_and_path_only() {
        assert_eq!(one("", "a.b"), "error: wrong\n  --> x.json, at `a.b`\n");
    }

    #[test]
    fn colour_is_only_added() {
        let mut faults = Faults::default();
        faults.error("cells", "wrong").hint("use 1");
        let report = faults.into_report("x.json", TEXT);
        let colored = report.render(true);
        assert!(colored.starts_with("\x1b[1;31merror\x1b[0m: "), "{colored:?}");
        let plain = ["\x1b[1;31m", "\x1b[36m", "\x1b[1m", "\x1b[0m"]
            .iter()
            .fold(colored, |text, code| text.replace(code, ""));
        assert_eq!(plain, report.render(false));
    }

    #[test]
    fn long_hints_are_wrapped() {
        let names: Vec<_> = (0..40).map(|i| format!("`name_{i}`")).collect();
        let wrapped = wrap(&names.join(", "));
        assert!(wrapped.lines().count() > 3 && wrapped.lines().all(|line| line.len() <= WIDTH), "{wrapped}");
    }
}
