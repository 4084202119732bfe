//! From a path to the bytes it names, in the text as the user wrote it.
//!
//! A small walk over the tokens, since no value type of `serde_json` remembers positions. It keeps a depth
//! instead of recursing, so a document may be nested without limit, and it expects valid JSON but only
//! loses precision without it.

use std::ops::Range;

use super::path::{JsonPath, Segment};

/// Where a path, or its nearest parent that is written, stands in the text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// The key of the value with its quotes, if it is the member of an object.
    pub key: Option<Range<usize>>,
    /// The whole value.
    pub value: Range<usize>,
    /// Whether this is the value itself; otherwise a parent of it.
    pub exact: bool,
}

impl Place {
    /// What to underline: a whole scalar; of an object or list its key, or else its first character.
    pub fn span(&self, text: &str) -> Range<usize> {
        match (&self.key, text.as_bytes().get(self.value.start)) {
            (Some(key), Some(b'{' | b'[')) => key.clone(),
            (None, Some(b'{' | b'[')) => self.value.start..self.value.start + 1,
            _ => self.value.clone(),
        }
    }
}

/// Finds `path` in `text`; for a value that is not written (a default) its nearest parent. `None` for an
/// empty text.
pub fn locate(text: &str, path: &JsonPath) -> Option<Place> {
    let bytes = text.as_bytes();
    let mut key = None;
    let mut start = skip_space(bytes, 0);
    let mut exact = start < bytes.len();
    if !exact {
        return None;
    }
    for segment in &path.0 {
        let next = match segment {
            Segment::Key(name) => member(text, start, name).map(|(key, value)| (Some(key), value)),
            Segment::Index(index) => element(bytes, start, *index).map(|value| (None, value)),
        };
        match next {
            Some(found) => (key, start) = found,
            None => {
                exact = false;
                break;
            }
        }
    }
    Some(Place { key, value: start..end_of_value(bytes, start), exact })
}

/// Line and column of a byte, both from 1; a column is a character.
pub fn line_and_column(text: &str, offset: usize) -> (usize, usize) {
    let before = &text.as_bytes()[..offset.min(text.len())];
    let start = before.iter().rposition(|&b| b == b'\n').map_or(0, |newline| newline + 1);
    let line = 1 + before[..start].iter().filter(|&&b| b == b'\n').count();
    // Continuation bytes of UTF-8 begin with the bits 10.
    (line, 1 + before[start..].iter().filter(|&&b| b & 0xC0 != 0x80).count())
}

/// The key with its quotes and the start of the value of `name` in the object that begins at `start`.
fn member(text: &str, start: usize, name: &str) -> Option<(Range<usize>, usize)> {
    let bytes = text.as_bytes();
    let mut at = skip_space(bytes, opening(bytes, start, b'{')?);
    loop {
        let key = opening(bytes, at, b'"').map(|_| at..end_of_string(bytes, at))?;
        let value = skip_space(bytes, opening(bytes, skip_space(bytes, key.end), b':')?);
        let written = text.get(key.start + 1..key.end - 1)?;
        // Only a key with an escape needs decoding.
        if written == name
            || written.contains('\\')
                && serde_json::from_str::<String>(&text[key.clone()]).ok().as_deref() == Some(name)
        {
            return Some((key, value));
        }
        at = skip_space(bytes, opening(bytes, skip_space(bytes, end_of_value(bytes, value)), b',')?);
    }
}

/// The start of element `index` in the list that begins at `start`.
fn element(bytes: &[u8], start: usize, index: usize) -> Option<usize> {
    let mut at = skip_space(bytes, opening(bytes, start, b'[')?);
    for _ in 0..index {
        at = skip_space(bytes, opening(bytes, skip_space(bytes, end_of_value(bytes, at)), b',')?);
    }
    (at < bytes.len() && bytes[at] != b']').then_some(at)
}

/// The place behind `sign`, if it stands at `at`.
fn opening(bytes: &[u8], at: usize, sign: u8) -> Option<usize> {
    (bytes.get(at) == Some(&sign)).then_some(at + 1)
}

fn skip_space(bytes: &[u8], at: usize) -> usize {
    (at..bytes.len()).find(|&i| !b" \t\r\n".contains(&bytes[i])).unwrap_or(bytes.len())
}

/// The end of the string that opens at `at`.
fn end_of_string(bytes: &[u8], at: usize) -> usize {
    let mut i = at + 1;
    while i < bytes.len() {
        match bytes[i] {
            b'"' => return i + 1,
            b'\\' => i += 2,
            _ => i += 1,
        }
    }
    bytes.len()
}

/// The end of the value that begins at `at`.
fn end_of_value(bytes: &[u8], at: usize) -> usize {
    let mut depth = 0_usize;
    let mut i = at;
    while i < bytes.len() {
        match bytes[i] {
            b'{' | b'[' => depth += 1,
            b'}' | b']' if depth <= 1 => return if depth == 1 { i + 1 } else { i },
            b'}' | b']' => depth -= 1,
            b'"' => {
                i = end_of_string(bytes, i);
                if depth == 0 {
                    return i;
                }
                continue;
            }
            b',' | b' ' | b'\t' | b'\r' | b'\n' if depth == 0 => return i,
            _ => {}
        }
        i += 1;
    }
    bytes.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r#"{ "title": "a \"}\" b", "model": { "beam": { "length": 1.5e0 } },
  "supports": [ { "at": {"x": 0} }, [ 1, [2 , 3] ] ], "sch\u00f6n": null, "empty": [] }"#;

    /// The underlined text, and whether it is the value itself.
    fn at(path: &'static str) -> (&'static str, bool) {
        let place = locate(TEXT, &path.into()).unwrap();
        (&TEXT[place.span(TEXT)], place.exact)
    }

    #[test]
    fn a_scalar_is_underlined_whole_and_an_object_by_its_key() {
        assert_eq!(at("title"), (r#""a \"}\" b""#, true));
        assert_eq!(at("model.beam.length"), ("1.5e0", true));
        assert_eq!(at("model.beam"), ("\"beam\"", true));
        assert_eq!(at("supports[0]"), ("{", true));
        assert_eq!(at("supports[1][1][1]"), ("3", true));
        assert_eq!(at("schön"), ("null", true));
        assert_eq!(at(""), ("{", true));
    }

    #[test]
    fn a_default_is_located_at_its_nearest_written_parent() {
        assert_eq!(at("model.beam.width.x"), ("\"beam\"", false));
        assert_eq!(at("supports[0].at.y"), ("\"at\"", false));
        assert_eq!(at("supports[2]"), ("\"supports\"", false));
        assert_eq!(at("empty[0]"), ("\"empty\"", false));
        assert_eq!(at("title.x"), (r#""a \"}\" b""#, false));
        assert_eq!(at("nothing"), ("{", false));
    }

    #[test]
    fn deep_nesting_and_broken_text_do_no_harm() {
        let deep = format!("{{\"a\": {}{}, \"b\": 1}}", "[".repeat(300_000), "]".repeat(300_000));
        let place = locate(&deep, &"b".into()).unwrap();
        assert_eq!((&deep[place.value], place.exact), ("1", true));
        for text in ["{\"a", "{\"", "{\"a\\", "{\"a\":", "[1,", "[", "}", "{\"é"] {
            for path in ["a", "[1]", "a.b"] {
                assert!(!locate(text, &path.into()).unwrap().exact || text == "{\"a\":", "{text} {path}");
            }
        }
        assert_eq!(locate(" \n", &"a".into()), None);
    }

    #[test]
    fn columns_count_characters() {
        assert_eq!(line_and_column("ab\nñ\tx", 0), (1, 1));
        assert_eq!(line_and_column("ab\nñ\tx", 6), (2, 3), "ñ is two bytes and one character");
        assert_eq!(line_and_column("ab\n", 3), (2, 1));
    }
}
