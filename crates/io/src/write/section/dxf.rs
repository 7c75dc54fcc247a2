//! Sections as DXF for further editing, a layer for each slice: lines, arcs and circles as such where curves were fitted,
//! splines as 3D polylines, which are the nearest thing that the release has. A text at the middle of each run of the
//! stack names it, on a layer of its kind.

use crate::write::encode::dxf;
use lineament::curve::BSpline;
use lineament::section::{CurvePiece, CurveShape, Feature, Run, Sections, Stack};
use std::io::{self, Write};

/// Points of a written spline, for each of its spans.
const SPAN_POINTS: usize = 8;
/// Layers of the names of runs.
const FEATURES: [&str; 4] = ["HOLE", "EXTRUSION", "TAPER", "REVOLUTION"];
/// Colour of these layers: white, or black on white.
const WHITE: u8 = 7;
/// Height of their letters, in spacings.
const LETTERS: f64 = 4.0;

pub(super) fn write(out: &mut dyn Write, sections: &Sections, stack: &Stack) -> io::Result<()> {
    let slices = sections.sections.iter().map(|s| (layer(s.plane), (s.plane % 6 + 1) as u8));
    let layers: Vec<dxf::Layer> = slices.chain(FEATURES.map(|name| (name.into(), WHITE))).collect();
    dxf::begin(out, None, &layers)?;
    let normal = sections.frame.axes[2];
    for (plane, contour) in sections.contours() {
        let layer = layer(plane);
        if contour.pieces.is_empty() {
            dxf::polyline(out, &layer, &contour.points, contour.closed)?;
        }
        for piece in &contour.pieces {
            entity(out, &layer, piece, normal)?;
        }
    }
    for run in &stack.runs {
        named(out, run, LETTERS * sections.spacing, normal)?;
    }
    dxf::end(out)
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
    let text = format!("{kind}{hole}{round} from {:.6} to {:.6}", run.from, run.to);
    dxf::text(out, &layer, (run.centre, height), &text, normal)
}

fn layer(plane: usize) -> String {
    format!("SLICE_{plane:04}")
}

fn entity(out: &mut dyn Write, layer: &str, piece: &CurvePiece, normal: [f64; 3]) -> io::Result<()> {
    match &piece.shape {
        CurveShape::Line => dxf::line(out, layer, [piece.from, piece.to]),
        CurveShape::Circle { centre, radius } => dxf::circle(out, layer, (*centre, *radius), normal),
        CurveShape::Arc { centre, radius, sweep_deg } => {
            // An arc runs counter-clockwise: one swept the other way begins at its end.
            let ends = if *sweep_deg < 0.0 { [piece.to, piece.from] } else { [piece.from, piece.to] };
            dxf::arc(out, layer, (*centre, *radius), ends, normal)
        }
        CurveShape::Spline(spline) => dxf::polyline(out, layer, &sampled(spline), false),
    }
}

fn sampled(spline: &BSpline) -> Vec<[f64; 3]> {
    let spans = spline.controls.len().saturating_sub(spline.degree).max(1);
    let last = spline.knots.last().copied().unwrap_or(0.0);
    let count = spans * SPAN_POINTS;
    (0..=count).map(|k| spline.point(last * k as f64 / count as f64)).collect()
}
