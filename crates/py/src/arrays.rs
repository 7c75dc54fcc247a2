//! Between NumPy's arrays and rows of numbers, without copies.

pub mod attributes;

use numpy::{
    Element, IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods,
};
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

/// The rows of an `(N, D)` array of indices.
///
/// # Errors
/// Rows of another length.
pub fn pairs<const D: usize>(array: &PyReadonlyArray2<'_, u32>) -> Result<Vec<[u32; D]>, Fault> {
    let wrong = || Fault::Argument(format!("indices of shape {:?}: expected (N, {D})", array.shape()));
    let row = |row: numpy::ndarray::ArrayView1<'_, u32>| row.to_vec().try_into().map_err(|_| wrong());
    array.as_array().rows().into_iter().map(row).collect()
}

/// An `(N, D)` array of rows, which it takes over.
pub fn table<T: Element, const D: usize>(
    py: Python<'_>,
    rows: Vec<[T; D]>,
) -> PyResult<Bound<'_, PyArray2<T>>> {
    let count = rows.len();
    rows.into_flattened().into_pyarray(py).reshape([count, D])
}

/// An array of three numbers.
pub fn triple(py: Python<'_>, point: [f64; 3]) -> Bound<'_, PyArray1<f64>> {
    PyArray1::from_slice(py, &point)
}
