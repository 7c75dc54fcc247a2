//! `graph`, `enrich` and `mesh`: what lines are for (Gumhold 2001, section 5). Each extracts the lines that it needs, and gives them too.

use std::path::{Path, PathBuf};

use lineament::apply::{
    CutGraph, GraphKind, LinePoint, MeshOptions, SurfaceMesh, cut_graph, enriched, line_points, mesh_surface,
};
use lineament::{Attribute, Class, Column, Extraction, Params, extract_sampled};
use lineament_io::{GraphTable, PointTable, Report, write_points};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;

use crate::arrays::{pairs, rows, table};
use crate::extraction::{ExtractionOut, Kept, out};
use crate::fault::Fault;
use crate::provenance::Provenance;
use crate::report::page::is_page;
use crate::scan::{Folds, ScanIn};
use crate::settings::{self, Setting};
use crate::work::{Observe, on_rows};

/// A neighbour graph as a dictionary.
#[derive(IntoPyObject)]
pub struct GraphOut<'py> {
    extraction: ExtractionOut<'py>,
    edges: Bound<'py, PyArray2<u32>>,
    cut: Bound<'py, PyArray2<u32>>,
}

/// Points on lines as a dictionary.
#[derive(IntoPyObject)]
pub struct EnrichedOut<'py> {
    extraction: ExtractionOut<'py>,
    points: Bound<'py, PyArray2<f64>>,
    kinds: Bound<'py, PyArray1<u8>>,
    sources: Bound<'py, PyArray1<u32>>,
}

/// A mesh as a dictionary.
#[derive(IntoPyObject)]
pub struct MeshOut<'py> {
    extraction: ExtractionOut<'py>,
    vertices: Bound<'py, PyArray2<f64>>,
    kinds: Bound<'py, PyArray1<u8>>,
    triangles: Bound<'py, PyArray2<u32>>,
    open_edges: usize,
}

/// What Python asks of every application: the points, the settings, and who is told of progress.
type Asked<'a, 'py> = (&'a Bound<'py, PyArray2<f64>>, Vec<Setting>, Option<Bound<'py, PyAny>>);

/// Extracts lines and applies them.
fn applied<'py, T: Send + 'static>(
    (points, settings, progress): Asked<'_, 'py>,
    folds: Option<PyRef<'py, Folds>>,
    apply: impl FnOnce(&[[f64; 3]], &Extraction, &Params) -> Result<T, Fault> + Send + 'static,
) -> PyResult<(ExtractionOut<'py>, T)> {
    let params = settings::params(&settings)?;
    let folds = folds.map_or(Vec::new(), |folds| folds.0.clone());
    let (kept, made) = on_rows(points, progress, move |points, observe: Observe| {
        let tell = |p: lineament::Progress| observe(p.stage.name(), p.done);
        let found = extract_sampled(points, &folds, &params, &tell)?;
        let made = apply(points, &found, &params)?;
        Ok((Kept::of(found), made))
    })?;
    Ok((out(points.py(), kept)?, made))
}

/// The neighbour graph of `(N, 3)` points, `kind` riemannian or delaunay, cut at their lines.
#[pyfunction]
#[pyo3(signature = (points, settings, kind, progress=None, folds=None))]
pub fn graph<'py>(
    points: &Bound<'py, PyArray2<f64>>,
    settings: Vec<Setting>,
    kind: &str,
    progress: Option<Bound<'py, PyAny>>,
    folds: Option<PyRef<'py, Folds>>,
) -> PyResult<GraphOut<'py>> {
    let kind = match kind {
        "riemannian" => GraphKind::Riemannian,
        "delaunay" => GraphKind::Delaunay,
        _ => {
            let fault = format!("graph `{kind}`: riemannian or delaunay was expected");
            return Err(Fault::Argument(fault).into());
        }
    };
    let (extraction, CutGraph { edges, cut }) =
        applied((points, settings, progress), folds, move |points, found, params| {
            Ok(cut_graph(points, found, params, kind)?)
        })?;
    let py = points.py();
    Ok(GraphOut { extraction, edges: table(py, edges)?, cut: table(py, cut)? })
}

/// Points along the lines of `(N, 3)` points, `step` spacings apart.
#[pyfunction]
#[pyo3(signature = (points, settings, step, progress=None, folds=None))]
pub fn enrich<'py>(
    points: &Bound<'py, PyArray2<f64>>,
    settings: Vec<Setting>,
    step: f64,
    progress: Option<Bound<'py, PyAny>>,
    folds: Option<PyRef<'py, Folds>>,
) -> PyResult<EnrichedOut<'py>> {
    checked(step)?;
    let (extraction, added) = applied((points, settings, progress), folds, move |points, found, params| {
        Ok(line_points(points, found, params, step))
    })?;
    let py = points.py();
    let kinds: Vec<u8> = added.iter().map(|p| p.kind as u8).collect();
    let sources: Vec<u32> = added.iter().map(|p| p.source).collect();
    Ok(EnrichedOut {
        extraction,
        points: table(py, added.into_iter().map(|p| p.position).collect())?,
        kinds: kinds.into_pyarray(py),
        sources: sources.into_pyarray(py),
    })
}

/// A mesh over `(N, 3)` points with vertices on their lines `step` spacings apart, the usual distance by default; without `lines` over
/// the points alone.
#[pyfunction]
#[pyo3(signature = (points, settings, step, lines, progress=None, folds=None))]
pub fn mesh<'py>(
    points: &Bound<'py, PyArray2<f64>>,
    settings: Vec<Setting>,
    step: Option<f64>,
    lines: bool,
    progress: Option<Bound<'py, PyAny>>,
    folds: Option<PyRef<'py, Folds>>,
) -> PyResult<MeshOut<'py>> {
    step.map_or(Ok(()), checked)?;
    let usual = MeshOptions::default();
    let options = match lines {
        true => MeshOptions { step: step.or(usual.step), ..usual },
        false => MeshOptions { step: None, apart: false },
    };
    let (extraction, mesh) = applied((points, settings, progress), folds, move |points, found, params| {
        Ok(mesh_surface(points, found, params, &options)?)
    })?;
    let (py, open_edges) = (points.py(), mesh.open_edges());
    let kinds: Vec<u8> = mesh.kinds.iter().map(|&kind| kind as u8).collect();
    Ok(MeshOut {
        extraction,
        vertices: table(py, mesh.vertices)?,
        kinds: kinds.into_pyarray(py),
        triangles: table(py, mesh.triangles)?,
        open_edges,
    })
}

fn checked(step: f64) -> Result<(), Fault> {
    let fault = || Fault::Argument(format!("step: `{step}`: a length above 0 was expected"));
    (step.is_finite() && step > 0.0).then_some(()).ok_or_else(fault)
}

/// Writes a neighbour graph over the points of `scan` to a file, in the format of its extension; with `all` the edges that cross a line too.
#[pyfunction]
pub fn write_graph(
    path: PathBuf,
    scan: ScanIn<'_>,
    provenance: Provenance,
    edges: PyReadonlyArray2<'_, u32>,
    cut: PyReadonlyArray2<'_, u32>,
    all: bool,
) -> PyResult<()> {
    let (py, inputs) = (edges.py(), scan.files.clone());
    let context = provenance.context(None, "auto", None, None)?;
    let graph = CutGraph { edges: pairs(&edges)?, cut: pairs(&cut)? };
    let cloud = scan.cloud()?;
    let table = GraphTable { cloud: &cloud, graph: &graph, all, context: &context };
    Ok(py.detach(|| lineament_io::write_graph(&path, &inputs, &table)).map_err(Fault::from)?)
}

/// Points on lines: `(K, 3)` positions, `(K)` classes and rows of the points that stand for them.
type Added<'py> = (PyReadonlyArray2<'py, f64>, PyReadonlyArray1<'py, u8>, PyReadonlyArray1<'py, u32>);

/// Writes the points of `scan`, of these classes, and those `added` on lines to a file, in the format of its extension; with `only` the
/// added ones alone.
#[pyfunction]
pub fn write_enriched(
    path: PathBuf,
    scan: ScanIn<'_>,
    classes: PyReadonlyArray1<'_, u8>,
    added: Added<'_>,
    only: bool,
) -> PyResult<()> {
    let (py, las) = (classes.py(), scan.las.clone());
    let (positions, kinds, sources) = added;
    let of_line = rows(&positions)?.iter().zip(kinds.as_array()).zip(sources.as_array());
    let of_line = of_line.map(|((&position, &kind), &source)| LinePoint {
        position,
        kind: class(kind),
        source,
        strips: Vec::new(),
    });
    let points: Vec<LinePoint> = of_line.collect();
    let old: Vec<Class> = classes.as_array().iter().map(|&c| class(c)).collect();
    let mut scanned = scan.scanned()?;
    let (mut cloud, classes) = enriched(&scanned.cloud, &old, &points);
    let mut classes: Vec<u8> = classes.into_iter().map(|c| c as u8).collect();
    let first = if only { scanned.cloud.len() } else { 0 };
    let mut added = vec![0u8; scanned.cloud.len()];
    added.resize(cloud.len(), 1);
    if only {
        cloud = cloud.select(&(first as u32..cloud.len() as u32).collect::<Vec<u32>>());
        classes.drain(..first);
        added.drain(..first);
    }
    let column = |name: &str, values| Attribute { name: name.into(), values: Column::U8(values) };
    cloud.attributes.insert(0, column("class", classes.clone()));
    cloud.attributes.insert(1, column("added", added));
    scanned.cloud = cloud;
    if is_page(&path) {
        return scanned.write(py, &path, &Report { classes: &classes, ..scanned.report() });
    }
    let las = las.as_ref().map(|las| &las.get().0);
    let table = PointTable { cloud: &scanned.cloud, classes: &[], scores: &[], las };
    Ok(py.detach(|| write_points(&path, &scanned.files, &table)).map_err(Fault::from)?)
}

/// The class of a number; smooth for none.
fn class(number: u8) -> Class {
    let all = [Class::Smooth, Class::Crease, Class::Border, Class::Corner, Class::Clutter];
    all.get(usize::from(number)).copied().unwrap_or_default()
}

/// Writes a mesh of `(V, 3)` vertices and `(T, 3)` triangles to a file, in the format of its extension.
#[pyfunction]
pub fn write_mesh(
    py: Python<'_>,
    path: PathBuf,
    inputs: Vec<PathBuf>,
    vertices: PyReadonlyArray2<'_, f64>,
    kinds: PyReadonlyArray1<'_, u8>,
    triangles: PyReadonlyArray2<'_, u32>,
) -> PyResult<()> {
    let mesh = SurfaceMesh {
        vertices: rows(&vertices)?.to_vec(),
        kinds: kinds.as_array().iter().map(|&kind| class(kind)).collect(),
        triangles: pairs(&triangles)?,
    };
    let write = |path: &Path| lineament_io::write_mesh(path, &inputs, &mesh);
    Ok(py.detach(|| write(&path)).map_err(Fault::from)?)
}
