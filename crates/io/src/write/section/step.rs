//! Sections as STEP: a wireframe of true curves, a GEOMETRIC_CURVE_SET for each contour, named by its slice, on a layer for each slice.
//! The names of features have no place there: they are in DXF and JSON.

use super::context::SectionContext;
use crate::write::encode::step::{Head, Id, List, Step};
use crate::write::network::step::{curves_of, rounding_of, wireframe};
use lineament::curve::Round;
use lineament::curve::pieces::Shape;
use lineament::math::vec3::scale;
use lineament::section::{CurvePiece, CurveShape, Sections};
use std::io::{self, Write};

pub(super) fn write(out: &mut dyn Write, sections: &Sections, context: &SectionContext) -> io::Result<()> {
    let contours = || sections.sections.iter().flat_map(|s| &s.contours);
    let head = Head {
        protocol: context.step,
        name: &context.input_name,
        version: &context.program_version,
        unit: context.known_unit(),
        uncertainty: rounding_of(contours().flat_map(|c| &c.points)),
    };
    let mut step = Step::begin(out, &head)?;
    let normal = sections.frame.axes[2];
    let mut layers: Vec<(String, Vec<Id>)> = Vec::new();
    for section in &sections.sections {
        let mut sets = Vec::new();
        for (number, contour) in section.contours.iter().enumerate() {
            let typed: Vec<_> = contour.pieces.iter().map(|p| turned(p, normal)).collect();
            let curves = curves_of(&mut step, &typed, &contour.points, contour.closed)?;
            if !curves.is_empty() {
                let name = format!("slice_{:04}_{number}", section.plane);
                sets.push(step.add(format_args!("GEOMETRIC_CURVE_SET('{name}',{})", List(&curves)))?);
            }
        }
        layers.push((format!("SLICE_{:04}", section.plane), sets));
    }
    for (name, sets) in &layers {
        step.layer(name, sets)?;
    }
    let sets: Vec<Id> = layers.into_iter().flat_map(|layer| layer.1).collect();
    wireframe(step, &context.input_name, &sets)
}

/// The curve of a piece as curves in space are: counter-clockwise about its own normal, with its ends.
fn turned(piece: &CurvePiece, axis: [f64; 3]) -> (Shape, [[f64; 3]; 2]) {
    let about = |centre, radius, sign| Round { centre, radius, normal: scale(axis, sign) };
    let along = [piece.from, piece.to];
    match &piece.shape {
        CurveShape::Line => (Shape::Line, along),
        CurveShape::Circle { centre, radius } => (Shape::Circle(about(*centre, *radius, 1.0)), along),
        CurveShape::Arc { centre, radius, sweep_deg } => {
            let round = about(*centre, *radius, sweep_deg.signum());
            (Shape::Arc { round, sweep: sweep_deg.abs().to_radians() }, along)
        }
        CurveShape::Ellipse { ellipse, sweep_deg } => {
            let ends = if *sweep_deg < 0.0 { [piece.to, piece.from] } else { along };
            (Shape::Ellipse { ellipse: *ellipse, sweep: sweep_deg.abs().to_radians() }, ends)
        }
        CurveShape::Spline(spline) => (Shape::Spline(spline.clone()), along),
    }
}
