//! Points with their classes: by one detector alone, and as files.

use std::path::PathBuf;

use lineament::detect::baselines::Detector;
use lineament::detect::points::mark_observed;
use lineament::params::ParamValue;
use lineament_io::{PointTable, Report, write_points as write};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::fault::Fault;
use crate::network::NetworkIn;
use crate::report::page::is_page;
use crate::report::{self, ReportOut};
use crate::scan::ScanIn;
use crate::settings::{self, Setting};
use crate::work::{Observe, on_rows};

/// Classes and scores as a dictionary.
#[derive(IntoPyObject)]
pub struct MarksOut<'py> {
    classes: Bound<'py, PyArray1<u8>>,
    scores: Bound<'py, PyArray1<f32>>,
    report: ReportOut,
}

/// The names of the detectors.
#[pyfunction]
pub fn detectors() -> Vec<String> {
    Detector::ALL.iter().map(ParamValue::show).collect()
}

/// Classes and scores of `(N, 3)` points by one detector alone; `progress` is called with the name of a stage and the share done.
#[pyfunction]
#[pyo3(signature = (points, settings, detector, progress=None))]
pub fn mark<'py>(
    points: &Bound<'py, PyArray2<f64>>,
    settings: Vec<Setting>,
    detector: &str,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<MarksOut<'py>> {
    let params = settings::params(&settings)?;
    let detector = Detector::parse(detector).ok_or_else(|| {
        Fault::Argument(format!("there is no detector `{detector}`: {}", detectors().join(", ")))
    })?;
    let (classes, scores, report) = on_rows(points, progress, move |points, observe: Observe| {
        let tell = |p: lineament::Progress| observe(p.stage.name(), p.done);
        let marked = mark_observed(points, &params, &[detector], &tell)?;
        let classes: Vec<u8> = marked.classes(0).into_iter().map(|class| class as u8).collect();
        Ok((classes, marked.scores(0), marked.report))
    })?;
    let py = points.py();
    let (classes, scores) = (classes.into_pyarray(py), scores.into_pyarray(py));
    Ok(MarksOut { classes, scores, report: report::out(&report) })
}

/// Writes the points of `scan` with their attributes, classes and scores to a file, in the format of its extension. A report shows the
/// lines of `network` too.
#[pyfunction]
#[pyo3(signature = (path, scan, classes, scores, network))]
pub fn write_points(
    path: PathBuf,
    scan: ScanIn<'_>,
    classes: PyReadonlyArray1<'_, u8>,
    scores: PyReadonlyArray1<'_, f32>,
    network: Option<NetworkIn<'_>>,
) -> PyResult<()> {
    let (py, las, inputs) = (classes.py(), scan.las.clone(), scan.files.clone());
    let (classes, scores) = (classes.as_array().to_vec(), scores.as_array().to_vec());
    if is_page(&path) {
        let (scanned, network) = (scan.scanned()?, network.map(|n| n.network()).transpose()?);
        let report = Report { classes: &classes, network: network.as_ref(), ..scanned.report() };
        return scanned.write(py, &path, &report);
    }
    let cloud = scan.cloud()?;
    let las = las.as_ref().map(|las| &las.get().0);
    let table = PointTable { cloud: &cloud, classes: &classes, scores: &scores, las };
    Ok(py.detach(|| write(&path, &inputs, &table)).map_err(Fault::from)?)
}
