//! The native half of the Python package `peristat`; its public half is in `python/peristat`.

mod error;
mod run;
mod solved;

use peristat::model;
use pyo3::prelude::*;

/// The native half of `peristat`.
#[pymodule]
fn _peristat(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<solved::Solved>()?;
    module.add_function(wrap_pyfunction!(run::run, module)?)?;
    module.add_function(wrap_pyfunction!(run::check, module)?)?;
    module.add_function(wrap_pyfunction!(models, module)?)?;
    module.add_function(wrap_pyfunction!(schema, module)?)
}

/// Names of all models with what each is.
#[pyfunction]
fn models() -> Vec<(&'static str, &'static str)> {
    model::TABLE.iter().map(|entry| (entry.name, entry.about)).collect()
}

/// The schema of case files, as JSON.
#[pyfunction]
fn schema() -> String {
    schemars::schema_for!(peristat::case::Case).to_value().to_string()
}
