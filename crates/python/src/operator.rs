//! The stiffness of a case for solvers of Python.

use crate::background::beside;
use crate::case_input::CaseInput;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1};
use peristat::Error;
use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;

/// Row pointers, columns and values of a sparse matrix.
type Rows<'py> = (Bound<'py, PyArray1<usize>>, Bound<'py, PyArray1<usize>>, Bound<'py, PyArray1<f64>>);

/// The stiffness of a case under its supports, with its loads.
#[pyclass(frozen)]
pub(crate) struct Operator {
    operator: peristat::Operator,
    warnings: Vec<String>,
}

/// Builds the operator of a case.
#[pyfunction]
pub(crate) fn operator(py: Python<'_>, given: CaseInput) -> PyResult<Operator> {
    beside(py, None, move |_| {
        let max_memory = given.max_memory;
        let loaded = given.load().map_err(|error| match error {
            Error::Case(mut report) => {
                // That nothing holds the body is no fault here.
                report.diagnostics.retain(|d| !d.in_solution_only);
                Error::Case(report)
            }
            other => other,
        })?;
        let warnings = loaded.warnings().map_or(Vec::new(), |report| report.records());
        let warnings = warnings.into_iter().map(|w| format!("{}: {}", w.path, w.message)).collect();
        Ok(Operator { operator: peristat::Operator::new(&loaded, max_memory)?, warnings })
    })
}

#[pymethods]
impl Operator {
    /// Number of unknowns.
    fn size(&self) -> usize {
        self.operator.unknowns().len()
    }

    /// Doubts about the case.
    fn warnings(&self) -> Vec<String> {
        self.warnings.clone()
    }

    /// Number of states.
    fn states(&self) -> usize {
        self.operator.states()
    }

    /// Names of the displacements and rotations of a point.
    fn components(&self) -> Vec<&'static str> {
        self.operator.components().to_vec()
    }

    /// Point and component of every unknown.
    fn unknowns<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<usize>>> {
        let flat: Vec<usize> = self.operator.unknowns().iter().flat_map(|&(point, c)| [point, c]).collect();
        PyArray1::from_vec(py, flat).reshape([self.size(), 2])
    }

    /// The product with a vector.
    fn product<'py>(
        &self,
        py: Python<'py>,
        q: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let q = self.checked(q)?;
        let mut out = vec![0.0; q.len()];
        py.detach(|| self.operator.product(&q, &mut out));
        Ok(PyArray1::from_vec(py, out))
    }

    /// The assembled matrix in compressed rows.
    fn matrix<'py>(&self, py: Python<'py>) -> Rows<'py> {
        let (starts, columns, values) = py.detach(|| self.operator.matrix().into_raw_storage());
        (PyArray1::from_vec(py, starts), PyArray1::from_vec(py, columns), PyArray1::from_vec(py, values))
    }

    /// Loads of a state, less the forces of its prescribed motions.
    fn right_hand_side<'py>(&self, py: Python<'py>, state: usize) -> PyResult<Bound<'py, PyArray1<f64>>> {
        self.is_state(state)?;
        Ok(PyArray1::from_slice(py, self.operator.right_hand_side(state)))
    }

    /// Displacements and rotations of all points, one row for each.
    fn expand<'py>(
        &self,
        py: Python<'py>,
        q: PyReadonlyArray1<'py, f64>,
        state: usize,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.is_state(state)?;
        let flat = self.operator.expand(&self.checked(q)?, state);
        PyArray1::from_vec(py, flat).reshape([self.operator.points(), self.operator.components().len()])
    }
}

impl Operator {
    fn checked(&self, q: PyReadonlyArray1<'_, f64>) -> PyResult<Vec<f64>> {
        match q.as_array().len() == self.size() {
            true => Ok(q.as_array().to_vec()),
            false => Err(PyValueError::new_err(format!(
                "there are {} unknowns, found {} values",
                self.size(),
                q.as_array().len()
            ))),
        }
    }

    fn is_state(&self, state: usize) -> PyResult<()> {
        let states = self.operator.states();
        let refusal = || PyIndexError::new_err(format!("there is no state {state}: there are {states}"));
        (state < states).then_some(()).ok_or_else(refusal)
    }
}
