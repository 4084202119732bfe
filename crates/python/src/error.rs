//! Errors of the library as Python exceptions.

use peristat::Error;
use peristat::run::RunError;
use pyo3::call::PyCallArgs;
use pyo3::exceptions::{PyMemoryError, PyRuntimeError};
use pyo3::prelude::*;
use serde::Serialize;
use std::io;

/// Options of the command, as hints name them, and the arguments that they are here.
const OPTIONS: [(&str, &str); 6] = [
    ("`--max-memory`", "`max_memory`"),
    ("`--allow-outside`", "`allow_outside=True`"),
    ("`--force`", "`force=True`"),
    ("`--resume`", "`resume=True`"),
    ("`--all`", "`all=True`"),
    ("`-o`", "`output`"),
];

/// A text that speaks of arguments where that of the command speaks of options.
pub(crate) fn in_python(text: &str) -> String {
    OPTIONS.iter().fold(text.to_string(), |text, (option, argument)| text.replace(option, argument))
}

/// The exception of an error.
pub(crate) fn exception(py: Python<'_>, error: &Error) -> PyErr {
    match error {
        Error::Case(_) | Error::Tasks(_) if error.lacks_memory() => {
            PyMemoryError::new_err(in_python(&error.text()))
        }
        Error::Case(_) | Error::Tasks(_) => {
            let found = json(&error.records());
            found.map_or_else(
                |error| error,
                |faults| of_class(py, "CaseError", (in_python(&error.text()), in_python(&faults))),
            )
        }
        Error::Run(RunError::Interrupted) => of_class(py, "Interrupted", ("the run was stopped",)),
        Error::Run(RunError::Memory { .. }) => PyMemoryError::new_err(in_python(&error.to_string())),
        Error::Io(error) => io::Error::new(error.kind(), in_python(&error.to_string())).into(),
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
