//! Contours of sections, in planes that lie aslant.

use super::parse::{Drawing, near};
use lineament::curve::BSpline;
use lineament::section::{Axis, Contour, CurvePiece, CurveShape, Section, Sections, SliceFrame, Zero};
use lineament_io::{SectionContext, SectionFormat, Unit, write_sections_to};

/// A frame whose axis lies aslant, and a map from it to the world, with coordinates as on a map.
fn frame() -> (SliceFrame, impl Fn([f64; 2]) -> [f64; 3]) {
    let frame = SliceFrame::along(Axis::Vector([1.0, -0.4, 0.7])).unwrap();
    let place = move |[x, y]: [f64; 2]| {
        let [a, b, c] = frame.vector([x, y, 3.0]);
        [665_186.25 + a, 5_648_349.5 + b, 241.5 + c]
    };
    (frame, place)
}

fn sections(contours: Vec<Contour>) -> Sections {
    let section = Section { plane: 0, height: 3.0, slab: None, points: 9, contours, missing: None };
    Sections {
        frame: frame().0,
        zero: (Zero::Origin, 0.0),
        heights: vec![3.0],
        spacing: 0.1,
        noise: 0.1,
        dropped: 0,
        merged: 0,
        clutter: 0,
        sections: vec![section],
    }
}

fn contour(pieces: Vec<CurvePiece>, closed: bool) -> Contour {
    let mut points: Vec<[f64; 3]> = pieces.iter().map(|p| p.from).collect();
    points.extend(pieces.last().filter(|_| !closed).map(|p| p.to));
    Contour {
        points,
        corners: Vec::new(),
        closed,
        parent: None,
        depth: 0,
        area: 0.0,
        length: 1.0,
        draft_deg: None,
        steepest_deg: 0.0,
        centroid: [0.0; 3],
        pieces,
    }
}

fn written(contours: Vec<Contour>) -> Drawing {
    let mut bytes = Vec::new();
    let context = SectionContext { unit: Some(Unit::Metre), ..SectionContext::default() };
    write_sections_to(&mut bytes, SectionFormat::Dxf, &sections(contours), &context).unwrap();
    let drawing = Drawing::parse(&String::from_utf8(bytes).unwrap());
    drawing.check_handles();
    assert_eq!(drawing.variable("$INSUNITS").unwrap(), [(70, "6")]);
    assert!(drawing.entities.iter().all(|e| e.layer == "SLICE_0000"));
    drawing
}

fn piece(shape: CurveShape, from: [f64; 2], to: [f64; 2]) -> CurvePiece {
    let place = frame().1;
    CurvePiece { shape, from: place(from), to: place(to), worst: 0.0 }
}

fn line(from: [f64; 2], to: [f64; 2]) -> CurvePiece {
    piece(CurveShape::Line, from, to)
}

/// An arc about a centre from one angle, in degrees, over another.
fn arc(centre: [f64; 2], radius: f64, from: f64, sweep_deg: f64) -> CurvePiece {
    let at = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        [centre[0] + radius * cos, centre[1] + radius * sin]
    };
    let shape = CurveShape::Arc { centre: frame().1(centre), radius, sweep_deg };
    piece(shape, at(from), at(from + sweep_deg))
}

fn spline(from: [f64; 2], to: [f64; 2]) -> CurvePiece {
    let place = frame().1;
    let controls = vec![place(from), place([2.0, 9.0]), place([4.0, -9.0]), place(to)];
    let knots = vec![0.0, 0.0, 0.0, 0.0, 5.0, 5.0, 5.0, 5.0];
    piece(CurveShape::Spline(BSpline { degree: 3, knots, controls, periodic: false }), from, to)
}

/// A slot 4 long between two half circles of radius 2.
fn slot() -> Vec<CurvePiece> {
    vec![
        line([0.0, 0.0], [4.0, 0.0]),
        arc([4.0, 2.0], 2.0, -90.0, 180.0),
        line([4.0, 4.0], [0.0, 4.0]),
        arc([0.0, 2.0], 2.0, 90.0, 180.0),
    ]
}

#[test]
fn a_slot_is_one_closed_polyline_with_two_bulges() {
    let pieces = slot();
    let drawing = written(vec![contour(pieces.clone(), true)]);
    let [entity] = drawing.of_kind("LWPOLYLINE")[..] else { panic!("{:?}", drawing.entities) };
    assert_eq!((drawing.entities.len(), entity.real(70), entity.real(90)), (1, 1.0, 4.0));
    assert!(near(entity.place(210), frame().0.axes[2]));
    let bends = entity.bends();
    for ((at, bulge), (piece, wanted)) in bends.iter().zip(pieces.iter().zip([0.0, 1.0, 0.0, 1.0])) {
        assert!(near(*at, piece.from) && (bulge - wanted).abs() < 1e-12, "{at:?} {bulge}");
    }
    // The drawing reaches as far as its arcs, not only its vertices.
    let place = frame().1;
    for p in (0..60).map(|k| f64::from(k) * 6.0_f64.to_radians()) {
        let p = place([4.0 + 2.0 * p.cos().max(0.0), 2.0 + 2.0 * p.sin()]);
        let (low, high) = (drawing.corner("$EXTMIN"), drawing.corner("$EXTMAX"));
        assert!((0..3).all(|k| low[k] - 1e-9 <= p[k] && p[k] <= high[k] + 1e-9), "{p:?}");
    }
}

#[test]
fn an_arc_swept_clockwise_has_a_bulge_below_zero_and_the_radius_of_its_piece() {
    let (sin, cos) = (-220.0_f64).to_radians().sin_cos();
    let pieces = vec![arc([0.0, 0.0], 5.0, 30.0, -250.0), line([5.0 * cos, 5.0 * sin], [9.0, 5.0])];
    let drawing = written(vec![contour(pieces, false)]);
    let entity = drawing.of_kind("LWPOLYLINE")[0];
    assert_eq!((entity.real(70), entity.bends().len()), (0.0, 3));
    let [(a, bulge), (b, _), _] = entity.bends()[..] else { panic!() };
    let chord = (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt();
    assert!(bulge < 0.0 && (4.0 * bulge.atan().to_degrees() + 250.0).abs() < 1e-9, "{bulge}");
    let radius = chord * (1.0 + bulge * bulge) / (4.0 * bulge.abs());
    assert!((radius - 5.0).abs() < 1e-6, "{radius}");
}

#[test]
fn splines_stand_by_themselves_between_the_polylines_that_they_part() {
    let mut ring = slot();
    ring[2] = spline([4.0, 4.0], [0.0, 4.0]);
    let drawing = written(vec![contour(ring.clone(), true)]);
    let kinds: Vec<&str> = drawing.entities.iter().map(|e| e.kind.as_str()).collect();
    assert_eq!(kinds, ["SPLINE", "LWPOLYLINE"]);
    let CurveShape::Spline(wanted) = &ring[2].shape else { panic!() };
    assert_eq!(
        (drawing.entities[0].reals(40), drawing.entities[0].places(10)),
        (wanted.knots.clone(), wanted.controls.clone())
    );
    // The run goes on over the end of the list: the second half circle, the line, the first.
    let bends = drawing.entities[1].bends();
    let wanted = [ring[3].from, ring[0].from, ring[1].from, ring[1].to];
    assert!(bends.len() == 4 && bends.iter().zip(wanted).all(|(b, w)| near(b.0, w)), "{bends:?}");
    assert_eq!(drawing.entities[1].real(70), 0.0);
}

#[test]
fn circles_and_single_pieces_are_entities_of_their_own() {
    let place = frame().1;
    let centre = place([1.0, 2.0]);
    let whole = piece(CurveShape::Circle { centre, radius: 3.0 }, [4.0, 2.0], [4.0, 2.0]);
    let backward = arc([0.0, 0.0], 5.0, 30.0, -100.0);
    let contours = vec![
        contour(vec![whole], true),
        contour(vec![backward.clone()], false),
        contour(vec![line([0.0, 0.0], [1.0, 1.0])], false),
    ];
    let drawing = written(contours);
    let [circle, arc, line] = &drawing.entities[..] else { panic!("{:?}", drawing.entities) };
    assert_eq!([&circle.kind, &arc.kind, &line.kind], ["CIRCLE", "ARC", "LINE"]);
    assert!(near(circle.world(circle.place(10)), centre) && circle.real(40) == 3.0);
    assert!(
        near(arc.on_circle(arc.real(50)), backward.to) && near(arc.on_circle(arc.real(51)), backward.from)
    );
    assert!(near(line.place(11), place([1.0, 1.0])));
}

#[test]
fn a_contour_without_pieces_is_a_polyline_in_its_plane() {
    let mut open = contour(slot(), false);
    open.pieces.clear();
    let drawing = written(vec![open.clone()]);
    let bends = drawing.of_kind("LWPOLYLINE")[0].bends();
    assert!(bends.iter().zip(&open.points).all(|((at, bulge), p)| near(*at, *p) && *bulge == 0.0));
    assert_eq!(bends.len(), 5);
}
