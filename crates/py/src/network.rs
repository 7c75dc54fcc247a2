//! Networks: to Python as dictionaries, and back from the objects that Python made of them.

use std::path::PathBuf;

use lineament::curve::BSpline;
use lineament::{Blend, Network, Node, NodeKind, Strip, StripKind};
use lineament_io::{NetworkFormat, write_network as write, write_network_to};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;

use crate::arrays::{rows, table, triple};
use crate::curves::{CurveIn, CurveOut, TypedIn, TypedOut, curve, typed};
use crate::fault::Fault;
use crate::provenance::{Drawn, Provenance};

/// A network as a dictionary.
#[derive(IntoPyObject)]
pub struct NetworkOut<'py> {
    nodes: Vec<NodeOut<'py>>,
    strips: Vec<StripOut<'py>>,
}

#[derive(IntoPyObject)]
struct NodeOut<'py> {
    position: Bound<'py, PyArray1<f64>>,
    kind: &'static str,
    degree: u32,
    source: u32,
}

#[derive(IntoPyObject)]
struct StripOut<'py> {
    kind: &'static str,
    closed: bool,
    start: Option<u32>,
    end: Option<u32>,
    points: Bound<'py, PyArray2<f64>>,
    curve: Option<CurveOut<'py>>,
    curves: Vec<TypedOut<'py>>,
    sources: Bound<'py, PyArray1<u32>>,
    length: f64,
    deviation: f64,
    fold_deg: Option<f64>,
    evidence: Option<f64>,
    confidence: f64,
    radius: Option<f64>,
    radius_sigma: Option<f64>,
}

/// The network for Python.
pub fn out<'py>(py: Python<'py>, network: &Network) -> PyResult<NetworkOut<'py>> {
    let nodes = network.nodes.iter().map(|node| NodeOut {
        position: triple(py, node.position),
        kind: node.kind.name(),
        degree: node.degree,
        source: node.source,
    });
    let strips = network.strips.iter().map(|s| strip(py, s)).collect::<PyResult<_>>()?;
    Ok(NetworkOut { nodes: nodes.collect(), strips })
}

fn strip<'py>(py: Python<'py>, strip: &Strip) -> PyResult<StripOut<'py>> {
    Ok(StripOut {
        kind: strip.kind.name(),
        closed: strip.closed,
        start: strip.start,
        end: strip.end,
        points: table(py, strip.points.clone())?,
        curve: curve(py, &strip.curve)?,
        curves: typed(py, &strip.curves)?,
        sources: strip.sources.clone().into_pyarray(py),
        length: strip.length(),
        deviation: strip.deviation,
        fold_deg: strip.fold_deg,
        evidence: strip.evidence,
        confidence: strip.confidence,
        radius: strip.blend.map(|b| b.radius),
        radius_sigma: strip.blend.map(|b| b.sigma),
    })
}

/// A network as Python's objects hold it.
#[derive(FromPyObject)]
pub struct NetworkIn<'py> {
    nodes: Vec<NodeIn>,
    strips: Vec<StripIn<'py>>,
}

#[derive(FromPyObject)]
struct NodeIn {
    position: [f64; 3],
    degree: u32,
    source: u32,
    kind: String,
}

#[derive(FromPyObject)]
struct StripIn<'py> {
    kind: String,
    closed: bool,
    start: Option<u32>,
    end: Option<u32>,
    points: PyReadonlyArray2<'py, f64>,
    curve: Option<CurveIn<'py>>,
    curves: Vec<TypedIn<'py>>,
    sources: PyReadonlyArray1<'py, u32>,
    deviation: f64,
    fold_deg: Option<f64>,
    evidence: Option<f64>,
    confidence: f64,
    radius: Option<f64>,
    radius_sigma: Option<f64>,
}

/// The kind of this name; an apex if there is none.
pub fn node_kind(name: &str) -> NodeKind {
    let kinds = [NodeKind::Junction, NodeKind::Corner, NodeKind::End];
    kinds.into_iter().find(|kind| kind.name() == name).unwrap_or(NodeKind::Apex)
}

/// The kind of this name; a crease if there is none.
pub fn strip_kind(name: &str) -> StripKind {
    let kinds = [StripKind::Border, StripKind::Rounded];
    kinds.into_iter().find(|kind| kind.name() == name).unwrap_or(StripKind::Crease)
}

impl NetworkIn<'_> {
    /// The network.
    ///
    /// # Errors
    /// Points that are no `(M, 3)` array in C order.
    pub fn network(&self) -> Result<Network, Fault> {
        let strips = self.strips.iter().map(StripIn::strip).collect::<Result<_, Fault>>()?;
        Ok(Network { nodes: self.nodes.iter().map(NodeIn::node).collect(), strips })
    }
}

impl NodeIn {
    fn node(&self) -> Node {
        let kind = node_kind(&self.kind);
        Node { position: self.position, kind, degree: self.degree, source: self.source, sigma: None }
    }
}

impl StripIn<'_> {
    fn strip(&self) -> Result<Strip, Fault> {
        Ok(Strip {
            kind: strip_kind(&self.kind),
            closed: self.closed,
            start: self.start,
            end: self.end,
            points: rows(&self.points)?.to_vec(),
            curve: self.curve.as_ref().map_or(Ok(BSpline::default()), CurveIn::curve)?,
            curves: self.curves.iter().map(TypedIn::piece).collect(),
            sources: self.sources.as_array().to_vec(),
            deviation: self.deviation,
            fold_deg: self.fold_deg,
            evidence: self.evidence,
            confidence: self.confidence,
            sigma: Vec::new(),
            blend: self.radius.map(|radius| Blend { radius, sigma: self.radius_sigma.unwrap_or(0.0) }),
        })
    }
}

/// Writes a network to a file, in the format of its extension.
#[pyfunction]
pub fn write_network(
    py: Python<'_>,
    path: PathBuf,
    inputs: Vec<PathBuf>,
    network: NetworkIn<'_>,
    provenance: Provenance,
    drawing: Drawn,
) -> PyResult<()> {
    let network = network.network()?;
    let (view, millimetres, unit) = drawing;
    let context = provenance.context(None, &view, millimetres, unit.as_deref())?;
    Ok(py.detach(|| write(&path, &inputs, &network, &context)).map_err(Fault::from)?)
}

/// A drawing of a network as SVG.
#[pyfunction]
#[pyo3(signature = (network, provenance, view, millimetres))]
pub fn draw(
    network: NetworkIn<'_>,
    provenance: Provenance,
    view: &str,
    millimetres: Option<f64>,
) -> PyResult<String> {
    let (network, context) = (network.network()?, provenance.context(None, view, millimetres, None)?);
    let mut svg = Vec::new();
    write_network_to(&mut svg, NetworkFormat::Svg, &network, &context)?;
    Ok(String::from_utf8(svg)?)
}
