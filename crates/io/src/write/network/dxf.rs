//! A network as DXF: a 3D POLYLINE for each strip and a POINT for each node, each on the layer of its kind.

use crate::write::encode::dxf;
use lineament::{Network, NodeKind, StripKind};
use std::io::{self, Write};

/// Layers with their colours: strips and nodes by kind.
const LAYERS: [(&str, u8); 6] =
    [("CREASE", 1), ("BORDER", 5), ("JUNCTION", 3), ("CORNER", 2), ("END", 6), ("APEX", 4)];

/// Writes strips and nodes. Closed strips carry the closed flag and do not repeat their first point.
pub(super) fn write(out: &mut dyn Write, network: &Network) -> io::Result<()> {
    dxf::begin(out, extent(network), &LAYERS.map(|(name, colour)| (name.into(), colour)))?;
    for strip in network.strips.iter().filter(|strip| strip.points.len() > 1) {
        dxf::polyline(out, strip_layer(strip.kind), &strip.points, strip.closed)?;
    }
    for node in &network.nodes {
        dxf::point(out, node_layer(node.kind), node.position)?;
    }
    dxf::end(out)
}

/// Least and greatest corner of all points; `None` if there are none.
pub(in crate::write) fn extent(network: &Network) -> Option<[[f64; 3]; 2]> {
    let points =
        || network.strips.iter().flat_map(|s| &s.points).chain(network.nodes.iter().map(|n| &n.position));
    let first = *points().next()?;
    Some(
        [f64::min as fn(f64, f64) -> f64, f64::max]
            .map(|pick| points().fold(first, |a, p| [pick(a[0], p[0]), pick(a[1], p[1]), pick(a[2], p[2])])),
    )
}

fn strip_layer(kind: StripKind) -> &'static str {
    match kind {
        StripKind::Crease => "CREASE",
        StripKind::Border => "BORDER",
    }
}

fn node_layer(kind: NodeKind) -> &'static str {
    match kind {
        NodeKind::Junction => "JUNCTION",
        NodeKind::Corner => "CORNER",
        NodeKind::End => "END",
        NodeKind::Apex => "APEX",
    }
}
