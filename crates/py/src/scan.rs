//! `read`: a file as points with their attributes.

use std::path::PathBuf;

use lineament::Cloud;
use lineament::mesh::{Fold, MeshPoints};
use lineament_io::{Format, LasFrame, Missing, NetworkContext, ReadOptions, Returns, read as read_file};
use numpy::{PyArray2, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::arrays::attributes::{self, Named};
use crate::arrays::{rows, table};
use crate::fault::Fault;
use crate::report::page::Scanned;
use crate::state;
use crate::work::alone;

/// Formats in which y points up.
const Y_UP: [&str; 2] = ["glTF", "GLB"];

/// How a LAS or LAZ file stored its coordinates, for outputs that are to be like it.
#[pyclass(frozen, module = "lineament._lineament")]
pub struct Las(pub LasFrame);

#[pymethods]
impl Las {
    /// For copies and pickles.
    #[new]
    fn new(state: &[u8]) -> PyResult<Self> {
        Ok(Self(state::value(state)?))
    }

    fn __getnewargs__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyBytes>,)> {
        state::bytes(py, &self.0)
    }
}

/// The edges at which a mesh folds that points were sampled on.
#[pyclass(frozen, module = "lineament._lineament")]
pub struct Folds(pub Vec<Fold>);

#[pymethods]
impl Folds {
    /// For copies and pickles.
    #[new]
    fn new(state: &[u8]) -> PyResult<Self> {
        Ok(Self(state::value(state)?))
    }

    fn __getnewargs__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyBytes>,)> {
        state::bytes(py, &self.0)
    }

    fn __len__(&self) -> usize {
        self.0.len()
    }
}

/// A scan as Python's object holds it.
#[derive(FromPyObject)]
pub struct ScanIn<'py> {
    points: PyReadonlyArray2<'py, f64>,
    columns: Vec<Named<'py>>,
    /// How the coordinates were stored.
    pub las: Option<Bound<'py, Las>>,
    /// The files that it was read from.
    pub files: Vec<PathBuf>,
    name: String,
    format: Option<String>,
    crs: Option<String>,
    crs_wkt: Option<String>,
    sha256: Option<String>,
}

impl ScanIn<'_> {
    /// The scan for a report.
    pub fn scanned(self) -> Result<Scanned, Fault> {
        let y_up = self.format.as_ref().is_some_and(|f| Y_UP.contains(&f.as_str()));
        let provenance = NetworkContext {
            program_version: env!("CARGO_PKG_VERSION").into(),
            input_name: self.name.clone(),
            input_sha256: self.sha256.clone(),
            input_points: rows(&self.points)?.len() as u64,
            crs: self.crs.clone(),
            crs_wkt: self.crs_wkt.clone(),
            ..NetworkContext::default()
        };
        let up = if y_up { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] };
        Ok(Scanned { files: self.files.clone(), cloud: self.cloud()?, provenance, up })
    }

    /// The points with their attributes, for a writer.
    pub fn cloud(self) -> Result<Cloud, Fault> {
        Ok(Cloud { positions: rows(&self.points)?.to_vec(), attributes: attributes::back(self.columns)? })
    }
}

/// The content of a file as a dictionary.
#[derive(IntoPyObject)]
pub struct ScanOut<'py> {
    points: Bound<'py, PyArray2<f64>>,
    attributes: Vec<Named<'py>>,
    format: String,
    ignored: Vec<String>,
    warnings: Vec<String>,
    missing: Option<String>,
    beside: Vec<PathBuf>,
    crs: Option<String>,
    epsg: Option<u32>,
    crs_wkt: Option<String>,
    las: Option<Py<Las>>,
    sha256: Option<String>,
    sampled: Option<(usize, f64)>,
    folds: Option<Py<Folds>>,
    bytes: u64,
}

/// How a file is read.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Options {
    salvage: bool,
    attributes: bool,
    hash: bool,
    memory: Option<u64>,
    classes: Vec<u8>,
    returns: Option<String>,
    scan: Option<usize>,
    every: Option<usize>,
    voxel: Option<f64>,
    bounds: Option<[[f64; 3]; 2]>,
    format: Option<String>,
    vertices: bool,
    samples: Option<usize>,
}

/// Reads the points of a file.
#[pyfunction]
pub fn read(py: Python<'_>, path: PathBuf, options: Options) -> PyResult<ScanOut<'_>> {
    let options = options.checked()?;
    let scan = alone(py, move || Ok(read_file(&path, &options)?))?;
    Ok(ScanOut {
        points: table(py, scan.cloud.positions)?,
        attributes: attributes::out(py, scan.cloud.attributes),
        format: scan.format.to_string(),
        ignored: scan.ignored,
        warnings: scan.warnings,
        missing: scan.missing.map(|m: Missing| m.to_string()),
        beside: scan.beside,
        crs: scan.crs,
        epsg: scan.epsg,
        crs_wkt: scan.wkt,
        las: scan.las.map(|las| Py::new(py, Las(las))).transpose()?,
        sha256: scan.sha256,
        sampled: scan.sampled.as_ref().map(|s| (s.faces, s.spacing)),
        folds: scan.sampled.map(|s| Py::new(py, Folds(s.folds))).transpose()?,
        bytes: scan.bytes,
    })
}

impl Options {
    fn checked(self) -> Result<ReadOptions, Fault> {
        let format = |name: String| {
            Format::parse(&name)
                .ok_or_else(|| Fault::Argument(format!("there is no format of scans `{name}`")))
        };
        let mesh = match (self.samples, self.vertices) {
            (Some(count), _) => MeshPoints::Sampled(count),
            (None, true) => MeshPoints::Vertices,
            (None, false) => MeshPoints::Auto,
        };
        Ok(ReadOptions {
            salvage: self.salvage,
            attributes: self.attributes,
            hash: self.hash,
            memory: self.memory,
            classes: self.classes,
            returns: self.returns.as_deref().map(returns).transpose()?,
            scan: self.scan,
            every: self.every,
            voxel: self.voxel,
            bounds: self.bounds,
            format: self.format.map(format).transpose()?,
            mesh: Some(mesh),
            ..ReadOptions::default()
        })
    }
}

fn returns(name: &str) -> Result<Returns, Fault> {
    match name {
        "first" => Ok(Returns::First),
        "last" => Ok(Returns::Last),
        "only" => Ok(Returns::Only),
        _ => Err(Fault::Argument(format!("returns `{name}`: first, last or only was expected"))),
    }
}
