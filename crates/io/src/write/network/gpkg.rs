//! A network as GeoPackage: the layers `lines` and `nodes`.

use super::context::{self, NetworkContext};
use crate::write::encode::gpkg::{self, Layer, Shape, text};
use crate::write::encode::sqlite::Value;
use lineament::{Network, Node, Strip};
use std::io::{self, Write};

const LINES: &str = "kind TEXT, closed BOOLEAN, start_node INTEGER, end_node INTEGER, length DOUBLE, fold_deg DOUBLE, \
    deviation DOUBLE, confidence DOUBLE";
const NODES: &str = "kind TEXT, degree INTEGER";

/// Writes a database of two layers.
pub(super) fn write(out: &mut dyn Write, network: &Network, context: &NetworkContext) -> io::Result<()> {
    let strips = network.strips.iter().enumerate().filter(|(_, strip)| strip.points.len() > 1);
    let lines = strips.map(|(id, strip)| line(strip, context::fold_deg(strip, context.sides(id))));
    let lines = Layer { name: "lines", geometry: "LINESTRING", columns: LINES, features: lines.collect() };
    let nodes = network.nodes.iter().map(node).collect();
    let nodes = Layer { name: "nodes", geometry: "POINT", columns: NODES, features: nodes };
    gpkg::write(out, vec![lines, nodes], context.crs.as_deref(), context.crs_wkt.as_deref())
}

/// A strip; a closed one ends where it begins. Nodes are numbered from 1, as in `nodes`.
fn line(strip: &Strip, fold_deg: f64) -> (Shape, Vec<Value>) {
    let node = |index: Option<u32>| index.map_or(Value::Null, |node| Value::Integer(i64::from(node) + 1));
    let first = strip.points.first().filter(|_| strip.closed);
    let way = strip.points.iter().chain(first).copied().collect();
    let values = vec![
        text(strip.kind.name()),
        Value::Integer(strip.closed.into()),
        node(strip.start),
        node(strip.end),
        Value::Real(strip.length()),
        if fold_deg.is_finite() { Value::Real(fold_deg) } else { Value::Null },
        Value::Real(strip.deviation),
        Value::Real(strip.confidence),
    ];
    (Shape::Line(way), values)
}

fn node(node: &Node) -> (Shape, Vec<Value>) {
    (Shape::Point(node.position), vec![text(node.kind.name()), Value::Integer(node.degree.into())])
}
