//! DXF, release 12 (AC1009): the oldest release with 3D polylines, which every CAD program opens. A file is a header,
//! tables of line types and layers, and entities. Group codes, object coordinates and the arbitrary axis algorithm are
//! those of the AutoCAD DXF reference. The release knows no unit: lengths are those of the input.

use lineament::math::vec3::{cross, dot, unit};
use std::io::{self, Write};

/// Bits of group 70: of a POLYLINE closed and 3D, of a VERTEX on a 3D polyline.
const CLOSED: u8 = 1;
const POLYLINE_3D: u8 = 8;
const VERTEX_3D: u8 = 32;

/// A layer: its name and its colour (AutoCAD colour index).
pub(in crate::write) type Layer = (String, u8);

/// Header, tables and the beginning of the entities. `extent` is the least and the greatest corner of the drawing, if
/// known; layer 0 is added.
pub(in crate::write) fn begin(
    out: &mut dyn Write,
    extent: Option<[[f64; 3]; 2]>,
    layers: &[Layer],
) -> io::Result<()> {
    write!(out, "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n")?;
    if let Some([low, high]) = extent {
        write!(out, "9\n$EXTMIN\n")?;
        place(out, 10, low)?;
        write!(out, "9\n$EXTMAX\n")?;
        place(out, 10, high)?;
    }
    write!(out, "0\nENDSEC\n0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLTYPE\n70\n1\n")?;
    write!(out, "0\nLTYPE\n2\nCONTINUOUS\n70\n0\n3\nSolid line\n72\n65\n73\n0\n40\n0.0\n0\nENDTAB\n")?;
    write!(out, "0\nTABLE\n2\nLAYER\n70\n{}\n", layers.len() + 1)?;
    for (name, colour) in [("0", 7)].into_iter().chain(layers.iter().map(|(n, c)| (n.as_str(), *c))) {
        write!(out, "0\nLAYER\n2\n{name}\n70\n0\n62\n{colour}\n6\nCONTINUOUS\n")?;
    }
    write!(out, "0\nENDTAB\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n")
}

/// The end of the entities and of the file.
pub(in crate::write) fn end(out: &mut dyn Write) -> io::Result<()> {
    write!(out, "0\nENDSEC\n0\nEOF\n")
}

/// A POINT.
pub(in crate::write) fn point(out: &mut dyn Write, layer: &str, position: [f64; 3]) -> io::Result<()> {
    entity(out, "POINT", layer)?;
    place(out, 10, position)
}

/// A LINE.
pub(in crate::write) fn line(out: &mut dyn Write, layer: &str, ends: [[f64; 3]; 2]) -> io::Result<()> {
    entity(out, "LINE", layer)?;
    place(out, 10, ends[0])?;
    place(out, 11, ends[1])
}

/// A 3D POLYLINE. A closed one does not repeat its first point.
pub(in crate::write) fn polyline(
    out: &mut dyn Write,
    layer: &str,
    points: &[[f64; 3]],
    closed: bool,
) -> io::Result<()> {
    let flags = POLYLINE_3D | if closed { CLOSED } else { 0 };
    entity(out, "POLYLINE", layer)?;
    write!(out, "66\n1\n")?;
    place(out, 10, [0.0; 3])?;
    write!(out, "70\n{flags}\n")?;
    for &position in points {
        entity(out, "VERTEX", layer)?;
        place(out, 10, position)?;
        write!(out, "70\n{VERTEX_3D}\n")?;
    }
    entity(out, "SEQEND", layer)
}

/// A CIRCLE in the plane across `normal`.
pub(in crate::write) fn circle(
    out: &mut dyn Write,
    layer: &str,
    (centre, radius): ([f64; 3], f64),
    normal: [f64; 3],
) -> io::Result<()> {
    entity(out, "CIRCLE", layer)?;
    place(out, 10, object(normal, centre))?;
    write!(out, "40\n{radius:?}\n")?;
    extrusion(out, normal)
}

/// An ARC in the plane across `normal`, counter-clockwise from the first of `ends` to the second.
pub(in crate::write) fn arc(
    out: &mut dyn Write,
    layer: &str,
    (centre, radius): ([f64; 3], f64),
    ends: [[f64; 3]; 2],
    normal: [f64; 3],
) -> io::Result<()> {
    let centre = object(normal, centre);
    let [from, to] = ends.map(|p| angle(centre, object(normal, p)));
    entity(out, "ARC", layer)?;
    place(out, 10, centre)?;
    write!(out, "40\n{radius:?}\n50\n{from:?}\n51\n{to:?}\n")?;
    extrusion(out, normal)
}

/// A TEXT of this letter height in the plane across `normal`.
pub(in crate::write) fn text(
    out: &mut dyn Write,
    layer: &str,
    (position, height): ([f64; 3], f64),
    text: &str,
    normal: [f64; 3],
) -> io::Result<()> {
    entity(out, "TEXT", layer)?;
    place(out, 10, object(normal, position))?;
    write!(out, "40\n{height:?}\n1\n{text}\n")?;
    extrusion(out, normal)
}

fn entity(out: &mut dyn Write, kind: &str, layer: &str) -> io::Result<()> {
    write!(out, "0\n{kind}\n8\n{layer}\n")
}

/// A position in three groups: 10, 20 and 30 if `first` is 10.
fn place(out: &mut dyn Write, first: u8, position: [f64; 3]) -> io::Result<()> {
    for (step, value) in [0, 10, 20].into_iter().zip(position) {
        writeln!(out, "{}\n{value:?}", first + step)?;
    }
    Ok(())
}

/// The direction across the plane of an entity.
fn extrusion(out: &mut dyn Write, normal: [f64; 3]) -> io::Result<()> {
    place(out, 210, normal)
}

/// Object coordinates for an extrusion direction: the arbitrary axis algorithm.
fn object(n: [f64; 3], p: [f64; 3]) -> [f64; 3] {
    let small = n[0].abs() < 1.0 / 64.0 && n[1].abs() < 1.0 / 64.0;
    let other = if small { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] };
    let x = unit(cross(other, n));
    let y = unit(cross(n, x));
    [dot(x, p), dot(y, p), dot(n, p)]
}

/// Degrees from 0 to 360, in object coordinates.
fn angle(centre: [f64; 3], p: [f64; 3]) -> f64 {
    (p[1] - centre[1]).atan2(p[0] - centre[0]).to_degrees().rem_euclid(360.0)
}
