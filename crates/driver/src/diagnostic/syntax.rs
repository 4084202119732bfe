//! Faults of syntax in plain words.

use std::ops::Range;

use super::Diagnostic;
use super::excerpt::quote;
use super::path::JsonPath;

const NUMBER: &str = "a number has digits on both sides of its point, no leading zero and no `+`";
const COMMENT: &str = "a comment is `// to the end of the line` or `/* closed */`";
const COMMA: &str = "is a comma missing before it?";

/// The diagnostic of an error that `serde_json` calls syntax or end of file.
pub(super) fn diagnose(text: &str, error: &serde_json::Error) -> Diagnostic {
    let end = text.trim_end().len();
    let full = error.to_string();
    let raw = full.rfind(" at line ").map_or(full.as_str(), |end| &full[..end]);
    let mut at = offset(text, error.line(), error.column());
    if matches!(raw, "invalid number" | "expected ident") && !text[at..].starts_with(in_word) {
        // `1.` and `tru` are found wanting only at the sign behind them.
        at = at.saturating_sub(1);
    }
    let mut span = word(text, at);
    let (message, hint) = if is_yaml(text) {
        span = start_of(text);
        (
            "this is YAML, not JSON",
            "a case is one object, `{ \"title\": \"…\", … }`: `peristat new MODEL` prints one",
        )
    } else if end == 0 {
        span = 0..0;
        ("the file is empty", "`peristat new MODEL` prints a case to begin with")
    } else if error.is_eof() || raw == "invalid number" && span.end == end {
        span = end..end;
        (cut_off(raw), "is it cut off, or is a closing bracket missing?")
    } else {
        words(raw, &text[span.clone()])
    };
    let message = if message.is_empty() { raw } else { message };
    let message = message.replace("{}", &quote(&text[span.clone()]));
    let mut diagnostic = Diagnostic::error(JsonPath::default(), message);
    diagnostic.hint = (!hint.is_empty()).then(|| hint.to_string());
    diagnostic.span = Some(span);
    diagnostic
}

/// Whether a text begins with `---`, an item of a list, or a key without quotes and brackets around it.
fn is_yaml(text: &str) -> bool {
    let mut lines = text.lines().map(str::trim_end).filter(|l| !l.is_empty() && !l.starts_with('#'));
    let first = lines.next().unwrap_or_default();
    let key = first.split_once(':').filter(|(_, value)| value.is_empty() || value.starts_with(' '));
    let is_key = |key: &str| key.starts_with(char::is_alphabetic) && key.chars().all(in_word);
    first == "---" || first.starts_with("- ") || key.is_some_and(|(key, _)| is_key(key))
}

/// The first word of a text.
fn start_of(text: &str) -> Range<usize> {
    word(text, text.len() - text.trim_start().len())
}

fn cut_off(raw: &str) -> &'static str {
    match raw {
        "EOF while parsing a list" => "the file ends too early, inside a list",
        "EOF while parsing an object" => "the file ends too early, inside an object",
        "EOF while parsing a string" => "the file ends too early, inside a string",
        "invalid number" => "the file ends too early, inside a number",
        _ => "the file ends too early, before a value",
    }
}

/// A message with `{}` for the word found, and a hint or an empty text.
fn words(raw: &str, found: &str) -> (&'static str, &'static str) {
    let is_comment = ["/", "#"].contains(&found);
    match raw {
        "expected value" | "expected ident" => value_words(found),
        "invalid number" => ("{} is not a JSON number", NUMBER),
        "number out of range" => ("number out of range: {}", "the largest is about 1.8e308"),
        "expected `:`" if is_comment => ("expected `:` after a key, found {}", COMMENT),
        "expected `,` or `}`" if is_comment => ("expected `,` or `}`, found {}", COMMENT),
        "expected `,` or `]`" if is_comment => ("expected `,` or `]`, found {}", COMMENT),
        "trailing characters" if is_comment => ("text after the end of the case", COMMENT),
        "expected `:`" => ("expected `:` after a key, found {}", ""),
        "expected `,` or `}`" => ("expected `,` or `}`, found {}", COMMA),
        "expected `,` or `]`" => ("expected `,` or `]`, found {}", COMMA),
        "key must be a string" if is_comment => ("expected a key, found {}", COMMENT),
        "key must be a string" => ("a key must stand in double quotes", ""),
        "trailing characters" => ("text after the end of the case", "a bracket too many?"),
        "invalid escape" => ("invalid escape in a string", "a backslash is written `\\\\`"),
        "recursion limit exceeded" => ("nested too deeply", "the limit is 127 levels"),
        _ if raw.starts_with("control character") => {
            ("a line break or control character inside a string", "is the closing `\"` missing?")
        }
        _ => ("", ""),
    }
}

/// Where a value should stand and something else does.
fn value_words(found: &str) -> (&'static str, &'static str) {
    let number = found.trim_start_matches(['-', '+']);
    let not_finite = ["nan", "inf", "infinity"].contains(&number.to_lowercase().as_str());
    match found {
        "}" | "]" | "," | ":" => ("a value is missing before {}", ""),
        "'" => ("expected a value, found {}", "strings stand in double quotes"),
        "/" | "#" => ("expected a value, found {}", COMMENT),
        _ if not_finite => ("{} is not a JSON number", "write a finite number"),
        _ if number.starts_with(|c: char| c == '.' || c.is_ascii_digit()) => {
            ("{} is not a JSON number", NUMBER)
        }
        _ => ("{} is not a JSON value", "a text stands in double quotes"),
    }
}

/// The byte of a position of `serde_json`: columns are bytes from 1, and 0 is the line break before the line.
pub(super) fn offset(text: &str, line: usize, column: usize) -> usize {
    let breaks = text.bytes().enumerate().filter(|(_, b)| *b == b'\n').map(|(at, _)| at + 1);
    let start = std::iter::once(0).chain(breaks).nth(line.saturating_sub(1)).unwrap_or(text.len());
    let at = (start + column).saturating_sub(1).min(text.len());
    (0..=at).rfind(|&i| text.is_char_boundary(i)).unwrap_or(0)
}

fn in_word(c: char) -> bool {
    c.is_alphanumeric() || "_+-.".contains(c)
}

/// The word or number around a byte, or the one character there.
fn word(text: &str, at: usize) -> Range<usize> {
    match text[at..].find(|c| !in_word(c)).unwrap_or(text.len() - at) {
        0 => at..at + text[at..].chars().next().map_or(0, char::len_utf8),
        length => text[..at].trim_end_matches(in_word).len()..at + length,
    }
}

#[cfg(test)]
mod tests {
    use super::super::parse;
    use super::super::parse::tests::{Case, GOOD, check, fault};

    #[test]
    fn each_fault_of_syntax_is_told_in_plain_words_at_its_place() {
        check(
            r#"
            : 3, => : NaN, | `NaN` is not a JSON number | NaN
            : 3, => : -Infinity, | `-Infinity` is not a JSON number | -Infinity
            : 3, => : 1e999, | number out of range: `1e999` | 1e999
            : 3, => : .5, | `.5` is not a JSON number | .5
            : 3, => : 05, | `05` is not a JSON number | 05
            : 3, => : 1., | `1.` is not a JSON number | 1.
            : 3, => : +3, | `+3` is not a JSON number | +3
            : 3, => : True, | `True` is not a JSON value | True
            : 3, => : tru, | `tru` is not a JSON value | tru
            : 3, => : , | a value is missing before `,` | ,
            : 3, => : 'a', | expected a value, found `'` | '
            : 3, => : # no comment | expected a value, found `#` | #
            : 3, => : /* no end | expected a value, found `/` | / | a comment is `// to the end of the line` or `/* closed */`
            : 3, => : 3 # a | expected `,` or `}`, found `#` | # | a comment is `// to the end of the line` or `/* closed */`
            "a" } => "a" } /* a | text after the end of the case | / | a comment is `// to the end of the line` or `/* closed */`
            "cells" => cells | a key must stand in double quotes | cells
            : 3, => 3, | expected `:` after a key, found `3` | 3
            3, "cells" => 3 "cells" | expected `,` or `}`, found `"` | "
            0, 1] => 0 1] | expected `,` or `]`, found `1` | 1
            0, 1] => 0, 1,, ] | a value is missing before `,` | ,
            [0, 0, 1] => [,] | a value is missing before `,` | ,
            : 8, => : 8,, | a key must stand in double quotes | ,
            "a" } => "a" } x | text after the end of the case | x
            "a" } => "a\q" } | invalid escape in a string | q
            "#,
        );
        let (message, ..) = fault("\"a\"", "\"a\n\"");
        assert_eq!(message, "a line break or control character inside a string");
    }

    #[test]
    fn an_empty_or_truncated_file_is_named_so() {
        let message = |text: &str| parse::<Case>("x.json", text).unwrap_err().diagnostics[0].message.clone();
        assert_eq!(message(" \n "), "the file is empty");
        assert_eq!(message(""), "the file is empty");
        assert_eq!(message("{"), "the file ends too early, inside an object");
        assert_eq!(message("{\"model\":"), "the file ends too early, before a value");
        assert_eq!(message("{\"title\": \"ab"), "the file ends too early, inside a string");
        assert_eq!(message("[1, "), "the file ends too early, before a value");
        // Every proper prefix of a good case is a fault and never a panic.
        for end in 1..GOOD.len() - 1 {
            assert!(message(&GOOD[..end]).starts_with("the file ends too early"), "{end}: {}", &GOOD[..end]);
        }
    }

    #[test]
    fn yaml_is_named_so() {
        let message = |text: &str| parse::<Case>("x.json", text).unwrap_err().diagnostics[0].message.clone();
        for text in ["title: a\nmodel:\n  x: 1\n", "---\ntitle: a\n", "# a\n\nmodel:\n", "- a\n"] {
            assert_eq!(message(text), "this is YAML, not JSON", "{text}");
        }
        for text in ["{ title: 3 }", "\"title\": 3", "-1 x", "title"] {
            assert_ne!(message(text), "this is YAML, not JSON", "{text}");
        }
    }

    #[test]
    fn the_place_of_a_truncation_is_the_end_of_the_text() {
        let report = parse::<Case>("x.json", "{\n  \"cells\": \n\n").unwrap_err();
        assert_eq!(report.line_and_column(&report.diagnostics[0]), Some((2, 11)));
    }

    #[test]
    fn nesting_beyond_the_limit_is_no_overflow() {
        for depth in [200, 200_000] {
            let deep =
                format!("{}{}, \"more\": {{ \"timoshenko_beam\"", "[".repeat(depth), "]".repeat(depth));
            let (message, ..) = fault("{ \"timoshenko_beam\"", &deep);
            assert_eq!(message, "nested too deeply");
        }
    }
}
