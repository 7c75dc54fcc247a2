//! Curves: B-splines, the typed curves of a strip, and the relations between these.

use lineament::curve::pieces::{Piece, Shape, Sigma};
use lineament::curve::{BSpline, Round};
use lineament::relation::{Member, Regularised, Relation};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::arrays::{rows, table, triple};
use crate::fault::Fault;
use crate::state;

/// A B-spline as a dictionary.
#[derive(IntoPyObject)]
pub struct CurveOut<'py> {
    degree: usize,
    knots: Bound<'py, PyArray1<f64>>,
    controls: Bound<'py, PyArray2<f64>>,
    periodic: bool,
}

/// The curve for Python; `None` without control points.
pub fn curve<'py>(py: Python<'py>, curve: &BSpline) -> PyResult<Option<CurveOut<'py>>> {
    if curve.controls.is_empty() {
        return Ok(None);
    }
    Ok(Some(CurveOut {
        degree: curve.degree,
        knots: curve.knots.clone().into_pyarray(py),
        controls: table(py, curve.controls.clone())?,
        periodic: curve.periodic,
    }))
}

/// A B-spline as Python's object holds it.
#[derive(FromPyObject)]
pub struct CurveIn<'py> {
    degree: usize,
    knots: PyReadonlyArray1<'py, f64>,
    controls: PyReadonlyArray2<'py, f64>,
    periodic: bool,
}

impl CurveIn<'_> {
    /// The curve.
    ///
    /// # Errors
    /// Control points that are no `(C, 3)` array in C order.
    pub fn curve(&self) -> Result<BSpline, Fault> {
        Ok(BSpline {
            degree: self.degree,
            knots: self.knots.as_array().to_vec(),
            controls: rows(&self.controls)?.to_vec(),
            periodic: self.periodic,
        })
    }
}

/// A typed curve, kept for outputs: its numbers come back to the bit.
#[pyclass(frozen, module = "lineament._lineament")]
pub struct Typed(Piece);

#[pymethods]
impl Typed {
    /// For copies and pickles.
    #[new]
    fn new(state: &[u8]) -> PyResult<Self> {
        Ok(Self(state::value(state)?))
    }

    fn __getnewargs__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyBytes>,)> {
        state::bytes(py, &self.0)
    }
}

/// A typed curve as a dictionary.
#[derive(IntoPyObject)]
pub struct TypedOut<'py> {
    typed: Py<Typed>,
    kind: &'static str,
    start: Bound<'py, PyArray1<f64>>,
    end: Bound<'py, PyArray1<f64>>,
    first: usize,
    last: usize,
    deviation: f64,
    center: Option<Bound<'py, PyArray1<f64>>>,
    normal: Option<Bound<'py, PyArray1<f64>>>,
    radius: Option<f64>,
    major: Option<Bound<'py, PyArray1<f64>>>,
    minor: Option<f64>,
    sweep_deg: Option<f64>,
    spline: Option<CurveOut<'py>>,
    offset_sigma: Option<f64>,
    direction_sigma_deg: Option<f64>,
    radius_sigma: Option<f64>,
    normal_sigma_deg: Option<f64>,
    turn_sigma_deg: Option<f64>,
    covariance: Option<Bound<'py, PyArray2<f64>>>,
}

/// The curves for Python.
pub fn typed<'py>(py: Python<'py>, pieces: &[Piece]) -> PyResult<Vec<TypedOut<'py>>> {
    pieces.iter().map(|p| one(py, p)).collect()
}

fn one<'py>(py: Python<'py>, piece: &Piece) -> PyResult<TypedOut<'py>> {
    let (round, sweep, spline): (Option<&Round>, _, _) = match &piece.shape {
        Shape::Line => (None, None, None),
        Shape::Arc { round, sweep } => (Some(round), Some(*sweep), None),
        Shape::Circle(round) => (Some(round), None, None),
        Shape::Ellipse { sweep, .. } => (None, Some(*sweep), None),
        Shape::Spline(spline) => (None, None, curve(py, spline)?),
    };
    let ellipse = match &piece.shape {
        Shape::Ellipse { ellipse, .. } => Some(ellipse),
        _ => None,
    };
    let place = round.map(|r| (r.centre, r.normal)).or(ellipse.map(|e| (e.centre, e.normal)));
    let (line, circle) = match piece.sigma {
        Some(Sigma::Line { offset, direction }) => (Some((offset, direction)), None),
        Some(Sigma::Round { radius, normal, covariance }) => (None, Some((radius, normal, covariance))),
        Some(Sigma::Ellipse { .. }) | None => (None, None),
    };
    let oval = match piece.sigma {
        Some(Sigma::Ellipse { turn, normal, covariance }) => Some((turn, normal, covariance)),
        _ => None,
    };
    let covariance: Option<Vec<Vec<f64>>> = match (circle, oval) {
        (Some((.., c)), _) => Some(c.iter().map(|row| row.to_vec()).collect()),
        (_, Some((.., c))) => Some(c.iter().map(|row| row.to_vec()).collect()),
        _ => None,
    };
    Ok(TypedOut {
        typed: Py::new(py, Typed(piece.clone()))?,
        kind: piece.shape.name(),
        start: triple(py, piece.from),
        end: triple(py, piece.to),
        first: piece.first,
        last: piece.last,
        deviation: piece.deviation,
        center: place.map(|p| triple(py, p.0)),
        normal: place.map(|p| triple(py, p.1)),
        radius: round.map(|r| r.radius),
        major: ellipse.map(|e| triple(py, e.major)),
        minor: ellipse.map(|e| e.minor),
        sweep_deg: sweep.map(f64::to_degrees),
        spline,
        offset_sigma: line.map(|(offset, _)| offset),
        direction_sigma_deg: line.map(|(_, direction)| direction.to_degrees()),
        radius_sigma: circle.map(|(radius, ..)| radius),
        normal_sigma_deg: circle.map(|c| c.1).or(oval.map(|o| o.1)).map(f64::to_degrees),
        turn_sigma_deg: oval.map(|o| o.0.to_degrees()),
        covariance: covariance.map(|c| Ok::<_, PyErr>(PyArray2::from_vec2(py, &c)?)).transpose()?,
    })
}

/// A typed curve as Python's object holds it.
#[derive(FromPyObject)]
pub struct TypedIn<'py> {
    #[pyo3(attribute("_typed"))]
    typed: Bound<'py, Typed>,
}

impl TypedIn<'_> {
    /// The curve.
    pub fn piece(&self) -> Piece {
        self.typed.get().0.clone()
    }
}

/// A relation as a dictionary.
#[derive(IntoPyObject)]
pub struct RelationOut<'py> {
    kind: &'static str,
    members: Vec<(u32, u32)>,
    others: Vec<(u32, u32)>,
    likelihood: f64,
    deviation: Option<f64>,
    deviation_deg: Option<f64>,
    direction: Option<Bound<'py, PyArray1<f64>>>,
    point: Option<Bound<'py, PyArray1<f64>>>,
    radius: Option<f64>,
    imposed: bool,
}

/// What the imposition of relations has moved, as a dictionary.
#[derive(IntoPyObject)]
pub struct RegularisedOut<'py> {
    nodes: Bound<'py, PyArray1<f64>>,
    curves: Vec<Bound<'py, PyArray1<f64>>>,
    released: Vec<(u32, u32)>,
}

fn pairs(of: &[Member]) -> Vec<(u32, u32)> {
    of.iter().map(|m| (m.strip, m.curve)).collect()
}

/// The relations for Python.
pub fn relations<'py>(py: Python<'py>, relations: &[Relation]) -> Vec<RelationOut<'py>> {
    let one = |r: &Relation| RelationOut {
        kind: r.kind.name(),
        members: pairs(&r.members),
        others: pairs(&r.others),
        likelihood: r.likelihood,
        deviation: (!r.kind.is_angle()).then_some(r.deviation),
        deviation_deg: r.kind.is_angle().then(|| r.deviation.to_degrees()),
        direction: r.direction.map(|d| triple(py, d)),
        point: r.point.map(|p| triple(py, p)),
        radius: r.radius,
        imposed: r.imposed,
    };
    relations.iter().map(one).collect()
}

/// What was moved, for Python.
pub fn moved<'py>(py: Python<'py>, moved: &Regularised) -> RegularisedOut<'py> {
    RegularisedOut {
        nodes: moved.nodes.clone().into_pyarray(py),
        curves: moved.curves.iter().map(|c| c.clone().into_pyarray(py)).collect(),
        released: pairs(&moved.released),
    }
}
