//! A network as DXF, release 12 (AC1009): the oldest release with 3D polylines, which every CAD program opens.
//! Group codes are those of the AutoCAD DXF reference.

use lineament::{Network, NodeKind, Strip, StripKind};
use std::io::{self, Write};

/// Layer names with their colours (AutoCAD colour index): strips and nodes by kind.
const LAYERS: [(&str, u8); 6] =
    [("CREASE", 1), ("BORDER", 5), ("JUNCTION", 3), ("CORNER", 2), ("END", 6), ("APEX", 4)];

/// Bits of group 70: of a POLYLINE closed and 3D, of a VERTEX on a 3D polyline.
const CLOSED: u8 = 1;
const POLYLINE_3D: u8 = 8;
const VERTEX_3D: u8 = 32;

/// Writes a 3D POLYLINE a strip and a POINT a node, each on the layer of its kind. Closed strips carry the closed
/// flag and do not repeat their first point.
pub(super) fn write(out: &mut dyn Write, network: &Network) -> io::Result<()> {
    header(out, network)?;
    tables(out, &LAYERS.map(|(name, colour)| (name.into(), colour)))?;
    write!(out, "0\nSECTION\n2\nENTITIES\n")?;
    for strip in &network.strips {
        polyline(out, strip)?;
    }
    for node in &network.nodes {
        write!(out, "0\nPOINT\n8\n{}\n", node_layer(node.kind))?;
        point(out, node.position)?;
    }
    write!(out, "0\nENDSEC\n0\nEOF\n")
}

pub(super) fn header(out: &mut dyn Write, network: &Network) -> io::Result<()> {
    write!(out, "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n")?;
    let points =
        || network.strips.iter().flat_map(|s| &s.points).chain(network.nodes.iter().map(|n| &n.position));
    if let Some(&first) = points().next() {
        let fold = |f: fn(f64, f64) -> f64| {
            points().fold(first, |a, p| [f(a[0], p[0]), f(a[1], p[1]), f(a[2], p[2])])
        };
        write!(out, "9\n$EXTMIN\n")?;
        point(out, fold(f64::min))?;
        write!(out, "9\n$EXTMAX\n")?;
        point(out, fold(f64::max))?;
    }
    write!(out, "0\nENDSEC\n")
}

/// The tables of line types and of layers, names with their colours; layer 0 is there always.
pub(super) fn tables(out: &mut dyn Write, layers: &[(String, u8)]) -> io::Result<()> {
    write!(out, "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLTYPE\n70\n1\n")?;
    write!(out, "0\nLTYPE\n2\nCONTINUOUS\n70\n0\n3\nSolid line\n72\n65\n73\n0\n40\n0.0\n0\nENDTAB\n")?;
    write!(out, "0\nTABLE\n2\nLAYER\n70\n{}\n", layers.len() + 1)?;
    for (name, colour) in [("0", 7)].into_iter().chain(layers.iter().map(|(n, c)| (n.as_str(), *c))) {
        write!(out, "0\nLAYER\n2\n{name}\n70\n0\n62\n{colour}\n6\nCONTINUOUS\n")?;
    }
    write!(out, "0\nENDTAB\n0\nENDSEC\n")
}

fn polyline(out: &mut dyn Write, strip: &Strip) -> io::Result<()> {
    polyline_on(out, strip_layer(strip.kind), &strip.points, strip.closed)
}

/// A 3D polyline on a layer. A closed one does not repeat its first point.
pub(super) fn polyline_on(
    out: &mut dyn Write,
    layer: &str,
    points: &[[f64; 3]],
    closed: bool,
) -> io::Result<()> {
    if points.len() < 2 {
        return Ok(());
    }
    let flags = POLYLINE_3D | if closed { CLOSED } else { 0 };
    write!(out, "0\nPOLYLINE\n8\n{layer}\n66\n1\n")?;
    point(out, [0.0; 3])?;
    write!(out, "70\n{flags}\n")?;
    for &position in points {
        write!(out, "0\nVERTEX\n8\n{layer}\n")?;
        point(out, position)?;
        write!(out, "70\n{VERTEX_3D}\n")?;
    }
    write!(out, "0\nSEQEND\n8\n{layer}\n")
}

/// Groups 10, 20 and 30.
fn point(out: &mut dyn Write, position: [f64; 3]) -> io::Result<()> {
    for (code, value) in [10, 20, 30].into_iter().zip(position) {
        writeln!(out, "{}\n{value:?}", code)?;
    }
    Ok(())
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
