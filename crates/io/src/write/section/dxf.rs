//! Sections as DXF for further editing, a layer for each slice. Contours are LWPOLYLINEs in the plane of their slice: of the lines
//! and arcs that were fitted, or else of the vertices; splines and circles, and lines and arcs by themselves, are entities of their
//! own. A text at the middle of each run of the stack names it, on a layer of its kind.

use super::context::SectionContext;
use crate::write::encode::dxf::{Bend, Drawing, Layer, Shape};
use lineament::section::{Contour, CurvePiece, CurveShape, Feature, Run, Sections};
use std::io::{self, Write};

/// Layers of the names of runs.
const FEATURES: [&str; 4] = ["HOLE", "EXTRUSION", "TAPER", "REVOLUTION"];
/// Colour of these layers: white, or black on white.
const WHITE: u8 = 7;
/// Height of their letters, in spacings.
const LETTERS: f64 = 4.0;

pub(super) fn write(out: &mut dyn Write, sections: &Sections, context: &SectionContext) -> io::Result<()> {
    let planes = sections.sections.iter().map(|s| s.plane);
    let slices = planes.map(|plane| (format!("SLICE_{plane:04}"), (plane % 6 + 1) as u8));
    let layers: Vec<Layer> = slices.chain(FEATURES.map(|name| (name.into(), WHITE))).collect();
    let normal = sections.frame.axes[2];
    let slices = sections.sections.iter().enumerate();
    let contours = slices.flat_map(|(layer, s)| s.contours.iter().map(move |c| (layer, c)));
    let curves = contours.flat_map(|(layer, c)| shapes(c, normal).into_iter().map(move |s| (layer, s)));
    let height = LETTERS * sections.spacing;
    let first = sections.sections.len();
    let names = context.stack.runs.iter().map(|run| {
        let (feature, text) = named(run);
        (first + feature, Shape::Text { at: run.centre, height, text, normal })
    });
    Drawing { unit: context.known_unit(), layers, entities: curves.chain(names).collect() }.write(out)
}

/// The layer of a run among [`FEATURES`], and its name, with radius and range.
fn named(run: &Run) -> (usize, String) {
    let (layer, round) = match run.feature {
        Feature::Extrusion { radius } => (1, radius.map(|r| format!(" r {r:.6}"))),
        Feature::Taper { radius, .. } => (2, radius.map(|r| format!(" r {r:.6}"))),
        Feature::Revolution { least, most } => (3, Some(format!(" r {least:.6} to {most:.6}"))),
    };
    let (layer, hole) = if run.hole { (0, " hole") } else { (layer, "") };
    let (kind, round) = (run.feature.name(), round.unwrap_or_default());
    (layer, format!("{kind}{hole}{round} from {:.6} to {:.6}", run.from, run.to))
}

/// The entities of a contour.
fn shapes(contour: &Contour, normal: [f64; 3]) -> Vec<Shape<'_>> {
    let Contour { pieces, points, closed, .. } = contour;
    if pieces.is_empty() {
        let bends = points.iter().map(|&at| Bend { at, sweep: 0.0 }).collect();
        return vec![Shape::Flat { bends, closed: *closed, normal }];
    }
    // A closed contour with splines is gone round from one of them on, so that no run goes over the end of the list.
    let single = |piece: &CurvePiece| sweep(piece).is_none();
    let start = if *closed { pieces.iter().position(single).unwrap_or(0) } else { 0 };
    let ordered: Vec<&CurvePiece> = pieces[start..].iter().chain(&pieces[..start]).collect();
    let runs = ordered.chunk_by(|a, b| !single(a) && !single(b));
    let whole = *closed && !pieces.iter().any(single);
    runs.map(|run| if let [one] = run { piece(one, normal) } else { joined(run, whole, normal) }).collect()
}

/// A run of lines and arcs.
fn joined<'a>(run: &[&CurvePiece], closed: bool, normal: [f64; 3]) -> Shape<'a> {
    let bend = |piece: &&CurvePiece| Bend { at: piece.from, sweep: sweep(piece).unwrap_or(0.0) };
    let mut bends: Vec<Bend> = run.iter().map(bend).collect();
    bends.extend(run.last().filter(|_| !closed).map(|piece| Bend { at: piece.to, sweep: 0.0 }));
    Shape::Flat { bends, closed, normal }
}

/// The angle that a line or an arc sweeps, radians; `None` for other curves.
fn sweep(piece: &CurvePiece) -> Option<f64> {
    match piece.shape {
        CurveShape::Line => Some(0.0),
        CurveShape::Arc { sweep_deg, .. } => Some(sweep_deg.to_radians()),
        CurveShape::Circle { .. } | CurveShape::Ellipse { .. } | CurveShape::Spline(_) => None,
    }
}

fn piece(piece: &CurvePiece, normal: [f64; 3]) -> Shape<'_> {
    match &piece.shape {
        CurveShape::Line => Shape::Line([piece.from, piece.to]),
        CurveShape::Circle { centre, radius } => Shape::Circle { centre: *centre, radius: *radius, normal },
        CurveShape::Arc { centre, radius, sweep_deg } => {
            // An arc runs counter-clockwise: one swept the other way begins at its end.
            let ends = if *sweep_deg < 0.0 { [piece.to, piece.from] } else { [piece.from, piece.to] };
            Shape::Arc { centre: *centre, radius: *radius, normal, ends }
        }
        CurveShape::Ellipse { ellipse, sweep_deg } => {
            let from = if *sweep_deg < 0.0 { piece.to } else { piece.from };
            Shape::Ellipse { ellipse: *ellipse, from, sweep: sweep_deg.to_radians().abs() }
        }
        CurveShape::Spline(spline) => Shape::Spline(spline),
    }
}
