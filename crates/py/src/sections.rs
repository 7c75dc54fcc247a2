//! `section`: the curves in which planes meet a cloud.

mod stack;

use std::path::PathBuf;

use lineament::params::ParamValue;
use lineament::section::{Contour, CurvePiece, CurveShape, Section, Sections, Stack, section_observed};
use lineament_io::{Report, SectionContext, write_sections};
use numpy::{IntoPyArray, PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use serde::{Deserialize, Serialize};

use crate::arrays::{table, triple};
use crate::curves::{CurveOut, curve};
use crate::fault::Fault;
use crate::provenance::Provenance;
use crate::report::page::is_page;
use crate::scan::ScanIn;
use crate::settings::{self, Setting};
use crate::state;
use crate::work::{Observe, on_rows};
use stack::StackOut;

/// What of the sections is kept for their outputs.
#[pyclass(frozen, module = "lineament._lineament")]
#[derive(Serialize, Deserialize)]
pub struct Cut {
    sections: Sections,
    stack: Stack,
}

/// Sections as a dictionary.
#[derive(IntoPyObject)]
pub struct SectionsOut<'py> {
    cut: Py<Cut>,
    axes: Bound<'py, PyArray2<f64>>,
    counted_from: String,
    zero: f64,
    heights: Bound<'py, PyArray1<f64>>,
    spacing: f64,
    noise: f64,
    dropped: usize,
    merged: usize,
    clutter: usize,
    sections: Vec<SectionOut<'py>>,
    stack: StackOut<'py>,
}

#[derive(IntoPyObject)]
struct SectionOut<'py> {
    plane: usize,
    height: f64,
    slab: Option<(f64, f64)>,
    points: usize,
    contours: Vec<ContourOut<'py>>,
    missing: Option<String>,
}

#[derive(IntoPyObject)]
struct ContourOut<'py> {
    points: Bound<'py, PyArray2<f64>>,
    corners: Vec<usize>,
    closed: bool,
    parent: Option<usize>,
    depth: usize,
    area: f64,
    length: f64,
    draft_deg: Option<f64>,
    steepest_deg: f64,
    centroid: Bound<'py, PyArray1<f64>>,
    pieces: Vec<PieceOut<'py>>,
}

#[derive(IntoPyObject)]
struct PieceOut<'py> {
    kind: &'static str,
    start: Bound<'py, PyArray1<f64>>,
    end: Bound<'py, PyArray1<f64>>,
    worst: f64,
    center: Option<Bound<'py, PyArray1<f64>>>,
    radius: Option<f64>,
    major: Option<Bound<'py, PyArray1<f64>>>,
    minor: Option<f64>,
    sweep_deg: Option<f64>,
    curve: Option<CurveOut<'py>>,
}

/// Cuts `(N, 3)` points by planes with these settings; `progress` is called with `section` and the share done.
#[pyfunction]
#[pyo3(signature = (points, settings, progress=None))]
pub fn section<'py>(
    points: &Bound<'py, PyArray2<f64>>,
    settings: Vec<Setting>,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<SectionsOut<'py>> {
    let params = settings::params(&settings)?.section;
    let (sections, stack) = on_rows(points, progress, move |points, observe: Observe| {
        Ok(section_observed(points, &params, &|share| observe("section", share))?)
    })?;
    out(points.py(), sections, stack)
}

fn out(py: Python<'_>, sections: Sections, stack: Stack) -> PyResult<SectionsOut<'_>> {
    Ok(SectionsOut {
        axes: table(py, sections.frame.axes.to_vec())?,
        counted_from: sections.zero.0.show(),
        zero: sections.zero.1,
        heights: sections.heights.clone().into_pyarray(py),
        spacing: sections.spacing,
        noise: sections.noise,
        dropped: sections.dropped,
        merged: sections.merged,
        clutter: sections.clutter,
        sections: sections.sections.iter().map(|s| one(py, s)).collect::<PyResult<_>>()?,
        stack: stack::out(py, &stack),
        cut: Py::new(py, Cut { sections, stack })?,
    })
}

fn one<'py>(py: Python<'py>, section: &Section) -> PyResult<SectionOut<'py>> {
    Ok(SectionOut {
        plane: section.plane,
        height: section.height,
        slab: section.slab.map(|[from, to]| (from, to)),
        points: section.points,
        contours: section.contours.iter().map(|c| contour(py, c)).collect::<PyResult<_>>()?,
        missing: section.missing.map(|missing| missing.reason()),
    })
}

fn contour<'py>(py: Python<'py>, contour: &Contour) -> PyResult<ContourOut<'py>> {
    Ok(ContourOut {
        points: table(py, contour.points.clone())?,
        corners: contour.corners.clone(),
        closed: contour.closed,
        parent: contour.parent,
        depth: contour.depth,
        area: contour.area,
        length: contour.length,
        draft_deg: contour.draft_deg,
        steepest_deg: contour.steepest_deg,
        centroid: triple(py, contour.centroid),
        pieces: contour.pieces.iter().map(|p| piece(py, p)).collect::<PyResult<_>>()?,
    })
}

fn piece<'py>(py: Python<'py>, piece: &CurvePiece) -> PyResult<PieceOut<'py>> {
    let (center, radius, sweep_deg, spline) = match &piece.shape {
        CurveShape::Line => (None, None, None, None),
        CurveShape::Arc { centre, radius, sweep_deg } => {
            (Some(*centre), Some(*radius), Some(*sweep_deg), None)
        }
        CurveShape::Circle { centre, radius } => (Some(*centre), Some(*radius), None, None),
        CurveShape::Ellipse { ellipse, sweep_deg } => (Some(ellipse.centre), None, Some(*sweep_deg), None),
        CurveShape::Spline(spline) => (None, None, None, curve(py, spline)?),
    };
    let ellipse = match &piece.shape {
        CurveShape::Ellipse { ellipse, .. } => Some(ellipse),
        _ => None,
    };
    Ok(PieceOut {
        major: ellipse.map(|e| triple(py, e.major)),
        minor: ellipse.map(|e| e.minor),
        kind: piece.shape.name(),
        start: triple(py, piece.from),
        end: triple(py, piece.to),
        worst: piece.worst,
        center: center.map(|c| triple(py, c)),
        radius,
        sweep_deg,
        curve: spline,
    })
}

#[pymethods]
impl Cut {
    /// For copies and pickles.
    #[new]
    fn new(state: &[u8]) -> PyResult<Self> {
        Ok(state::value(state)?)
    }

    fn __getnewargs__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyBytes>,)> {
        state::bytes(py, self)
    }

    /// Writes the sections to a file, in the format of its extension. A report shows the points of `scan` too.
    fn write(
        &self,
        py: Python<'_>,
        path: PathBuf,
        scan: ScanIn<'_>,
        provenance: Provenance,
        millimetres: Option<f64>,
        unit: Option<String>,
    ) -> PyResult<()> {
        if is_page(&path) {
            let scanned = scan.scanned()?;
            let sections = Some((&self.sections, &self.stack));
            return scanned.write(py, &path, &Report { sections, ..scanned.report() });
        }
        let inputs = scan.files.clone();
        let context: SectionContext =
            provenance.of_sections(self.stack.clone(), millimetres, unit.as_deref())?;
        Ok(py.detach(|| write_sections(&path, &inputs, &self.sections, &context)).map_err(Fault::from)?)
    }
}
