//! Lines of a file and the numbers on them.

use super::ReadError;
use std::str::SplitAsciiWhitespace;

/// The lines of a file that are not blank.
#[derive(Debug)]
pub(super) struct Lines<'a> {
    rest: &'a [u8],
    number: usize,
}

impl<'a> Lines<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes), number: 0 }
    }

    /// Number of the line read last.
    pub(super) fn number(&self) -> usize {
        self.number
    }

    /// The next line without blanks at its ends, as it is in the file.
    pub(super) fn raw(&mut self) -> Option<&'a [u8]> {
        while !self.rest.is_empty() {
            let end = self.rest.iter().position(|b| *b == b'\n').unwrap_or(self.rest.len());
            let line = self.rest[..end].trim_ascii();
            self.rest = self.rest.get(end + 1..).unwrap_or_default();
            self.number += 1;
            if !line.is_empty() {
                return Some(line);
            }
        }
        None
    }

    /// The next line as text, on which `what` belongs.
    pub(super) fn text(&mut self, what: &str) -> Result<&'a str, ReadError> {
        let line = self.raw().ok_or_else(|| ReadError::whole(format!("ends where {what} belongs")))?;
        std::str::from_utf8(line)
            .map_err(|_| ReadError::at(self.number, format!("is no text where {what} belongs")))
    }

    /// The next line as a list of numbers.
    pub(super) fn fields(&mut self, what: &'static str) -> Result<Fields<'a>, ReadError> {
        let text = self.text(what)?;
        Ok(Fields::new(text, self.number, what))
    }
}

/// Numbers on a line, between blanks.
#[derive(Debug)]
pub(super) struct Fields<'a> {
    line: usize,
    what: &'static str,
    parts: SplitAsciiWhitespace<'a>,
}

impl<'a> Fields<'a> {
    /// Numbers of a part of a line; `what` is there.
    pub(super) fn new(text: &'a str, line: usize, what: &'static str) -> Self {
        Self { line, what, parts: text.split_ascii_whitespace() }
    }

    fn next<T: std::str::FromStr>(&mut self, name: &str) -> Result<T, ReadError> {
        let what = self.what;
        let Some(part) = self.parts.next() else {
            return Err(ReadError::at(
                self.line,
                format!("{what}: expected {name}, found the end of the line"),
            ));
        };
        let found: String = part.chars().take(40).collect();
        part.parse()
            .map_err(|_| ReadError::at(self.line, format!("{what}: expected {name}, found `{found}`")))
    }

    /// A number that is not negative.
    pub(super) fn count(&mut self, name: &str) -> Result<u64, ReadError> {
        self.next(name)
    }

    /// A whole number.
    pub(super) fn integer(&mut self, name: &str) -> Result<i64, ReadError> {
        self.next(name)
    }

    /// A finite number.
    pub(super) fn real(&mut self, name: &str) -> Result<f64, ReadError> {
        let value: f64 = self.next(name)?;
        let fault = || ReadError::at(self.line, format!("{}: {name} is not finite", self.what));
        if value.is_finite() { Ok(value) } else { Err(fault()) }
    }

    /// Whether all numbers have been read.
    pub(super) fn at_end(&mut self) -> bool {
        self.parts.clone().next().is_none()
    }
}
