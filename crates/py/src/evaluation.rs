//! `evaluate`: a network against a truth.

use std::path::PathBuf;

use lineament::StripKind;
use lineament::evaluate::{Distances, Hits, Lines, Score, Scoring, score};
use lineament::math::vec3::distance;
use lineament::shapes::{Fold, Truth, TruthCurve, TruthNode, sample};
use lineament_io::read_lines;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;

use crate::arrays::{rows, table, triple};
use crate::fault::Fault;
use crate::network::{NetworkIn, node_kind, strip_kind};
use crate::work::alone;

/// Greatest number of spacings that networks and truths may be long: both are cut into pieces of a fifth.
const LONGEST: f64 = 2e7;

/// A truth as a dictionary.
#[derive(IntoPyObject)]
pub struct TruthOut<'py> {
    nodes: Vec<NodeOut<'py>>,
    curves: Vec<CurveOut<'py>>,
    weak_below_deg: f64,
}

#[derive(IntoPyObject)]
struct NodeOut<'py> {
    position: Bound<'py, PyArray1<f64>>,
    kind: &'static str,
    degree: u32,
}

#[derive(IntoPyObject)]
struct CurveOut<'py> {
    kind: &'static str,
    closed: bool,
    start: Option<u32>,
    end: Option<u32>,
    points: Bound<'py, PyArray2<f64>>,
    fold_deg: Bound<'py, PyArray1<f64>>,
}

/// The lines of a generated scan, known by construction; `None` if there is none of this name.
#[pyfunction]
pub fn truth<'py>(py: Python<'py>, name: &str, seed: u64) -> PyResult<Option<TruthOut<'py>>> {
    let Some(found) = sample(name) else { return Ok(None) };
    let truth = py.detach(|| (found.make)(seed).truth);
    let node =
        |n: &TruthNode| NodeOut { position: triple(py, n.position), kind: n.kind.name(), degree: n.degree };
    let curve = |c: TruthCurve| {
        Ok(CurveOut {
            kind: c.kind.name(),
            closed: c.closed,
            start: c.start,
            end: c.end,
            points: table(py, c.points)?,
            fold_deg: c.fold_deg.into_pyarray(py),
        })
    };
    Ok(Some(TruthOut {
        nodes: truth.nodes.iter().map(node).collect(),
        curves: truth.curves.into_iter().map(curve).collect::<PyResult<_>>()?,
        weak_below_deg: truth.weak_below_deg,
    }))
}

/// A truth as Python's objects hold it.
#[derive(FromPyObject)]
pub struct TruthIn<'py> {
    nodes: Vec<NodeIn>,
    curves: Vec<CurveIn<'py>>,
    weak_below_deg: f64,
}

#[derive(FromPyObject)]
struct NodeIn {
    position: [f64; 3],
    kind: String,
    degree: u32,
}

#[derive(FromPyObject)]
struct CurveIn<'py> {
    kind: String,
    closed: bool,
    start: Option<u32>,
    end: Option<u32>,
    points: PyReadonlyArray2<'py, f64>,
    fold_deg: PyReadonlyArray1<'py, f64>,
}

impl TruthIn<'_> {
    fn truth(&self) -> Result<Truth, Fault> {
        let node =
            |n: &NodeIn| TruthNode { position: n.position, kind: node_kind(&n.kind), degree: n.degree };
        let curves = self.curves.iter().map(CurveIn::curve).collect::<Result<_, Fault>>()?;
        let nodes = self.nodes.iter().map(node).collect();
        Ok(Truth { nodes, curves, weak_below_deg: self.weak_below_deg })
    }
}

impl CurveIn<'_> {
    fn curve(&self) -> Result<TruthCurve, Fault> {
        let kind = strip_kind(&self.kind);
        Ok(TruthCurve {
            kind,
            closed: self.closed,
            start: self.start,
            end: self.end,
            points: rows(&self.points)?.to_vec(),
            fold_deg: self.fold_deg.as_array().to_vec(),
            // No part of a score.
            fold: if kind == StripKind::Border { Fold::Open } else { Fold::Convex },
        })
    }
}

/// Known lines: a truth, or the file that holds them.
#[derive(FromPyObject)]
pub enum Known<'py> {
    Truth(TruthIn<'py>),
    File(PathBuf),
}

/// Angle between the faces of a mesh beyond which their edge is a line, degrees; that of the program.
const ANGLE_DEG: f64 = 30.0;

impl Known<'_> {
    /// The lines, and how many of them are closed.
    fn lines(&self) -> Result<(Lines, usize), Fault> {
        match self {
            Known::Truth(truth) => truth.truth().map(|truth| ((&truth).into(), truth.loops())),
            Known::File(path) => {
                let lines = read_lines(path, ANGLE_DEG)?.lines;
                let closed = lines.lines.iter().filter(|line| line.closed).count();
                Ok((lines, closed))
            }
        }
    }
}

/// A score as a dictionary.
#[derive(IntoPyObject)]
pub struct ScoreOut {
    at_1h: (f64, f64, f64),
    at_2h: (f64, f64, f64),
    to_truth: (f64, f64),
    from_truth: (f64, f64),
    loops: (usize, usize),
    curves_found: (usize, usize),
    junctions_hit: (usize, usize),
    length_spacings: f64,
}

/// Scores a network against a truth; `spacing` in the unit of both.
#[pyfunction]
pub fn evaluate(
    py: Python<'_>,
    network: NetworkIn<'_>,
    truth: Known<'_>,
    spacing: f64,
) -> PyResult<ScoreOut> {
    let (network, (truth, closed)) = (network.network()?, truth.lines()?);
    let (found, loops) = (Lines::from(&network), [network.loops(), closed]);
    let length = length(&found) + length(&truth);
    if !(spacing > 0.0 && spacing.is_finite() && length <= LONGEST * spacing) {
        let expected = format!("a number above 0, and lines of less than {LONGEST:e} spacings");
        return Err(Fault::Argument(format!(
            "spacing: {spacing} for lines of {length}: expected {expected}"
        ))
        .into());
    }
    Ok(out(&alone(py, move || Ok(Score { loops, ..score(&found, &truth, &Scoring::new(spacing)) }))?))
}

fn length(lines: &Lines) -> f64 {
    let along = |points: &Vec<[f64; 3]>| points.windows(2).map(|w| distance(w[0], w[1])).sum::<f64>();
    lines.lines.iter().map(|line| along(&line.points)).sum()
}

fn out(score: &Score) -> ScoreOut {
    let hits = |h: Hits| (h.precision, h.recall, h.f1);
    let distances = |d: Distances| (d.mean, d.max);
    ScoreOut {
        at_1h: hits(score.at_1h),
        at_2h: hits(score.at_2h),
        to_truth: distances(score.to_truth),
        from_truth: distances(score.from_truth),
        loops: score.loops.into(),
        curves_found: score.curves_found.into(),
        junctions_hit: score.junctions_hit.into(),
        length_spacings: score.length_spacings,
    }
}
