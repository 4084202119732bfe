//! Group codes of DXF files with their values: two lines each.

use super::super::ReadError;
use std::iter::Enumerate;
use std::slice::Split;

/// A value with what its code says it is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair<'a> {
    pub(super) code: i32,
    pub(super) value: &'a str,
    /// The line of the value.
    pub(super) line: usize,
}

impl Pair<'_> {
    /// A finite number.
    pub(super) fn real(&self) -> Result<f64, ReadError> {
        let value = self.value.parse::<f64>().ok().filter(|x| x.is_finite());
        value.ok_or_else(|| {
            let found: String = self.value.chars().take(40).collect();
            ReadError::at(self.line, format!("expected a number of group {}, found `{found}`", self.code))
        })
    }

    /// Bits of a whole number; those of anything else are zero.
    pub(super) fn bits(&self) -> i64 {
        self.value.parse().unwrap_or(0)
    }
}

type Lines<'a> = Split<'a, u8, fn(&u8) -> bool>;

/// The pairs of a file in their order.
pub(super) struct Pairs<'a> {
    lines: Enumerate<Lines<'a>>,
}

impl<'a> Pairs<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        let is_end: fn(&u8) -> bool = |byte| *byte == b'\n';
        Self { lines: bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).split(is_end).enumerate() }
    }

    /// The next pair; values that are no UTF-8, as texts of old files may be, are empty.
    pub(super) fn next(&mut self) -> Result<Option<Pair<'a>>, ReadError> {
        let Some((k, first)) = self.lines.next() else { return Ok(None) };
        let text = |line: &'a [u8]| std::str::from_utf8(line.trim_ascii()).unwrap_or_default();
        let (line, code) = (k + 1, text(first));
        if code.is_empty() && self.lines.clone().all(|(_, rest)| rest.trim_ascii().is_empty()) {
            return Ok(None);
        }
        let number = code.parse::<i32>();
        let found: String = code.chars().take(40).collect();
        let code = number
            .map_err(|_| ReadError::at(line, format!("expected the number of a group, found `{found}`")))?;
        let Some((k, value)) = self.lines.next() else {
            return Err(ReadError::at(line, "the file ends where the value of a group belongs")
                .hint("the file is cut off: export or copy it again"));
        };
        Ok(Some(Pair { code, value: text(value), line: k + 1 }))
    }
}
