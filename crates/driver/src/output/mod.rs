//! Writers of files: tables, fields, diagrams. No physics and no printing.
//!
//! Each file appears whole or not at all ([`atomic`]), so a run that is interrupted leaves no torn file
//! behind: rows of numbers as [`csv`], fields on points and cells as [`vtu`], a series of them over time as
//! [`pvd`], lines over lines as [`plot`], and pages for people as [`report`]. [`lock`] keeps two
//! processes apart. The callers choose what is worth writing; a length that does not fit is a broken contract and panics.

pub mod atomic;
pub mod csv;
pub mod folder;
pub mod lock;
pub mod matrix_market;
pub mod plot;
pub mod pvd;
pub mod report;
pub mod vtu;

/// Text as the content of an XML attribute.
pub fn xml(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            // As themselves they would be blanks in an attribute.
            '\n' => out.push_str("&#10;"),
            '\t' => out.push_str("&#9;"),
            // XML 1.0 has no form for these, not even escaped.
            c if c.is_control() || matches!(c, '\u{FFFE}' | '\u{FFFF}') => out.push('\u{FFFD}'),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    #[test]
    fn names_are_escaped_for_xml() {
        assert_eq!(super::xml("a<b & \"c\">\u{0}ñ"), "a&lt;b &amp; &quot;c&quot;&gt;\u{FFFD}ñ");
        assert_eq!(super::xml("a\tb\nc"), "a&#9;b&#10;c");
    }
}
