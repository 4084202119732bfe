//! A solved case as Python sees it.

use crate::background::common;
use crate::error::{exception, json};
use crate::states::Equilibrium;
use numpy::ndarray::ArrayView1;
use numpy::{PyArray1, PyArray2};
use peristat::results::{Claim, Writing};
use peristat::run::Sink;
use pyo3::exceptions::{PyKeyError, PyRuntimeError};
use pyo3::prelude::*;
use std::borrow::Cow;
use std::path::PathBuf;

/// A solved case.
#[pyclass(frozen)]
pub(crate) struct Solved {
    pub(crate) solved: peristat::Solved,
    /// Every equilibrium of a body that breaks or softens.
    pub(crate) curve: Vec<Equilibrium>,
}

#[pymethods]
impl Solved {
    /// The record of the run, as JSON.
    fn summary(&self) -> PyResult<String> {
        json(&self.solved.summary)
    }

    /// How the run ended: `passed`, `check_failed` or `not_converged`.
    fn status(&self) -> PyResult<String> {
        Ok(json(&self.solved.summary.status)?.trim_matches('"').into())
    }

    /// Doubts about the case and its answer.
    fn warnings(&self) -> Vec<String> {
        self.solved.summary.warnings.clone()
    }

    /// Every equilibrium on the way of a body that breaks or softens, as JSON.
    fn curve(&self) -> PyResult<String> {
        json(&self.curve)
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
        let array = numpy::PyArrayMethods::reshape(&PyArray1::from_vec(py, flat), [rows, 3])?;
        array.call_method1("setflags", (false,))?;
        Ok(array)
    }

    /// Volumes of all points; None where the case gives stiffnesses and no areas.
    fn volumes<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyArray1<f64>>>> {
        let Some(volumes) = self.solved.volumes() else { return Ok(None) };
        let array = PyArray1::from_vec(py, volumes);
        array.call_method1("setflags", (false,))?;
        Ok(Some(array))
    }

    /// Names of the fields of a state.
    fn fields(&self, state: usize) -> PyResult<Vec<&'static str>> {
        self.solved.fields(state).map_err(|error| PyKeyError::new_err(error.to_string()))
    }

    /// The unit of a field; None if there is no such field.
    fn unit(&self, name: &str) -> Option<&'static str> {
        self.solved.unit(name)
    }

    /// The unit of a probe; None if there is no such probe.
    fn probe_unit(&self, name: &str) -> Option<&str> {
        self.solved.probe_unit(name)
    }

    /// Values of a field of a state at all points, not to be written.
    #[allow(unsafe_code)]
    fn field<'py>(slf: Bound<'py, Self>, state: usize, name: &str) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let py = slf.py();
        let solved = &slf.get().solved;
        let array = match solved.field(state, name).map_err(|error| PyKeyError::new_err(error.to_string()))? {
            // SAFETY: the values lie in `slf`, which the array keeps alive. A frozen class is never changed, and the array is made
            // unwritable below, so that nothing moves or changes them.
            Cow::Borrowed(values) => unsafe {
                PyArray1::borrow_from_array(&ArrayView1::from(values), slf.clone().into_any())
            },
            Cow::Owned(values) => PyArray1::from_vec(py, values),
        };
        array.call_method1("setflags", (false,))?;
        Ok(array)
    }

    /// Writes the folder that the command writes.
    fn save(&self, py: Python<'_>, folder: PathBuf, force: bool) -> PyResult<()> {
        let peristat::Solved { scene, summary, states } = &self.solved;
        if states.len() != summary.states.len() {
            return Err(PyRuntimeError::new_err(
                "a run that was resumed has the states of its last part alone: the folder given as `output` has all",
            ));
        }
        // In a pool that a process has for itself.
        let write = move || {
            let mut writing = Writing::new(scene, Claim::new(&folder, force, None)?);
            states.iter().try_for_each(|state| writing.state(state))?;
            self.curve.iter().try_for_each(|at| writing.advance(at.as_advance(), None))?;
            writing.finish(&summary.clone().measured())
        };
        let pool = common().map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
        py.detach(|| pool.install(write)).map_err(|error| exception(py, &peristat::Error::Io(error)))
    }
}
