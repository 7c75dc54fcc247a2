//! Sections as STEP: the same curves as in the sections themselves, a layer for each slice.

use super::near;
use super::parse::{File, Point};
use lineament::section::{Axis, CurvePiece, CurveShape, Planes, SectionParams, Sections, section};
use lineament::shapes::{Sampling, Scan, bracket};
use lineament_io::{SectionContext, SectionFormat, Unit, write_sections_to};

fn sections(fit: bool) -> Sections {
    let part = bracket().sample(&Scan::new(Sampling::Area { count: 20_000 }).seed(1));
    let params = SectionParams {
        axis: Axis::Vector([0.1, 0.2, 1.0]),
        planes: Planes::Count(3),
        fit,
        ..SectionParams::default()
    };
    section(&part.cloud, &params).unwrap()
}

fn written(sections: &Sections) -> File {
    let mut bytes = Vec::new();
    let context = SectionContext { unit: Some(Unit::Metre), ..SectionContext::default() };
    write_sections_to(&mut bytes, SectionFormat::Step, sections, &context).unwrap();
    File::parse(&String::from_utf8(bytes).unwrap())
}

fn distance(a: Point, b: Point) -> f64 {
    (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
}

/// Whether points run along a piece from one end to the other, and at its middle lie where it does.
fn same(kind: &str, points: &[Point], piece: &CurvePiece) -> bool {
    let ends = [points[0], points[points.len() - 1]];
    let along = near(ends[0], piece.from) && near(ends[1], piece.to);
    let back = near(ends[1], piece.from) && near(ends[0], piece.to);
    let round =
        |centre: Point, radius: f64| points.iter().all(|&p| (distance(p, centre) - radius).abs() < 1e-6);
    match &piece.shape {
        CurveShape::Line => kind == "LINE" && along,
        CurveShape::Circle { centre, radius } => kind == "CIRCLE" && round(*centre, *radius),
        CurveShape::Arc { centre, radius, sweep_deg } => {
            let chord = 2.0 * radius * (sweep_deg.to_radians() / 4.0).sin().abs();
            let middle = points[points.len() / 2];
            kind == "CIRCLE"
                && round(*centre, *radius)
                && (along || back)
                && (distance(middle, piece.from) - chord).abs() < 1e-6
        }
        CurveShape::Ellipse { .. } => kind == "ELLIPSE",
        CurveShape::Spline(_) => kind == "B_SPLINE_CURVE_WITH_KNOTS" && along,
    }
}

#[test]
fn sections_have_the_curves_of_their_contours_a_layer_for_each_slice() {
    let sections = sections(true);
    let file = written(&sections);
    let sets = file.all("GEOMETRIC_CURVE_SET");
    let contours: Vec<_> = sections.sections.iter().flat_map(|s| &s.contours).collect();
    assert!(sets.len() == contours.len() && contours.len() >= 3, "{} {}", sets.len(), contours.len());
    let mut kinds = std::collections::BTreeSet::new();
    for (set, contour) in sets.iter().zip(&contours) {
        let curves = File::ids(&set[1]);
        assert_eq!(curves.len(), contour.pieces.len());
        for (&id, piece) in curves.iter().zip(&contour.pieces) {
            let (kind, points) = file.along(id);
            assert!(same(kind, &points, piece), "{kind} {piece:?} {:?}", [points[0], points[32]]);
            kinds.insert(piece.shape.name());
        }
    }
    assert!(kinds.contains("line") && kinds.len() > 1, "{kinds:?}");
    let layers = file.all("PRESENTATION_LAYER_ASSIGNMENT");
    assert_eq!(layers.iter().map(|l| File::ids(&l[2]).len()).sum::<usize>(), sets.len());
    assert_eq!(layers.len(), sections.sections.iter().filter(|s| !s.contours.is_empty()).count());
}

#[test]
fn contours_without_curves_are_polylines_that_close() {
    let sections = sections(false);
    let file = written(&sections);
    let lines = file.all("POLYLINE");
    let contours: Vec<_> = sections.sections.iter().flat_map(|s| &s.contours).collect();
    assert_eq!(lines.len(), contours.len());
    for (line, contour) in lines.iter().zip(contours) {
        let points = File::ids(&line[1]);
        assert_eq!(points.len(), contour.points.len() + usize::from(contour.closed));
    }
}
