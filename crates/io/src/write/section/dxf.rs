//! Sections as DXF, release 12 (AC1009), a layer a slice, for further editing: lines, arcs and circles as such where
//! curves were fitted, splines as 3D polylines, for the release has none. Each run of the stack is named by a text at its
//! middle, on a layer of its kind. The release knows no unit: lengths are those of the input. Group codes, object
//! coordinates and the arbitrary axis algorithm are those of the AutoCAD DXF reference.

use lineament::curve::BSpline;
use lineament::math::vec3::{cross, dot, unit};
use lineament::section::{CurvePiece, CurveShape, Feature, Run, Sections, Stack};
use std::io::{self, Write};

/// Points a spline is written with, for each of its spans.
const SPAN_POINTS: usize = 8;
/// Layers of the names of runs.
const FEATURES: [&str; 4] = ["HOLE", "EXTRUSION", "TAPER", "REVOLUTION"];
/// Height of their letters, in spacings.
const LETTERS: f64 = 4.0;

pub(super) fn write(out: &mut dyn Write, sections: &Sections, stack: &Stack) -> io::Result<()> {
    write!(out, "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n")?;
    tables(out, sections)?;
    write!(out, "0\nSECTION\n2\nENTITIES\n")?;
    let normal = sections.frame.axes[2];
    for (plane, contour) in sections.contours() {
        let layer = layer(plane);
        if contour.pieces.is_empty() {
            polyline(out, &layer, &contour.points, contour.closed)?;
        }
        for piece in &contour.pieces {
            entity(out, &layer, piece, normal)?;
        }
    }
    for run in &stack.runs {
        named(out, run, LETTERS * sections.spacing, normal)?;
    }
    write!(out, "0\nENDSEC\n0\nEOF\n")
}

/// The name of a run, with its radius and range.
fn named(out: &mut dyn Write, run: &Run, height: f64, normal: [f64; 3]) -> io::Result<()> {
    let kind = run.feature.name();
    let layer = if run.hole { "HOLE".into() } else { kind.to_uppercase() };
    let hole = if run.hole { " hole" } else { "" };
    let round = match run.feature {
        Feature::Extrusion { radius: Some(r) } | Feature::Taper { radius: Some(r), .. } => {
            format!(" r {r:.6}")
        }
        Feature::Revolution { least, most } => format!(" r {least:.6} to {most:.6}"),
        _ => String::new(),
    };
    write!(out, "0\nTEXT\n8\n{layer}\n")?;
    point(out, 0, object(normal, run.centre))?;
    write!(out, "40\n{height:?}\n1\n{kind}{hole}{round} from {:.6} to {:.6}\n", run.from, run.to)?;
    extrusion(out, normal)
}

fn layer(plane: usize) -> String {
    format!("SLICE_{plane:04}")
}

fn tables(out: &mut dyn Write, sections: &Sections) -> io::Result<()> {
    write!(out, "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLTYPE\n70\n1\n")?;
    write!(out, "0\nLTYPE\n2\nCONTINUOUS\n70\n0\n3\nSolid line\n72\n65\n73\n0\n40\n0.0\n0\nENDTAB\n")?;
    write!(out, "0\nTABLE\n2\nLAYER\n70\n{}\n", sections.sections.len() + FEATURES.len() + 1)?;
    write!(out, "0\nLAYER\n2\n0\n70\n0\n62\n7\n6\nCONTINUOUS\n")?;
    for section in &sections.sections {
        let colour = section.plane % 6 + 1;
        write!(out, "0\nLAYER\n2\n{}\n70\n0\n62\n{colour}\n6\nCONTINUOUS\n", layer(section.plane))?;
    }
    for name in FEATURES {
        write!(out, "0\nLAYER\n2\n{name}\n70\n0\n62\n7\n6\nCONTINUOUS\n")?;
    }
    write!(out, "0\nENDTAB\n0\nENDSEC\n")
}

fn entity(out: &mut dyn Write, layer: &str, piece: &CurvePiece, normal: [f64; 3]) -> io::Result<()> {
    match &piece.shape {
        CurveShape::Line => {
            write!(out, "0\nLINE\n8\n{layer}\n")?;
            point(out, 0, piece.from)?;
            point(out, 1, piece.to)
        }
        CurveShape::Circle { centre, radius } => {
            write!(out, "0\nCIRCLE\n8\n{layer}\n")?;
            point(out, 0, object(normal, *centre))?;
            write!(out, "40\n{radius:?}\n")?;
            extrusion(out, normal)
        }
        CurveShape::Arc { centre, radius, sweep_deg } => {
            // An arc runs counter-clockwise: one swept the other way begins at its end.
            let (from, to) = if *sweep_deg < 0.0 { (piece.to, piece.from) } else { (piece.from, piece.to) };
            write!(out, "0\nARC\n8\n{layer}\n")?;
            point(out, 0, object(normal, *centre))?;
            let angle = |p| angle(object(normal, *centre), object(normal, p));
            write!(out, "40\n{radius:?}\n50\n{:?}\n51\n{:?}\n", angle(from), angle(to))?;
            extrusion(out, normal)
        }
        CurveShape::Spline(spline) => polyline(out, layer, &sampled(spline), false),
    }
}

fn sampled(spline: &BSpline) -> Vec<[f64; 3]> {
    let spans = spline.controls.len().saturating_sub(spline.degree).max(1);
    let last = spline.knots.last().copied().unwrap_or(0.0);
    let count = spans * SPAN_POINTS;
    (0..=count).map(|k| spline.point(last * k as f64 / count as f64)).collect()
}

fn polyline(out: &mut dyn Write, layer: &str, points: &[[f64; 3]], closed: bool) -> io::Result<()> {
    write!(out, "0\nPOLYLINE\n8\n{layer}\n66\n1\n")?;
    point(out, 0, [0.0; 3])?;
    write!(out, "70\n{}\n", 8 + u8::from(closed))?;
    for &p in points {
        write!(out, "0\nVERTEX\n8\n{layer}\n")?;
        point(out, 0, p)?;
        write!(out, "70\n32\n")?;
    }
    write!(out, "0\nSEQEND\n8\n{layer}\n")
}

/// Groups 10, 20, 30, or with `which` 1: 11, 21, 31.
fn point(out: &mut dyn Write, which: u8, position: [f64; 3]) -> io::Result<()> {
    for (code, value) in [10, 20, 30].into_iter().zip(position) {
        writeln!(out, "{}\n{value:?}", code + which)?;
    }
    Ok(())
}

fn extrusion(out: &mut dyn Write, normal: [f64; 3]) -> io::Result<()> {
    for (code, value) in [210, 220, 230].into_iter().zip(normal) {
        writeln!(out, "{code}\n{value:?}")?;
    }
    Ok(())
}

/// Object coordinates for an extrusion direction: the arbitrary axis algorithm.
fn object(n: [f64; 3], p: [f64; 3]) -> [f64; 3] {
    let small = n[0].abs() < 1.0 / 64.0 && n[1].abs() < 1.0 / 64.0;
    let other = if small { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] };
    let x = unit(cross(other, n));
    let y = unit(cross(n, x));
    [dot(x, p), dot(y, p), dot(n, p)]
}

fn angle(centre: [f64; 3], p: [f64; 3]) -> f64 {
    (p[1] - centre[1]).atan2(p[0] - centre[0]).to_degrees().rem_euclid(360.0)
}
