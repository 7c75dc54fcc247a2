//! A network as DXF: lines, arcs, circles, ellipses and splines of each strip, a 3D POLYLINE where it has no typed curves, and a POINT for each
//! node, each on the layer of its kind.

use super::context::NetworkContext;
use crate::write::encode::dxf::{Drawing, Shape};
use lineament::curve::pieces::{self, Piece};
use lineament::{Network, NodeKind, Strip, StripKind};
use std::io::{self, Write};

/// Layers with their colours: strips and nodes by kind.
const LAYERS: [(&str, u8); 7] =
    [("CREASE", 1), ("BORDER", 5), ("JUNCTION", 3), ("CORNER", 2), ("END", 6), ("APEX", 4), ("ROUNDED", 30)];

/// Angle from which on an arc is a whole circle, radians.
const WHOLE: f64 = std::f64::consts::TAU - 1e-9;

/// Writes strips and nodes.
pub(super) fn write(out: &mut dyn Write, network: &Network, context: &NetworkContext) -> io::Result<()> {
    let strips = network.strips.iter().flat_map(|s| shapes(s).map(|shape| (strip_layer(s.kind), shape)));
    let nodes = network.nodes.iter().map(|n| (node_layer(n.kind), Shape::Point(n.position)));
    let layers = LAYERS.map(|(name, colour)| (name.into(), colour)).to_vec();
    Drawing { unit: context.known_unit(), layers, entities: strips.chain(nodes).collect() }.write(out)
}

fn shapes(strip: &Strip) -> impl Iterator<Item = Shape<'_>> {
    let untyped = (strip.curves.is_empty() && strip.points.len() > 1)
        .then(|| Shape::Polyline { points: (&strip.points).into(), closed: strip.closed });
    strip.curves.iter().map(piece).chain(untyped)
}

/// A typed curve as an entity.
pub(in crate::write) fn piece(piece: &Piece) -> Shape<'_> {
    let ends = [piece.from, piece.to];
    match &piece.shape {
        pieces::Shape::Line => Shape::Line(ends),
        pieces::Shape::Arc { round, sweep } if *sweep < WHOLE => {
            Shape::Arc { centre: round.centre, radius: round.radius, normal: round.normal, ends }
        }
        // An arc from a node to the same node: programs would take its equal angles for no arc at all.
        pieces::Shape::Circle(round) | pieces::Shape::Arc { round, .. } => {
            Shape::Circle { centre: round.centre, radius: round.radius, normal: round.normal }
        }
        pieces::Shape::Ellipse { ellipse, sweep } => {
            Shape::Ellipse { ellipse: *ellipse, from: ends[0], sweep: *sweep }
        }
        pieces::Shape::Spline(curve) => Shape::Spline(curve),
    }
}

fn strip_layer(kind: StripKind) -> usize {
    match kind {
        StripKind::Crease => 0,
        StripKind::Border => 1,
        StripKind::Rounded => 6,
    }
}

fn node_layer(kind: NodeKind) -> usize {
    match kind {
        NodeKind::Junction => 2,
        NodeKind::Corner => 3,
        NodeKind::End => 4,
        NodeKind::Apex => 5,
    }
}
