//! Entities as groups.

use super::Shape;
use super::frame::MODEL_SPACE;
use super::group::{Groups, Handles};
use super::plane::{angle, bulge, object};
use lineament::curve::{BSpline, Ellipse};
use lineament::math::vec3::norm;
use std::f64::consts::TAU;
use std::io;

/// Bits of group 70: of polylines and splines closed, of a POLYLINE in space, of a VERTEX on one.
const CLOSED: u8 = 1;
const POLYLINE_3D: u8 = 8;
const VERTEX_3D: u8 = 32;
/// Change of the parameter from which on an ellipse is whole, radians.
const WHOLE: f64 = TAU - 1e-9;
/// The code of an extrusion direction.
const NORMAL: u16 = 210;

impl Shape<'_> {
    /// The number of handles that it takes.
    pub(super) fn handles(&self) -> usize {
        match self {
            // Itself, its vertices, the end of their sequence.
            Shape::Polyline { points, .. } => points.len() + 2,
            _ => 1,
        }
    }

    /// Writes the entity, in model space.
    pub(super) fn write(&self, out: &mut Groups, layer: &str, handles: &mut Handles) -> io::Result<()> {
        let own = handles.next();
        let begin = |out: &mut Groups, kind, class| entity(out, kind, class, layer, [own, MODEL_SPACE]);
        match self {
            Shape::Point(at) => {
                begin(out, "POINT", "AcDbPoint")?;
                out.place(10, *at)
            }
            Shape::Line([from, to]) => {
                begin(out, "LINE", "AcDbLine")?;
                out.place(10, *from)?;
                out.place(11, *to)
            }
            Shape::Circle { centre, radius, normal } => {
                begin(out, "CIRCLE", "AcDbCircle")?;
                round(out, object(*normal, *centre), *radius, *normal)
            }
            Shape::Arc { centre, radius, normal, ends } => {
                begin(out, "ARC", "AcDbCircle")?;
                let centre = object(*normal, *centre);
                round(out, centre, *radius, *normal)?;
                out.put(100, "AcDbArc")?;
                let [from, to] = ends.map(|p| angle(centre, object(*normal, p)));
                out.real(50, from)?;
                out.real(51, to)
            }
            Shape::Ellipse { ellipse: found, from, sweep } => {
                begin(out, "ELLIPSE", "AcDbEllipse")?;
                ellipse(out, found, *from, *sweep)
            }
            Shape::Spline(curve) => {
                begin(out, "SPLINE", "AcDbSpline")?;
                spline(out, curve)
            }
            Shape::Flat { .. } => {
                begin(out, "LWPOLYLINE", "AcDbPolyline")?;
                self.flat(out)
            }
            Shape::Polyline { points, closed } => {
                begin(out, "POLYLINE", "AcDb3dPolyline")?;
                polyline(out, points, *closed, layer, (own, handles))
            }
            Shape::Text { at, height, text: letters, normal } => {
                begin(out, "TEXT", "AcDbText")?;
                text(out, (letters, *height), *at, *normal)
            }
        }
    }

    /// Vertices and bulges of a polyline in a plane.
    fn flat(&self, out: &mut Groups) -> io::Result<()> {
        let Shape::Flat { bends, closed, normal } = self else { return Ok(()) };
        let elevation = bends.first().map_or(0.0, |b| object(*normal, b.at)[2]);
        out.put(90, bends.len())?;
        out.put(70, u8::from(*closed))?;
        out.real(38, elevation)?;
        for bend in bends {
            let [x, y, _] = object(*normal, bend.at);
            out.place(10, [x, y])?;
            if bend.sweep != 0.0 {
                out.real(42, bulge(bend.sweep))?;
            }
        }
        out.place(NORMAL, *normal)
    }
}

/// The head of an entity with its own handle and that of its owner.
fn entity(
    out: &mut Groups,
    kind: &str,
    class: &str,
    layer: &str,
    [own, owner]: [usize; 2],
) -> io::Result<()> {
    out.put(0, kind)?;
    out.handle(5, own)?;
    out.handle(330, owner)?;
    out.put(100, "AcDbEntity")?;
    out.put(8, layer)?;
    if class.is_empty() { Ok(()) } else { out.put(100, class) }
}

fn round(out: &mut Groups, centre: [f64; 3], radius: f64, normal: [f64; 3]) -> io::Result<()> {
    out.place(10, centre)?;
    out.real(40, radius)?;
    out.place(NORMAL, normal)
}

fn text(out: &mut Groups, (letters, height): (&str, f64), at: [f64; 3], normal: [f64; 3]) -> io::Result<()> {
    out.place(10, object(normal, at))?;
    out.real(40, height)?;
    out.put(1, letters)?;
    out.place(NORMAL, normal)?;
    out.put(100, "AcDbText")
}

/// The place and the axes of an ellipse are those of the world.
fn ellipse(out: &mut Groups, found: &Ellipse, from: [f64; 3], sweep: f64) -> io::Result<()> {
    let whole = sweep >= WHOLE;
    let first = if whole { 0.0 } else { found.angle(from).rem_euclid(TAU) };
    out.place(10, found.centre)?;
    out.place(11, found.major)?;
    out.place(NORMAL, found.normal)?;
    out.real(40, found.minor / norm(found.major))?;
    out.real(41, first)?;
    out.real(42, if whole { TAU } else { (first + sweep).rem_euclid(TAU) })
}

fn polyline(
    out: &mut Groups,
    points: &[[f64; 3]],
    closed: bool,
    layer: &str,
    (own, handles): (usize, &mut Handles),
) -> io::Result<()> {
    out.put(66, 1)?;
    out.place(10, [0.0; 3])?;
    out.put(70, POLYLINE_3D | if closed { CLOSED } else { 0 })?;
    for &position in points {
        entity(out, "VERTEX", "AcDbVertex", layer, [handles.next(), own])?;
        out.put(100, "AcDb3dPolylineVertex")?;
        out.place(10, position)?;
        out.put(70, VERTEX_3D)?;
    }
    entity(out, "SEQEND", "", layer, [handles.next(), own])
}

fn spline(out: &mut Groups, curve: &BSpline) -> io::Result<()> {
    out.put(70, if curve.periodic { CLOSED } else { 0 })?;
    // Many programs take no knots beyond the ends.
    let curve = curve.clamped();
    for (code, number) in [(71, curve.degree), (72, curve.knots.len()), (73, curve.controls.len()), (74, 0)] {
        out.put(code, number)?;
    }
    curve.knots.iter().try_for_each(|&knot| out.real(40, knot))?;
    curve.controls.iter().try_for_each(|&control| out.place(10, control))
}
