//! User text made fit for a terminal: escaped, cut, and with the carets in the right columns.

use std::ops::Range;

/// Characters of a source line that are shown; a minified file is one line.
const WINDOW: usize = 100;
/// Of these, how many may stand before the fault when the line is cut.
const BEFORE: usize = 40;
/// Longest piece of user text that a message quotes.
const QUOTE: usize = 60;

/// The part of a line that is shown, and where the carets stand below it.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Excerpt {
    pub(super) line: String,
    pub(super) indent: usize,
    pub(super) carets: usize,
}

impl Excerpt {
    /// The line of `span`, which lies on one line of `text`.
    pub(super) fn new(text: &str, span: Range<usize>) -> Self {
        let (before, after) = text.split_at(span.start);
        // Of a line of 100 MB only as many characters are read as can be shown.
        let before = before.chars().rev().take(WINDOW + 1).take_while(|c| *c != '\n');
        let mut before: Vec<_> = before.collect();
        let after = after.char_indices().take(WINDOW + 1).take_while(|(_, c)| !"\r\n".contains(*c));
        let after: Vec<_> = after.collect();
        // What the one side does not need is left to the other.
        let kept = before.len().min(BEFORE.max(WINDOW.saturating_sub(after.len())));

        let mut line = if kept < before.len() { "..." } else { "" }.to_string();
        before.truncate(kept);
        line.extend(before.into_iter().rev().map(visible));
        let indent = line.chars().count();
        let mut carets = 0;
        for &(offset, c) in after.iter().take(WINDOW - kept) {
            let cell = visible(c);
            if span.start + offset < span.end {
                carets += cell.chars().count();
            }
            line.push_str(&cell);
        }
        if after.len() > WINDOW - kept {
            line.push_str("...");
        }
        Excerpt { line, indent, carets: carets.max(1) }
    }
}

/// User text in a message: escaped, and cut after `limit` characters.
pub fn clip(text: &str, limit: usize) -> String {
    match text.char_indices().nth(limit) {
        Some((end, _)) => escape(&text[..end]) + "...",
        None => escape(text),
    }
}

/// User text between backticks, for a message.
pub fn quote(text: &str) -> String {
    format!("`{}`", clip(text, QUOTE))
}

/// User text with its control characters made visible.
pub(super) fn escape(text: &str) -> String {
    text.replace('\t', "\\t").chars().map(visible).collect()
}

/// A character as it may reach a terminal: nothing that moves the cursor, colours or reverses text.
fn visible(c: char) -> String {
    let unseen = ['\u{200B}'..='\u{200F}', '\u{202A}'..='\u{202E}', '\u{2060}'..='\u{2069}'];
    match c {
        '\t' => "    ".to_string(),
        '\u{FEFF}' => c.escape_unicode().to_string(),
        _ if unseen.iter().any(|range| range.contains(&c)) => c.escape_unicode().to_string(),
        _ if c.is_control() => c.escape_default().to_string(),
        _ => c.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The excerpt of `word` in `text`, and the text above the carets.
    fn excerpt(text: &str, word: &str) -> (Excerpt, String) {
        let start = text.find(word).unwrap();
        let excerpt = Excerpt::new(text, start..start + word.len());
        let marked = excerpt.line.chars().skip(excerpt.indent).take(excerpt.carets).collect();
        (excerpt, marked)
    }

    #[test]
    fn a_long_line_is_cut_around_the_caret() {
        let filler = "1, ".repeat(400_000);
        let (cut, marked) = excerpt(&format!("[{filler}\"bad\", {filler}]"), "\"bad\"");
        assert_eq!((marked.as_str(), cut.indent), ("\"bad\"", BEFORE + 3));
        assert_eq!(cut.line.chars().count(), WINDOW + 6, "both ends carry three points");
        assert!(cut.line.starts_with("...") && cut.line.ends_with("..."));
        let long = "é".repeat(100_000);
        let (cut, _) = excerpt(&long, &long);
        assert_eq!((cut.indent, cut.carets), (0, WINDOW));
        let (end, _) = excerpt(&format!("{filler}x"), "x");
        assert_eq!((end.line.chars().count(), end.indent), (WINDOW + 3, WINDOW + 2));
    }

    #[test]
    fn tabs_letters_and_line_ends_keep_the_caret_in_place() {
        let text = "{\r\n\t\"ключ\": \"é\u{7}\",\r\n}";
        let (shown, marked) = excerpt(text, "\"é\u{7}\"");
        assert_eq!(shown.line, "    \"ключ\": \"é\\u{7}\",");
        // 4 columns for the tab, 8 for the key with its colon; the bell is shown in 5.
        assert_eq!((shown.indent, marked.as_str()), (12, "\"é\\u{7}\""));
        let end = Excerpt::new("ab\n", 2..2);
        assert_eq!(end, Excerpt { line: "ab".to_string(), indent: 2, carets: 1 });
    }

    #[test]
    fn user_text_cannot_drive_the_terminal() {
        assert_eq!(quote("x\u{1b}[31m\u{202e}\n\ty"), "`x\\u{1b}[31m\\u{202e}\\n\\ty`");
        assert_eq!(clip(&"y".repeat(99), 3), "yyy...");
        assert_eq!(clip("yyy", 3), "yyy");
    }
}
