//! Surfaces of triangles: STL, binary and ASCII.
//!
//! Which of both a file is, its length tells: that of a binary one follows from the number of triangles that it says. The word `solid` at
//! its start does not, as many binary files begin with it. Normals are passed over: corners run counter-clockwise, seen from outside.
//!
//! The libraries at hand keep neither the names of parts nor the lines of faults.
//!
//! Source of the format: 3D Systems, Stereolithography Interface Specification (1989).

mod ascii;
mod binary;

#[cfg(test)]
mod tests;

use super::ReadError;
use super::lines::Lines;
use super::surface::Triangles;

/// Reads a surface. Parts have the names of their `solid` sections, unless there is one section alone: its name is what a program calls
/// the whole.
///
/// # Errors
/// [`ReadError`]: a file that is cut off or has another length than it says, something else than what belongs in a line.
pub fn read(bytes: &[u8]) -> Result<Triangles, ReadError> {
    match binary::count(bytes) {
        Some(count) if binary::length(count) == bytes.len() as u64 => Ok(binary::triangles(bytes)),
        _ if is_text(bytes) => ascii::triangles(bytes),
        count => Err(binary::refused(bytes, count)),
    }
}

/// Whether bytes are text, as far as they tell: numbers of binary files have zeros.
fn is_printed(bytes: &[u8]) -> bool {
    !bytes.iter().any(|byte| byte.is_ascii_control() && !byte.is_ascii_whitespace())
}

/// Whether a file begins as one in ASCII does: behind the line of `solid` comes the first triangle, or the end.
fn is_text(bytes: &[u8]) -> bool {
    let mut lines = Lines::new(bytes);
    let starts = |line: Option<&[u8]>, words: &[&str]| {
        let line = line.unwrap_or_default();
        words
            .iter()
            .any(|word| line.get(..word.len()).is_some_and(|w| w.eq_ignore_ascii_case(word.as_bytes())))
    };
    let first = lines.raw();
    starts(first, &["solid"]) && first.is_some_and(is_printed) && {
        let next = lines.raw();
        next.is_none() || starts(next, &["facet", "endsolid", "color"])
    }
}
