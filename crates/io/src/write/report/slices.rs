//! Sections of a report, and the features of their stack.

use super::lines::{step, thinned};
use crate::write::encode::json::{Number, Point, Text, lines, list};
use base64::prelude::{BASE64_STANDARD, Engine};
use lineament::section::{Contour, CurvePiece, CurveShape, Feature, Run, Section, Sections, Stack};
use std::io::{self, Write};

/// Most points of all contours together that are written; of more every second, third ... point is.
const MOST: usize = 250_000;

pub(super) fn write(out: &mut dyn Write, sections: &Sections, stack: &Stack) -> io::Result<()> {
    let step = step(sections.contours().map(|(_, c)| c.points.len()).sum(), MOST);
    // Contours are written in f32, so they count from a corner of their own.
    let corner = sections.contours().flat_map(|(_, c)| &c.points).copied().reduce(least).unwrap_or_default();
    write!(out, "\"sections\": {{\"axes\": [")?;
    list(out, &sections.frame.axes, |out, _, axis| write!(out, "{}", Point(axis)))?;
    writeln!(out, "], \"zero\": {}, \"corner\": {},", Number(sections.zero.1), Point(&corner))?;
    write!(out, "\"planes\": [")?;
    lines(out, &sections.sections, |out, _, s| plane(out, s, step))?;
    write!(out, "], \"runs\": [")?;
    lines(out, &stack.runs, run)?;
    write!(out, "], \"coordinates\": \"")?;
    let all = sections.contours().flat_map(|(_, c)| thinned(&c.points, step));
    let near = all.flat_map(|p| [0, 1, 2].map(|k| (p[k] - corner[k]) as f32));
    let bytes: Vec<u8> = near.flat_map(f32::to_le_bytes).collect();
    out.write_all(BASE64_STANDARD.encode(bytes).as_bytes())?;
    writeln!(out, "\"}},")
}

fn least(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| a[k].min(b[k]))
}

fn plane(out: &mut dyn Write, section: &Section, step: usize) -> io::Result<()> {
    write!(out, "{{\"height\": {}, ", Number(section.height))?;
    if let Some(missing) = section.missing {
        write!(out, "\"missing\": {}, ", Text(&missing.reason()))?;
    }
    write!(out, "\"contours\": [")?;
    list(out, &section.contours, |out, _, contour| {
        let Contour { points, closed, depth, area, length, pieces, .. } = contour;
        let count = thinned(points, step).count();
        write!(out, "{{\"closed\": {closed}, \"depth\": {depth}, \"area\": {}, ", Number(*area))?;
        write!(out, "\"length\": {}, \"count\": {count}, \"curves\": [", Number(*length))?;
        list(out, pieces, |out, _, p| piece(out, p))?;
        write!(out, "]}}")
    })?;
    write!(out, "]}}")
}

fn piece(out: &mut dyn Write, piece: &CurvePiece) -> io::Result<()> {
    write!(out, "{{\"type\": \"{}\"", piece.shape.name())?;
    match piece.shape {
        CurveShape::Arc { radius, .. } | CurveShape::Circle { radius, .. } => {
            write!(out, ", \"radius\": {}", Number(radius))?;
        }
        CurveShape::Line | CurveShape::Ellipse { .. } | CurveShape::Spline(_) => {}
    }
    write!(out, "}}")
}

fn run(out: &mut dyn Write, _: usize, run: &Run) -> io::Result<()> {
    let Run { feature, hole, from, to, range_error: [from_error, to_error], residual, centre, contours } =
        run;
    write!(out, "{{\"feature\": \"{}\", \"hole\": {hole}, ", feature.name())?;
    write!(out, "\"from\": {}, \"to\": {}, ", Number(*from), Number(*to))?;
    write!(out, "\"range_error\": [{}, {}], ", Number(*from_error), Number(*to_error))?;
    let (least, most) = match *feature {
        Feature::Extrusion { radius } | Feature::Taper { radius, .. } => (radius, radius),
        Feature::Revolution { least, most } => (Some(least), Some(most)),
    };
    let [least, most] = [least, most].map(|r| Number(r.unwrap_or(f64::NAN)));
    write!(out, "\"radius\": [{least}, {most}], ")?;
    if let Feature::Taper { angle_deg, .. } = feature {
        write!(out, "\"angle_deg\": {}, ", Number(*angle_deg))?;
    }
    write!(out, "\"residual\": {}, \"center\": {}, \"contours\": [", Number(*residual), Point(centre))?;
    list(out, contours, |out, _, (plane, index)| write!(out, "[{plane}, {index}]"))?;
    write!(out, "]}}")
}
