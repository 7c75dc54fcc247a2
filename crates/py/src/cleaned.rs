//! `clean`: the points on surfaces, and the others.

use std::path::PathBuf;

use lineament::clean_observed;
use lineament_io::{Report, label_clutter, write_cleaned};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::fault::Fault;
use crate::report::page::is_page;
use crate::report::{self, ReportOut};
use crate::scan::ScanIn;
use crate::settings::{self, Setting};
use crate::work::{Observe, on_rows};

/// Indices of the points as a dictionary.
#[derive(IntoPyObject)]
pub struct CleanedOut<'py> {
    surface: Bound<'py, PyArray1<u32>>,
    clutter: Bound<'py, PyArray1<u32>>,
    report: ReportOut,
}

/// Tells `(N, 3)` points on surfaces from clutter; `progress` is called with the name of a stage and the share done.
#[pyfunction]
#[pyo3(signature = (points, settings, progress=None))]
pub fn clean<'py>(
    points: &Bound<'py, PyArray2<f64>>,
    settings: Vec<Setting>,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<CleanedOut<'py>> {
    let params = settings::params(&settings)?;
    let found = on_rows(points, progress, move |points, observe: Observe| {
        Ok(clean_observed(points, &params, &|p| observe(p.stage.name(), p.done))?)
    })?;
    let py = points.py();
    Ok(CleanedOut {
        surface: found.surface.into_pyarray(py),
        clutter: found.clutter.into_pyarray(py),
        report: report::out(&found.report),
    })
}

/// Writes the points of `scan` to a file, in the format of its extension; with the indices of clutter all of them are labelled.
#[pyfunction]
#[pyo3(signature = (path, scan, clutter))]
pub fn write_scan(
    py: Python<'_>,
    path: PathBuf,
    scan: ScanIn<'_>,
    clutter: Option<PyReadonlyArray1<'_, u32>>,
) -> PyResult<()> {
    let (las, inputs) = (scan.las.clone(), scan.files.clone());
    let clutter = clutter.map(|clutter| clutter.as_array().to_vec());
    if is_page(&path) {
        let mut scanned = scan.scanned()?;
        let labels = clutter.map(|clutter| label_clutter(&mut scanned.cloud, &clutter)).unwrap_or_default();
        return scanned.write(py, &path, &Report { classes: &labels, ..scanned.report() });
    }
    let mut cloud = scan.cloud()?;
    let las = las.as_ref().map(|las| &las.get().0);
    let labelled = || {
        let labels = clutter.map(|clutter| label_clutter(&mut cloud, &clutter));
        write_cleaned(&path, &inputs, &cloud, &labels.unwrap_or_default(), las)
    };
    Ok(py.detach(labelled).map_err(Fault::from)?)
}
