//! Files that cases name: where they may lie, meshes, surfaces, lists of points and tables.
//!
//! Readers take the bytes of a file and never panic on any; what they hold grows with what they have read, never with a
//! number in the file. Faults say the line and what belongs there.

pub mod drawing;
pub mod file;
mod folder;
pub mod gmsh;
mod lines;
pub mod points;
pub mod solid;
pub mod stl;
pub mod surface;
pub mod table;

pub use file::Refusal;
pub use folder::{Folder, Reach};

use std::fmt;

/// What is wrong with a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReadError {
    /// Line, from one; none if the file as a whole is at fault.
    pub line: Option<usize>,
    /// The reason, without a final period.
    pub message: String,
    /// What to do about it.
    pub hint: Option<&'static str>,
}

impl ReadError {
    fn at(line: usize, message: impl Into<String>) -> Self {
        Self { line: Some(line), message: message.into(), hint: None }
    }

    fn whole(message: impl Into<String>) -> Self {
        Self { line: None, message: message.into(), hint: None }
    }

    fn hint(self, hint: &'static str) -> Self {
        Self { hint: Some(hint), ..self }
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            Some(line) => write!(f, "line {line}: {}", self.message),
            None => f.write_str(&self.message),
        }
    }
}

impl std::error::Error for ReadError {}
