//! Generated scans.

use lineament::shapes;
use numpy::PyArray2;
use pyo3::prelude::*;

use crate::arrays::table;

/// Names and descriptions of the generated scans.
#[pyfunction]
pub fn samples() -> Vec<(&'static str, &'static str)> {
    shapes::samples().iter().map(|sample| (sample.name, sample.description)).collect()
}

/// The points of a generated scan; `None` if there is none of this name.
#[pyfunction]
pub fn sample<'py>(py: Python<'py>, name: &str, seed: u64) -> PyResult<Option<Bound<'py, PyArray2<f64>>>> {
    let found = shapes::sample(name);
    found.map(|sample| table(py, py.detach(|| (sample.make)(seed).cloud.positions))).transpose()
}
