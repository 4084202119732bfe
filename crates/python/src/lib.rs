//! The native half of the Python package `peristat`; its public half is in `python/peristat`.

mod background;
mod case_input;
mod command;
mod error;
mod json_text;
mod operator;
mod run;
mod solved;
mod states;
mod study;
mod verify;

use peristat::model;
use pyo3::prelude::*;

/// The native half of `peristat`.
#[pymodule]
fn _peristat(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<solved::Solved>()?;
    module.add_class::<operator::Operator>()?;
    module.add_function(wrap_pyfunction!(operator::operator, module)?)?;
    module.add_function(wrap_pyfunction!(study::study, module)?)?;
    module.add_function(wrap_pyfunction!(verify::verify, module)?)?;
    module.add_function(wrap_pyfunction!(command::command, module)?)?;
    module.add_function(wrap_pyfunction!(run::run, module)?)?;
    module.add_function(wrap_pyfunction!(run::check, module)?)?;
    module.add_function(wrap_pyfunction!(json_text::json_text, module)?)?;
    module.add_function(wrap_pyfunction!(models, module)?)?;
    module.add_function(wrap_pyfunction!(schema, module)?)
}

/// Names of all models with what each is.
#[pyfunction]
fn models() -> Vec<(&'static str, &'static str)> {
    model::TABLE.iter().map(|entry| (entry.name, entry.about)).collect()
}

/// The schema of case files, or of studies, as JSON.
#[pyfunction]
fn schema(study: bool) -> String {
    let schema = match study {
        true => schemars::schema_for!(peristat::study::Study),
        false => schemars::schema_for!(peristat::case::Case),
    };
    schema.to_value().to_string()
}
