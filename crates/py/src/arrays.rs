//! Between NumPy's arrays and rows of numbers, without copies.

pub mod attributes;

use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::fault::Fault;

/// The rows of an `(N, 3)` array that is C-contiguous.
///
/// # Errors
/// Internal: the package makes arrays so before it passes them.
pub fn rows<'a>(array: &'a PyReadonlyArray2<'_, f64>) -> Result<&'a [[f64; 3]], Fault> {
    let wrong = || Fault::Internal(format!("an array of shape {:?} for points", array.shape()));
    let values = array.as_slice().map_err(|_| wrong())?;
    match values.as_chunks::<3>() {
        (rows, []) if array.shape()[1] == 3 => Ok(rows),
        _ => Err(wrong()),
    }
}

/// An `(N, D)` array of rows, which it takes over.
pub fn table<const D: usize>(py: Python<'_>, rows: Vec<[f64; D]>) -> PyResult<Bound<'_, PyArray2<f64>>> {
    let count = rows.len();
    rows.into_flattened().into_pyarray(py).reshape([count, D])
}

/// An array of three numbers.
pub fn triple(py: Python<'_>, point: [f64; 3]) -> Bound<'_, PyArray1<f64>> {
    PyArray1::from_slice(py, &point)
}
