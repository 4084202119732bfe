//! The stiffness of a case for solvers of Python.

use crate::background::beside;
use crate::given::Given;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;

/// Row pointers, columns and values of a sparse matrix.
type Rows<'py> = (Bound<'py, PyArray1<usize>>, Bound<'py, PyArray1<usize>>, Bound<'py, PyArray1<f64>>);

/// The stiffness of a case under its supports, with its loads.
#[pyclass(frozen)]
pub(crate) struct Operator(peristat::Operator);

/// Builds the operator of a case.
#[pyfunction]
pub(crate) fn operator(py: Python<'_>, given: Given) -> PyResult<Operator> {
    beside(py, None, move |_| Ok(Operator(peristat::Operator::new(&given.load()?)?)))
}

#[pymethods]
impl Operator {
    /// Number of unknowns.
    fn size(&self) -> usize {
        self.0.unknowns().len()
    }

    /// Number of states.
    fn states(&self) -> usize {
        self.0.states()
    }

    /// Names of the displacements and rotations of a point.
    fn components(&self) -> Vec<&'static str> {
        self.0.components().to_vec()
    }

    /// Point and component of every unknown.
    fn unknowns<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<usize>>> {
        let flat: Vec<usize> = self.0.unknowns().iter().flat_map(|&(point, c)| [point, c]).collect();
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
        py.detach(|| self.0.product(&q, &mut out));
        Ok(PyArray1::from_vec(py, out))
    }

    /// The assembled matrix in compressed rows.
    fn matrix<'py>(&self, py: Python<'py>) -> Rows<'py> {
        let (starts, columns, values) = py.detach(|| self.0.matrix().into_raw_storage());
        (PyArray1::from_vec(py, starts), PyArray1::from_vec(py, columns), PyArray1::from_vec(py, values))
    }

    /// Loads of a state, less the forces of its prescribed motions.
    fn right_hand_side<'py>(&self, py: Python<'py>, state: usize) -> PyResult<Bound<'py, PyArray1<f64>>> {
        self.is_state(state)?;
        Ok(PyArray1::from_slice(py, self.0.right_hand_side(state)))
    }

    /// Displacements and rotations of all points, one row for each.
    fn expand<'py>(
        &self,
        py: Python<'py>,
        q: PyReadonlyArray1<'py, f64>,
        state: usize,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.is_state(state)?;
        let flat = self.0.expand(&self.checked(q)?, state);
        PyArray1::from_vec(py, flat).reshape([self.0.points(), self.0.components().len()])
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
        let states = self.0.states();
        let refusal = || PyIndexError::new_err(format!("there is no state {state}: there are {states}"));
        (state < states).then_some(()).ok_or_else(refusal)
    }
}
