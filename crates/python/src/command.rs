//! The command `peristat` inside the Python package.

use pyo3::prelude::*;
use std::ffi::OsString;

/// Does what the arguments say, the first of which is the name of the command, and returns the exit code.
#[pyfunction]
pub(crate) fn command(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| peristat_cli::command(arguments))
}
