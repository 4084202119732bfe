//! Errors of the library as Python exceptions.

use peristat::Error;
use peristat::diagnostic::{Report, Severity};
use peristat::run::RunError;
use pyo3::call::PyCallArgs;
use pyo3::exceptions::{PyMemoryError, PyOSError, PyRuntimeError};
use pyo3::prelude::*;

/// A fault as the Python half takes it: severity, message, path, line and column counted from 1, hint.
pub(crate) type Fault = (&'static str, String, String, Option<(usize, usize)>, Option<String>);

/// The faults and warnings of a report.
pub(crate) fn faults(report: &Report) -> Vec<Fault> {
    let of = |d: &peristat::diagnostic::Diagnostic| {
        let severity = if d.severity == Severity::Error { "error" } else { "warning" };
        (severity, d.message.clone(), d.path.to_string(), report.line_and_column(d), d.hint.clone())
    };
    report.diagnostics.iter().map(of).collect()
}

/// The exception of an error.
pub(crate) fn exception(py: Python<'_>, error: &Error) -> PyErr {
    match error {
        Error::Case(report) => of_class(py, "CaseError", (report.render(false).trim_end(), faults(report))),
        Error::Run(RunError::Interrupted) => of_class(py, "Interrupted", ("`on_state` ended the run",)),
        Error::Run(RunError::Memory { .. }) => PyMemoryError::new_err(error.to_string()),
        Error::Io(error) => PyOSError::new_err(error.to_string()),
        Error::Run(_) | Error::Tasks(_) => PyRuntimeError::new_err(error.to_string()),
    }
}

/// An exception of a class of the Python half.
fn of_class<'py>(py: Python<'py>, class: &str, arguments: impl PyCallArgs<'py>) -> PyErr {
    let made = py.import("peristat._errors").and_then(|errors| errors.getattr(class)?.call1(arguments));
    made.map_or_else(|error| error, PyErr::from_value)
}
