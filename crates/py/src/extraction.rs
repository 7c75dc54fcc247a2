//! `extract`: points in, network, classes and report out.

pub mod applied;

use std::path::{Path, PathBuf};

use lineament::patch::NO_PATCH;
use lineament::{Attribute, Column, Extraction, Network, Patches, Related, extract_sampled};
use lineament_io::{NetworkContext, PointTable, Report, write_network, write_patches};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use serde::{Deserialize, Serialize};

use crate::curves::{self, RegularisedOut, RelationOut};
use crate::fault::Fault;
use crate::network::{self, NetworkOut};
use crate::patches::{self, PatchesOut};
use crate::provenance::{Drawn, Provenance};
use crate::report::page::is_page;
use crate::report::{self, ReportOut};
use crate::scan::{Folds, ScanIn};
use crate::settings::{self, Setting};
use crate::state;
use crate::work::{Observe, on_rows};

/// What of an extraction is kept for its outputs.
#[pyclass(frozen, module = "lineament._lineament")]
#[derive(Serialize, Deserialize)]
pub struct Found {
    network: Network,
    patches: Option<Patches>,
    related: Related,
}

/// An extraction as a dictionary.
#[derive(IntoPyObject)]
pub struct ExtractionOut<'py> {
    found: Py<Found>,
    network: NetworkOut<'py>,
    classes: Bound<'py, PyArray1<u8>>,
    scores: Bound<'py, PyArray1<f32>>,
    clutter: Bound<'py, PyArray1<u32>>,
    labels: Option<Bound<'py, PyArray1<i32>>>,
    patches: Option<PatchesOut<'py>>,
    relations: Vec<RelationOut<'py>>,
    regularised: Option<RegularisedOut<'py>>,
    report: ReportOut,
}

/// Extracts the lines of `(N, 3)` points with these settings; `progress` is called with the name of a stage and the share done, `folds` are
/// those of the mesh that the points were sampled on.
#[pyfunction]
#[pyo3(signature = (points, settings, progress=None, folds=None))]
pub fn extract<'py>(
    points: &Bound<'py, PyArray2<f64>>,
    settings: Vec<Setting>,
    progress: Option<Bound<'py, PyAny>>,
    folds: Option<PyRef<'py, Folds>>,
) -> PyResult<ExtractionOut<'py>> {
    let params = settings::params(&settings)?;
    let folds = folds.map_or(Vec::new(), |folds| folds.0.clone());
    // Classes and scores are made on the worker, and what Python does not ask for is freed there.
    let work = move |points: &[[f64; 3]], observe: Observe| {
        let tell = |p: lineament::Progress| observe(p.stage.name(), p.done);
        Ok::<_, Fault>(Kept::of(extract_sampled(points, &folds, &params, &tell)?))
    };
    out(points.py(), on_rows(points, progress, work)?)
}

/// The part of an extraction that Python shows.
pub struct Kept {
    network: Network,
    patches: Option<Patches>,
    related: Related,
    classes: Vec<u8>,
    scores: Vec<f32>,
    clutter: Vec<u32>,
    labels: Option<Vec<i32>>,
    report: lineament::Report,
}

impl Kept {
    /// The part of `found`.
    pub fn of(found: Extraction) -> Kept {
        Kept {
            classes: found.classes().into_iter().map(|class| class as u8).collect(),
            scores: found.scores(),
            labels: found.patches.is_some().then(|| labels(&found)),
            clutter: found.clutter,
            report: found.report,
            network: found.network,
            patches: found.patches,
            related: found.related,
        }
    }
}

/// `(N)` patch of every point, -1 for none.
fn labels(found: &Extraction) -> Vec<i32> {
    let signed = |label: u32| if label == NO_PATCH { -1 } else { label as i32 };
    found.patch_labels().into_iter().map(signed).collect()
}

/// An extraction for Python.
pub fn out(py: Python<'_>, kept: Kept) -> PyResult<ExtractionOut<'_>> {
    let Kept { network, patches, related, classes, scores, clutter, labels, report } = kept;
    Ok(ExtractionOut {
        network: network::out(py, &network)?,
        patches: patches.as_ref().map(|p| patches::out(py, p)),
        labels: labels.map(|labels| labels.into_pyarray(py)),
        relations: curves::relations(py, &related.relations),
        regularised: related.regularised.as_ref().map(|r| curves::moved(py, r)),
        found: Py::new(py, Found { network, patches, related })?,
        classes: classes.into_pyarray(py),
        scores: scores.into_pyarray(py),
        clutter: clutter.into_pyarray(py),
        report: report::out(&report),
    })
}

/// `(N)` class of each point, and its patch, -1 for none, if these were looked for.
type Marks<'py> = (PyReadonlyArray1<'py, u8>, Option<PyReadonlyArray1<'py, i32>>);

impl Found {
    /// Writes a report of the lines, and of the patches if these were looked for, with the points.
    fn write_page(
        &self,
        py: Python<'_>,
        path: &Path,
        scan: ScanIn<'_>,
        context: &NetworkContext,
        (classes, labels): Marks<'_>,
    ) -> PyResult<()> {
        let unsigned = |&label: &i32| u32::try_from(label).unwrap_or(NO_PATCH);
        let labels = labels.map(|labels| labels.as_array().iter().map(unsigned).collect::<Vec<u32>>());
        let (scanned, classes) = (scan.scanned()?, classes.as_array().to_vec());
        let report = Report {
            classes: &classes,
            labels: &labels.unwrap_or_default(),
            network: Some(&self.network),
            context,
            ..scanned.report()
        };
        scanned.write(py, path, &report)
    }
}

#[pymethods]
impl Found {
    /// For copies and pickles.
    #[new]
    fn new(state: &[u8]) -> PyResult<Self> {
        Ok(state::value(state)?)
    }

    fn __getnewargs__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyBytes>,)> {
        state::bytes(py, self)
    }

    /// Writes the network to a file, in the format of its extension. A report shows the points of `scan` with their `marks`.
    fn write(
        &self,
        py: Python<'_>,
        path: PathBuf,
        scan: ScanIn<'_>,
        provenance: Provenance,
        marks: Marks<'_>,
        drawing: Drawn,
    ) -> PyResult<()> {
        let (view, millimetres, unit) = drawing;
        let context = provenance.context(self.patches.clone(), &view, millimetres, unit.as_deref())?;
        let context = NetworkContext { related: self.related.clone(), ..context };
        if is_page(&path) {
            return self.write_page(py, &path, scan, &context, marks);
        }
        let inputs = scan.files.clone();
        Ok(py.detach(|| write_network(&path, &inputs, &self.network, &context)).map_err(Fault::from)?)
    }

    /// Writes the patches to a file, in the format of its extension: `labels` number the patch of each point of `scan`.
    fn write_patches(
        &self,
        path: PathBuf,
        scan: ScanIn<'_>,
        provenance: Provenance,
        labels: PyReadonlyArray1<'_, i32>,
        classes: PyReadonlyArray1<'_, u8>,
        unit: Option<String>,
    ) -> PyResult<()> {
        let context = provenance.context(self.patches.clone(), "auto", None, unit.as_deref())?;
        let context = NetworkContext { related: self.related.clone(), ..context };
        let (py, las, inputs) = (labels.py(), scan.las.clone(), scan.files.clone());
        if is_page(&path) {
            return self.write_page(py, &path, scan, &context, (classes, Some(labels)));
        }
        let mut cloud = scan.cloud()?;
        let values = Column::I32(labels.as_array().to_vec());
        cloud.attributes.insert(0, Attribute { name: "patch".into(), values });
        let classes = classes.as_array().to_vec();
        let las = las.as_ref().map(|las| &las.get().0);
        let table = PointTable { cloud: &cloud, classes: &classes, scores: &[], las };
        let write = || write_patches(&path, &inputs, &self.network, &context, &table);
        Ok(py.detach(write).map_err(Fault::from)?)
    }
}
