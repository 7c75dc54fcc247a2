//! Rings and rows of data with known pieces; the bench `sketches` has the figures on scans.

use super::*;
use crate::math::uniform::uniform;
use crate::shapes::{Edge, Outline, gear, polygon, ring as round, rounded_rectangle, slot};

/// The pieces of data with an error of `error`, `step` apart along an outline, turned by a radian.
fn sketched(outline: &Outline, closed: bool, step: f64, error: f64, tolerance: Option<f64>) -> Vec<Piece> {
    let mut uniform = uniform(9);
    let mut normal = || (0..12).map(|_| uniform()).sum::<f64>() - 6.0;
    let (s, c) = 1.0_f64.sin_cos();
    let turn = |[x, y]: [f64; 2]| [c * x - s * y + 30.0, s * x + c * y - 70.0];
    let (mut vertices, mut data, mut arc) = (Vec::new(), Vec::new(), 0.0);
    for edge in outline {
        let length = match edge {
            Edge::Line([a, b]) => distance(*a, *b),
            Edge::Arc { radius, sweep, .. } => radius * sweep.abs() * std::f64::consts::TAU,
        };
        let count = (length / step).round() as usize;
        for k in 0..count {
            let share = (k as f64 + 0.5) / count as f64;
            let at = turn(edge.at(share));
            vertices.push(Vertex::new(at, 1.0));
            for _ in 0..3 {
                let at = at.map(|x| x + error * normal());
                data.push(Datum { at, weight: 1.0, arc: arc + share * length });
            }
        }
        arc += length;
    }
    fit(&Chain { vertices, closed }, &data, tolerance)
}

fn kinds(pieces: &[Piece]) -> String {
    let kind = |p: &Piece| match p.shape {
        Shape::Line => 'l',
        Shape::Arc { .. } => 'a',
        Shape::Circle { .. } => 'o',
        Shape::Ellipse { .. } => 'e',
        Shape::Free(_) => 's',
    };
    pieces.iter().map(kind).collect()
}

/// Whether a ring of kinds is that of `wanted`, begun anywhere.
fn turns_into(found: &str, wanted: &str) -> bool {
    found.len() == wanted.len() && wanted.repeat(2).contains(found)
}

/// The ends meet, and arcs lead through theirs.
fn check(pieces: &[Piece], closed: bool) {
    for (k, piece) in pieces.iter().enumerate() {
        if k + 1 < pieces.len() || closed {
            assert_eq!(piece.to, pieces[(k + 1) % pieces.len()].from, "{pieces:?}");
        }
        if let Shape::Arc { centre, radius, sweep } = piece.shape {
            let (s, c) = sweep.sin_cos();
            let d = [piece.from[0] - centre[0], piece.from[1] - centre[1]];
            let end = [centre[0] + c * d[0] - s * d[1], centre[1] + s * d[0] + c * d[1]];
            assert!(distance(end, piece.to) < 1e-9 * radius, "{piece:?}");
            assert!((distance(piece.from, centre) - radius).abs() < 1e-9 * radius, "{piece:?}");
        }
    }
}

#[test]
fn a_slot_is_two_lines_and_two_half_circles_that_touch_at_any_density() {
    for (step, error) in [(0.2, 0.0), (0.5, 0.0), (0.9, 0.0), (0.5, 0.1), (0.9, 0.25)] {
        let found = sketched(&slot(60.0, 20.0), true, step, error, None);
        check(&found, true);
        assert!(turns_into(&kinds(&found), "lala"), "{found:?} at {step}, {error}");
        for piece in &found {
            if let Shape::Arc { radius, sweep, .. } = piece.shape {
                assert!((radius - 10.0).abs() < 0.01 + 0.6 * error, "{radius} at {step}, {error}");
                assert!((sweep.abs() - std::f64::consts::PI).abs() < 0.01 + 0.5 * error, "{sweep}");
            }
        }
    }
}

#[test]
fn fillets_are_arcs_that_touch_both_lines() {
    for error in [0.0, 0.1] {
        let found = sketched(&rounded_rectangle([60.0, 40.0], 8.0), true, 0.5, error, None);
        check(&found, true);
        assert!(turns_into(&kinds(&found), "lalalala"), "{found:?}");
        for k in 0..8 {
            let (piece, next) = (&found[k], &found[(k + 1) % 8]);
            let (Shape::Line, Shape::Arc { centre, .. }) = (&piece.shape, &next.shape) else { continue };
            let way = [piece.to[0] - piece.from[0], piece.to[1] - piece.from[1]];
            let spoke = [piece.to[0] - centre[0], piece.to[1] - centre[1]];
            let cosine = way[0] * spoke[0] + way[1] * spoke[1];
            assert!(cosine.abs() < 1e-7 * way[0].hypot(way[1]) * spoke[0].hypot(spoke[1]), "{found:?}");
        }
    }
}

#[test]
fn a_circle_is_a_circle_however_dense_and_half_of_one_an_arc() {
    for (step, error) in [(0.1, 0.0), (0.9, 0.0), (0.1, 0.2), (0.9, 0.2)] {
        let found = sketched(&round([3.0, 4.0], 12.0), true, step, error, None);
        assert_eq!(kinds(&found), "o", "{found:?}");
        let half = vec![Edge::Arc { centre: [0.0; 2], radius: 50.0, from: 0.0, sweep: 0.5 }];
        let found = sketched(&half, false, step, error, None);
        check(&found, false);
        let [Piece { shape: Shape::Arc { radius, .. }, .. }] = found[..] else { panic!("{found:?}") };
        assert!((radius - 50.0).abs() < 0.01 + error, "{radius}");
    }
}

#[test]
fn collinear_runs_are_one_line_and_corners_are_where_lines_cross() {
    let corners = [[0.0, 0.0], [90.0, 0.0], [90.0, 60.0], [0.0, 60.0]];
    let found = sketched(&polygon(&corners, true), true, 0.3, 0.1, None);
    check(&found, true);
    assert_eq!(kinds(&found), "llll", "{found:?}");
    let (s, c) = 1.0_f64.sin_cos();
    let turned = corners.map(|[x, y]| [c * x - s * y + 30.0, s * x + c * y - 70.0]);
    for piece in &found {
        assert!(turned.iter().any(|&t| distance(t, piece.from) < 0.1), "{piece:?}");
    }
}

#[test]
fn a_gear_keeps_its_corners() {
    let found = sketched(&gear(6, [36.0, 50.0]), true, 0.5, 0.0, None);
    check(&found, true);
    assert!(turns_into(&kinds(&found), &"al".repeat(12)), "{}", kinds(&found));
}

#[test]
fn a_tolerance_that_is_given_holds_and_a_wide_one_asks_for_no_more_pieces() {
    let outline = slot(60.0, 20.0);
    for tolerance in [0.05, 0.5] {
        let found = sketched(&outline, true, 0.5, 0.1, Some(tolerance));
        check(&found, true);
        assert!(found.iter().all(|p| p.worst <= tolerance), "{found:?} for {tolerance}");
    }
    assert_eq!(kinds(&sketched(&outline, true, 0.5, 0.1, Some(5.0))).len(), 4);
}

/// Data about an ellipse, whole or in part, as of a pipe cut aslant.
#[test]
fn a_pipe_cut_aslant_is_one_ellipse_whole_or_in_part() {
    let mut uniform = uniform(4);
    let mut normal = || (0..12).map(|_| uniform()).sum::<f64>() - 6.0;
    let truth = FlatEllipse { centre: [40.0, -7.0], axes: [14.0, 9.0], way: [0.6, 0.8] };
    for (turn, closed) in [(1.0, true), (0.5, false), (-0.55, false)] {
        let (mut vertices, mut data, mut arc) = (Vec::new(), Vec::new(), 0.0);
        for k in 0..120 {
            let at = truth.at(0.7 + turn * std::f64::consts::TAU * (f64::from(k) + 0.5) / 120.0);
            arc += vertices.last().map_or(0.0, |v: &Vertex| distance(v.at, at));
            vertices.push(Vertex::new(at, 1.0));
            data.extend((0..2).map(|_| Datum { at: at.map(|x| x + 0.07 * normal()), weight: 1.0, arc }));
        }
        let found = fit(&Chain { vertices, closed }, &data, None);
        let [Piece { shape: Shape::Ellipse { ellipse, sweep }, from, to, .. }] = found[..] else {
            panic!("{turn}: {found:?}")
        };
        assert!(distance(ellipse.centre, truth.centre) < 0.2, "{ellipse:?}");
        assert!((0..2).all(|k| (ellipse.axes[k] - truth.axes[k]).abs() < 0.2), "{ellipse:?}");
        assert!((sweep - turn * std::f64::consts::TAU).abs() < 0.1, "{sweep} for {turn}");
        assert!([from, to].iter().all(|&p| distance(ellipse.foot(p), p) < 1e-9), "{found:?}");
    }
}
