//! Sections in the schema `lineament-section/1`, which `docs/schema-section-1.md` describes. Its `strips` have the
//! form of a network's: points, closed; with the index of their plane.

use super::context::SectionContext;
use crate::write::encode::json::{Head, Number, Point, Text, lines, list};
use lineament::curve::{BSpline, Ellipse};
use lineament::params::ParamValue;
use lineament::section::{Contour, CurvePiece, CurveShape, Feature, Mirror, Repeat, Run, Section, Sections};
use rayon::prelude::*;
use std::io::{self, Write};

/// The name of the schema, as it stands in every file.
const SCHEMA: &str = "lineament-section/1";

/// Writes sections: a line for each plane, contour and feature.
pub(super) fn write(out: &mut dyn Write, sections: &Sections, context: &SectionContext) -> io::Result<()> {
    Head {
        schema: SCHEMA,
        version: &context.program_version,
        input: &context.input_name,
        sha256: context.input_sha256.as_deref(),
        points: context.input_points,
    }
    .write(out)?;
    let [u, v, w] = &sections.frame.axes;
    writeln!(out, "\"axes\": [{}, {}, {}],", Point(u), Point(v), Point(w))?;
    let (zero, place) = sections.zero;
    writeln!(out, "\"from\": \"{}\",\n\"zero\": {},", zero.show(), Number(place))?;
    writeln!(out, "\"spacing\": {},", Number(sections.spacing))?;
    writeln!(out, "\"noise\": {},", Number(sections.noise * sections.spacing))?;
    write!(out, "\"planes\": [")?;
    lines(out, &sections.sections, plane)?;
    let all: Vec<(usize, usize, &Contour)> = sections
        .sections
        .iter()
        .flat_map(|s| s.contours.iter().enumerate().map(|(i, c)| (s.plane, i, c)))
        .collect();
    write!(out, "],\n\"strips\": [")?;
    strips(out, &all)?;
    write!(out, "],\n\"features\": [")?;
    lines(out, &context.stack.runs, run)?;
    write!(out, "],\n\"mirrors\": [")?;
    lines(out, &context.stack.mirrors, mirror)?;
    write!(out, "],\n\"repeats\": [")?;
    lines(out, &context.stack.repeats, repeat)?;
    writeln!(out, "]\n}}")
}

fn plane(out: &mut dyn Write, _: usize, section: &Section) -> io::Result<()> {
    let Section { plane, height, slab, points, contours, missing } = section;
    write!(out, "{{\"plane\": {plane}, \"height\": {}, \"slab\": ", Number(*height))?;
    match slab {
        Some([from, to]) => write!(out, "[{}, {}]", Number(*from), Number(*to))?,
        None => write!(out, "null")?,
    }
    write!(out, ", \"points\": {points}, ")?;
    write!(out, "\"contours\": {}, \"missing\": ", contours.len())?;
    match missing {
        Some(missing) => write!(out, "{}}}", Text(&missing.reason())),
        None => write!(out, "null}}"),
    }
}

/// Contours are put in words side by side, this many at a time.
const BATCH: usize = 128;

/// [`lines`] of contours: their numbers are most of a file, and of the time it takes.
fn strips(out: &mut dyn Write, all: &[(usize, usize, &Contour)]) -> io::Result<()> {
    for (b, batch) in all.chunks(BATCH).enumerate() {
        let text = |(i, contour): (usize, &(usize, usize, &Contour))| {
            let id = b * BATCH + i;
            let mut text = Vec::from(if id > 0 { ",\n" } else { "\n" });
            strip(&mut text, id, contour).map(|()| text)
        };
        let texts: Vec<io::Result<Vec<u8>>> = batch.par_iter().enumerate().map(text).collect();
        for text in texts {
            out.write_all(&text?)?;
        }
    }
    if all.is_empty() { Ok(()) } else { writeln!(out) }
}

fn strip(out: &mut dyn Write, id: usize, (plane, index, c): &(usize, usize, &Contour)) -> io::Result<()> {
    write!(out, "{{\"id\": {id}, \"plane\": {plane}, \"index\": {index}, \"closed\": {}, ", c.closed)?;
    match c.parent {
        Some(parent) => write!(out, "\"parent\": {parent}, ")?,
        None => write!(out, "\"parent\": null, ")?,
    }
    write!(out, "\"depth\": {}, \"area\": {}, ", c.depth, Number(c.area))?;
    write!(out, "\"length\": {}, \"draft_deg\": ", Number(c.length))?;
    write!(out, "{}, \"steepest_deg\": ", Number(c.draft_deg.unwrap_or(f64::NAN)))?;
    write!(out, "{}, \"centroid\": {}, ", Number(c.steepest_deg), Point(&c.centroid))?;
    write!(out, "\"points\": [")?;
    list(out, &c.points, |out, _, point| write!(out, "{}", Point(point)))?;
    write!(out, "], \"corners\": [")?;
    list(out, &c.corners, |out, _, corner| write!(out, "{corner}"))?;
    write!(out, "], \"pieces\": [")?;
    list(out, &c.pieces, |out, _, p| piece(out, p))?;
    write!(out, "]}}")
}

fn piece(out: &mut dyn Write, piece: &CurvePiece) -> io::Result<()> {
    write!(out, "{{\"type\": \"{}\", \"from\": {}, ", piece.shape.name(), Point(&piece.from))?;
    write!(out, "\"to\": {}, \"worst\": {}", Point(&piece.to), Number(piece.worst))?;
    match &piece.shape {
        CurveShape::Line => {}
        CurveShape::Circle { centre, radius } => {
            write!(out, ", \"centre\": {}, \"radius\": {}", Point(centre), Number(*radius))?;
        }
        CurveShape::Arc { centre, radius, sweep_deg } => {
            write!(out, ", \"centre\": {}, \"radius\": {}", Point(centre), Number(*radius))?;
            write!(out, ", \"sweep_deg\": {}", Number(*sweep_deg))?;
        }
        CurveShape::Ellipse { ellipse: Ellipse { centre, major, minor, .. }, sweep_deg } => {
            write!(out, ", \"centre\": {}, \"major\": {}", Point(centre), Point(major))?;
            write!(out, ", \"minor\": {}, \"sweep_deg\": {}", Number(*minor), Number(*sweep_deg))?;
        }
        CurveShape::Spline(BSpline { degree, knots, controls, .. }) => {
            write!(out, ", \"degree\": {degree}, \"knots\": [")?;
            list(out, knots, |out, _, &knot| write!(out, "{}", Number(knot)))?;
            write!(out, "], \"controls\": [")?;
            list(out, controls, |out, _, control| write!(out, "{}", Point(control)))?;
            write!(out, "]")?;
        }
    }
    write!(out, "}}")
}

fn run(out: &mut dyn Write, id: usize, run: &Run) -> io::Result<()> {
    write!(out, "{{\"id\": {id}, \"kind\": \"{}\", \"hole\": {}, ", run.feature.name(), run.hole)?;
    write!(out, "\"from\": {}, \"to\": {}, ", Number(run.from), Number(run.to))?;
    write!(out, "\"range_error\": [{}, {}], ", Number(run.range_error[0]), Number(run.range_error[1]))?;
    write!(out, "\"residual\": {}, \"centre\": {}, ", Number(run.residual), Point(&run.centre))?;
    match run.feature {
        Feature::Extrusion { radius: Some(radius) } => write!(out, "\"radius\": {}, ", Number(radius))?,
        Feature::Extrusion { radius: None } => write!(out, "\"radius\": null, ")?,
        Feature::Taper { angle_deg, apex, radius } => {
            write!(out, "\"angle_deg\": {}, \"apex\": {}, ", Number(angle_deg), Number(apex))?;
            write!(out, "\"radius\": {}, ", Number(radius.unwrap_or(f64::NAN)))?;
        }
        Feature::Revolution { least, most } => {
            write!(out, "\"least_radius\": {}, \"most_radius\": {}, ", Number(least), Number(most))?;
        }
    }
    write!(out, "\"contours\": [")?;
    list(out, &run.contours, |out, _, (plane, index)| write!(out, "[{plane}, {index}]"))?;
    write!(out, "]}}")
}

fn mirror(out: &mut dyn Write, _: usize, mirror: &Mirror) -> io::Result<()> {
    write!(out, "{{\"point\": {}, \"normal\": {}, ", Point(&mirror.point), Point(&mirror.normal))?;
    write!(out, "\"planes\": {}, \"residual\": {}}}", mirror.planes, Number(mirror.residual))
}

fn repeat(out: &mut dyn Write, _: usize, repeat: &Repeat) -> io::Result<()> {
    write!(out, "{{\"runs\": [")?;
    list(out, &repeat.runs, |out, _, run| write!(out, "{run}"))?;
    write!(out, "], \"residual\": {}}}", Number(repeat.residual))
}
