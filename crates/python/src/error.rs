//! Errors of the library as Python exceptions.

use peristat::Error;
use peristat::run::RunError;
use pyo3::call::PyCallArgs;
use pyo3::exceptions::{PyMemoryError, PyOSError, PyRuntimeError};
use pyo3::prelude::*;
use serde::Serialize;

/// The exception of an error.
pub(crate) fn exception(py: Python<'_>, error: &Error) -> PyErr {
    match error {
        Error::Case(_) | Error::Tasks(_) if error.lacks_memory() => PyMemoryError::new_err(error.text()),
        Error::Case(_) | Error::Tasks(_) => {
            let found = json(&error.records());
            found.map_or_else(|error| error, |faults| of_class(py, "CaseError", (error.text(), faults)))
        }
        Error::Run(RunError::Interrupted) => of_class(py, "Interrupted", ("the run was told to end",)),
        Error::Run(RunError::Memory { .. }) => PyMemoryError::new_err(error.to_string()),
        Error::Io(error) => PyOSError::new_err(error.to_string()),
        Error::Run(_) => PyRuntimeError::new_err(error.to_string()),
    }
}

/// A value as the Python half reads it.
pub(crate) fn json(value: &impl Serialize) -> PyResult<String> {
    serde_json::to_string(value).map_err(|error| PyRuntimeError::new_err(error.to_string()))
}

/// An exception of a class of the Python half.
fn of_class<'py>(py: Python<'py>, class: &str, arguments: impl PyCallArgs<'py>) -> PyErr {
    let made = py.import("peristat._errors").and_then(|errors| errors.getattr(class)?.call1(arguments));
    made.map_or_else(|error| error, PyErr::from_value)
}
