//! A solved case as Python sees it.

use numpy::{PyArray1, PyArray2};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use std::borrow::Cow;

/// A solved case.
#[pyclass(frozen)]
pub(crate) struct Solved {
    pub(crate) solved: peristat::Solved,
    /// Every equilibrium of a body that breaks or softens.
    pub(crate) curve: Vec<serde_json::Value>,
}

#[pymethods]
impl Solved {
    /// The record of the run, as JSON.
    fn summary(&self) -> PyResult<String> {
        serde_json::to_string(&self.solved.summary)
            .map_err(|error| pyo3::exceptions::PyRuntimeError::new_err(error.to_string()))
    }

    /// Every equilibrium on the way of a body that breaks or softens, as JSON.
    fn curve(&self) -> String {
        serde_json::Value::from(self.curve.clone()).to_string()
    }

    /// Names of the recorded states, in their order.
    fn states(&self) -> Vec<String> {
        self.solved.states.iter().map(|state| state.record().name.clone()).collect()
    }

    /// Positions of all points, n x 3.
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let points = self.solved.points();
        let rows = points.len();
        let flat: Vec<f64> = points.into_iter().flatten().collect();
        let array = PyArray1::from_vec(py, flat);
        numpy::PyArrayMethods::reshape(&array, [rows, 3])
    }

    /// Volumes of all points; None where the case gives stiffnesses and no areas.
    fn volumes<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<f64>>> {
        self.solved.volumes().map(|volumes| PyArray1::from_vec(py, volumes))
    }

    /// Names of the fields of a state.
    fn fields(&self, state: usize) -> PyResult<Vec<&'static str>> {
        self.solved.fields(state).map_err(|error| PyKeyError::new_err(error.to_string()))
    }

    /// Values of a field of a state at all points.
    fn field<'py>(&self, py: Python<'py>, state: usize, name: &str) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let values =
            self.solved.field(state, name).map_err(|error| PyKeyError::new_err(error.to_string()))?;
        Ok(match values {
            Cow::Borrowed(values) => PyArray1::from_slice(py, values),
            Cow::Owned(values) => PyArray1::from_vec(py, values),
        })
    }
}
