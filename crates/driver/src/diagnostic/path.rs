//! The address of a value in a JSON document: `supports[0].at.x`.

use std::fmt;
use std::str::FromStr;

/// One step into a document.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Segment {
    /// The value of a key.
    Key(String),
    /// An element of a list, from zero.
    Index(usize),
}

/// A way from the root to a value; empty is the root.
///
/// Written `a.b[0].c`; a key that is empty or holds `.`, `[`, `]`, `"` or a control character is written
/// `["…"]`, as a JSON string. `Display` and `FromStr` are inverse to each other.
#[derive(Debug, Clone, Default, PartialEq, Eq, Hash)]
pub struct JsonPath(pub Vec<Segment>);

impl JsonPath {
    /// The value of `key` in the object at this path.
    pub fn key(&self, key: impl Into<String>) -> JsonPath {
        self.child(Segment::Key(key.into()))
    }

    /// Element `index` of the list at this path.
    pub fn index(&self, index: usize) -> JsonPath {
        self.child(Segment::Index(index))
    }

    fn child(&self, segment: Segment) -> JsonPath {
        JsonPath(self.0.iter().cloned().chain([segment]).collect())
    }

    /// Whether this is the whole document.
    pub fn is_root(&self) -> bool {
        self.0.is_empty()
    }
}

impl fmt::Display for JsonPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (position, segment) in self.0.iter().enumerate() {
            match segment {
                Segment::Index(index) => write!(f, "[{index}]")?,
                Segment::Key(key) if !is_plain(key) => {
                    write!(f, "[{}]", serde_json::Value::from(key.as_str()))?
                }
                Segment::Key(key) if position == 0 => f.write_str(key)?,
                Segment::Key(key) => write!(f, ".{key}")?,
            }
        }
        Ok(())
    }
}

fn is_plain(key: &str) -> bool {
    !key.is_empty() && !key.contains(|c: char| c.is_control() || ".[]\"".contains(c))
}

/// A text that is not a path.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{text}` is not a path: {reason}")]
pub struct PathError {
    /// What was written.
    pub text: String,
    /// What is wrong with it.
    pub reason: &'static str,
}

impl FromStr for JsonPath {
    type Err = PathError;

    fn from_str(text: &str) -> Result<Self, PathError> {
        let fail = |reason| PathError { text: text.to_string(), reason };
        let mut path = JsonPath::default();
        let mut rest = text;
        while !rest.is_empty() {
            if rest.starts_with("[\"") {
                let mut strings = serde_json::Deserializer::from_str(&rest[1..]).into_iter::<String>();
                let key =
                    strings.next().and_then(Result::ok).ok_or_else(|| fail("a quoted key does not end"))?;
                path.0.push(Segment::Key(key));
                rest = rest[1 + strings.byte_offset()..]
                    .strip_prefix(']')
                    .ok_or_else(|| fail("a `]` is missing"))?;
            } else if let Some(after) = rest.strip_prefix('[') {
                let (index, after) = after.split_once(']').ok_or_else(|| fail("a `]` is missing"))?;
                let index = index.parse().map_err(|_| fail("an index is a whole number, from 0"))?;
                path.0.push(Segment::Index(index));
                rest = after;
            } else {
                // A point joins a key to what stands before it, and only there.
                let key = match rest.strip_prefix('.') {
                    Some(after) if !path.is_root() => after,
                    _ if path.is_root() => rest,
                    _ => return Err(fail("a `.` is missing after `]`")),
                };
                let end = key.find(['.', '[']).unwrap_or(key.len());
                if !is_plain(&key[..end]) {
                    return Err(fail("a key is empty or holds a sign that needs [\"…\"]"));
                }
                path.0.push(Segment::Key(key[..end].to_string()));
                rest = &key[end..];
            }
        }
        Ok(path)
    }
}

impl From<&JsonPath> for JsonPath {
    fn from(path: &JsonPath) -> Self {
        path.clone()
    }
}

/// For paths written in the program.
///
/// # Panics
/// If the text is not a path; use [`str::parse`] for what a user wrote.
impl From<&'static str> for JsonPath {
    fn from(text: &'static str) -> Self {
        text.parse().expect("a path written in the program is well formed")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_written_and_read_as_in_the_messages() {
        let path = JsonPath::default().key("supports").index(0).key("at").key("x");
        assert_eq!(path.to_string(), "supports[0].at.x");
        assert_eq!("supports[0].at.x".parse(), Ok(path));
        assert_eq!("".parse(), Ok(JsonPath::default()));
        assert_eq!("[2][3]".parse(), Ok(JsonPath::default().index(2).index(3)));
    }

    #[test]
    fn odd_keys_survive_writing_and_reading() {
        for key in ["", "a.b", "a[0]", "say \"x\"", "line\nbreak", "ключ", "a]b", "\\"] {
            let path = JsonPath::default().key("first").key(key).index(7).key(key);
            assert_eq!(path.to_string().parse(), Ok(path), "{key:?}");
            let first = JsonPath::default().key(key);
            assert_eq!(first.to_string().parse(), Ok(first), "{key:?}");
        }
    }

    #[test]
    fn malformed_paths_are_refused() {
        for text in ["a..b", ".a", "a.", "a[", "a[x]", "a[-1]", "a[0]b", "a]b", "a[\"b\"", "a[\"b"] {
            assert!(text.parse::<JsonPath>().is_err(), "{text} was accepted");
        }
        let error = "a[x]".parse::<JsonPath>().unwrap_err();
        assert_eq!(error.to_string(), "`a[x]` is not a path: an index is a whole number, from 0");
    }
}
