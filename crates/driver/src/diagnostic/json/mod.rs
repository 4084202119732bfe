//! JSON text as a source of typed values. A fault carries its path, which grows while it passes up, so that neither a
//! wrapper around every value nor a second reading finds it; and it tells a misfit from a fault of syntax: `serde_json`
//! calls some misfits the latter, such as a number where an enum is expected.
//!
//! Numbers are the nearest doubles. A name that stands twice reaches the type, which refuses it.

mod access;
mod lex;
mod source;
#[cfg(test)]
mod tests;

use super::path::{JsonPath, Segment};
use serde::de::{self, DeserializeOwned};
use std::fmt::{self, Display};

/// Levels of lists and objects within each other, as many as `serde_json` reads.
const LEVELS: u32 = 127;

/// Why a text is no value of a type.
#[derive(Debug)]
pub(super) struct Fault(Box<Inner>);

#[derive(Debug, Default)]
struct Inner {
    misfit: Option<String>,
    /// From the value at fault to the root.
    path: Vec<Segment>,
    at: usize,
}

impl Fault {
    /// The text is no JSON.
    fn syntax() -> Self {
        Self(Box::default())
    }

    /// What does not fit, in the words of `serde`; none where the text is no JSON.
    pub(super) fn misfit(&self) -> Option<&str> {
        self.0.misfit.as_deref()
    }

    /// Byte up to which the text was read.
    pub(super) fn at(&self) -> usize {
        self.0.at
    }

    /// Path of the value at fault.
    pub(super) fn path(&self) -> JsonPath {
        JsonPath(self.0.path.iter().rev().cloned().collect())
    }

    /// The fault of a value that stands in another one, at a key.
    fn at_key(mut self, key: &str) -> Self {
        self.0.path.push(Segment::Key(key.into()));
        self
    }

    /// The same, at a place of a list.
    fn at_index(mut self, index: usize) -> Self {
        self.0.path.push(Segment::Index(index));
        self
    }
}

impl Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.misfit().unwrap_or("no JSON"))
    }
}

impl std::error::Error for Fault {}

impl de::Error for Fault {
    fn custom<T: Display>(message: T) -> Self {
        Self(Box::new(Inner { misfit: Some(message.to_string()), ..Inner::default() }))
    }
}

/// Reads a value.
pub(super) fn read<T: DeserializeOwned>(text: &str) -> Result<T, Fault> {
    let mut source = lex::Source::new(text);
    let value = T::deserialize(&mut source).and_then(|value| source.end().map(|()| value));
    value.map_err(|mut fault| {
        fault.0.at = source.at();
        fault
    })
}
