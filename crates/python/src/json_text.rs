//! Values of Python as JSON. The encoder of Python takes a third as long for a small case as solving it takes, most of it by leaving
//! other code behind in the caches of the processor.

use pyo3::exceptions::{PyRuntimeError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyString, PyTuple};
use serde::Serialize;

/// Levels of lists and dictionaries that a case may have.
const DEEPEST: usize = 128;

/// A value as JSON. `plain` makes values that JSON has of all others.
///
/// # Errors
/// `TypeError` for what is no value of JSON, `ValueError` for what is no finite number or contains itself.
#[pyfunction]
pub(crate) fn json_text(value: &Bound<'_, PyAny>, plain: &Bound<'_, PyAny>) -> PyResult<String> {
    let mut writer = Writer { text: Vec::with_capacity(1024), plain };
    writer.value(value, 0)?;
    String::from_utf8(writer.text).map_err(|error| PyRuntimeError::new_err(error.to_string()))
}

struct Writer<'a, 'py> {
    text: Vec<u8>,
    plain: &'a Bound<'py, PyAny>,
}

impl<'py> Writer<'_, 'py> {
    fn value(&mut self, value: &Bound<'py, PyAny>, depth: usize) -> PyResult<()> {
        if depth > DEEPEST {
            return Err(PyValueError::new_err(format!(
                "a case has at most {DEEPEST} levels of lists and dictionaries: one of these may contain itself"
            )));
        }
        if let Ok(text) = value.cast::<PyString>() {
            self.scalar(text.to_cow()?.as_ref())
        } else if let Ok(number) = value.cast::<PyFloat>() {
            self.number(number.extract()?, value)
        } else if let Ok(is) = value.cast::<PyBool>() {
            self.scalar(&is.is_true())
        } else if let Ok(number) = value.cast::<PyInt>() {
            self.integer(number)
        } else if let Ok(entries) = value.cast::<PyDict>() {
            self.entries(entries, depth)
        } else if let Ok(list) = value.cast::<PyList>() {
            self.list(list.iter(), depth)
        } else if let Ok(list) = value.cast::<PyTuple>() {
            self.list(list.iter(), depth)
        } else if value.is_none() {
            self.scalar(&())
        } else {
            self.value(&self.plain.call1((value,))?, depth + 1)
        }
    }

    fn entries(&mut self, entries: &Bound<'py, PyDict>, depth: usize) -> PyResult<()> {
        self.text.push(b'{');
        // A list of its own: what `plain` calls may change the dictionary.
        for (k, entry) in entries.items().iter().enumerate() {
            let (key, value): (Bound<'py, PyAny>, Bound<'py, PyAny>) = entry.extract()?;
            let Ok(key) = key.cast::<PyString>() else {
                return Err(PyTypeError::new_err(format!("keys of a case are texts, found {}", key.repr()?)));
            };
            self.separate(k);
            self.scalar(key.to_cow()?.as_ref())?;
            self.text.extend(b": ");
            self.value(&value, depth + 1)?;
        }
        self.text.push(b'}');
        Ok(())
    }

    fn list(&mut self, items: impl Iterator<Item = Bound<'py, PyAny>>, depth: usize) -> PyResult<()> {
        self.text.push(b'[');
        for (k, item) in items.enumerate() {
            self.separate(k);
            self.value(&item, depth + 1)?;
        }
        self.text.push(b']');
        Ok(())
    }

    fn separate(&mut self, number: usize) {
        if number > 0 {
            self.text.extend(b", ");
        }
    }

    fn number(&mut self, number: f64, value: &Bound<'py, PyAny>) -> PyResult<()> {
        match number.is_finite() {
            true => self.scalar(&number),
            false => {
                Err(PyValueError::new_err(format!("a case holds finite numbers, found {}", value.repr()?)))
            }
        }
    }

    fn integer(&mut self, number: &Bound<'py, PyInt>) -> PyResult<()> {
        match number.extract::<i64>() {
            Ok(number) => self.scalar(&number),
            Err(_) => {
                let digits = number.py().get_type::<PyInt>().call_method1("__repr__", (number,))?;
                self.text.extend(digits.extract::<String>()?.bytes());
                Ok(())
            }
        }
    }

    fn scalar(&mut self, value: &(impl Serialize + ?Sized)) -> PyResult<()> {
        serde_json::to_writer(&mut self.text, value)
            .map_err(|error| PyRuntimeError::new_err(error.to_string()))
    }
}
