//! Rows of points with known curves, with and without noise.

use super::{Free, Noise, Piece, Shape, Sigma, pieces, rejoin};
use crate::curve::Round;
use crate::math::uniform::uniform;
use crate::math::vec3::{distance, norm, sub};
use std::f64::consts::{PI, TAU};

/// Points `0.5` apart from `from` to `to`, the last one left out.
fn line(from: [f64; 3], to: [f64; 3]) -> Vec<[f64; 3]> {
    let steps = (distance(from, to) / 0.5).round() as usize;
    let at = |k: usize| std::array::from_fn(|a| from[a] + (to[a] - from[a]) * k as f64 / steps as f64);
    (0..steps).map(at).collect()
}

/// Points about `0.5` apart on a circle in the plane x, y from one angle to another, the last one left out.
fn arc(centre: [f64; 2], radius: f64, from_deg: f64, to_deg: f64) -> Vec<[f64; 3]> {
    let (from, turn) = (from_deg.to_radians(), (to_deg - from_deg).to_radians());
    let steps = ((turn * radius).abs() / 0.5).round() as usize;
    let at = |k: usize| (from + turn * k as f64 / steps as f64).sin_cos();
    (0..steps).map(at).map(|(s, c)| [centre[0] + radius * c, centre[1] + radius * s, 2.0]).collect()
}

fn shaken(points: &[[f64; 3]], sigma: f64, seed: u64) -> Vec<[f64; 3]> {
    let mut uniform = uniform(seed);
    let mut normal = || (0..12).map(|_| uniform()).sum::<f64>() - 6.0;
    points.iter().map(|p| p.map(|x| x + sigma * normal())).collect()
}

fn found(points: &[[f64; 3]], closed: bool, sigma: f64) -> Vec<Piece> {
    let length: f64 = points.windows(2).map(|w| distance(w[0], w[1])).sum();
    pieces(points, closed, &Noise::new(sigma.max(0.05), 1.0, points.len(), length), 2.5)
}

fn names(pieces: &[Piece]) -> Vec<&'static str> {
    pieces.iter().map(|p| p.shape.name()).collect()
}

fn radius(piece: &Piece) -> f64 {
    match &piece.shape {
        Shape::Arc { round, .. } | Shape::Circle(round) => round.radius,
        other => panic!("{other:?} has no radius"),
    }
}

/// A slot of 40 by 20: two lines and two half circles of radius 10.
fn slot() -> Vec<[f64; 3]> {
    [
        line([-20.0, -10.0, 2.0], [20.0, -10.0, 2.0]),
        arc([20.0, 0.0], 10.0, -90.0, 90.0),
        line([20.0, 10.0, 2.0], [-20.0, 10.0, 2.0]),
        arc([-20.0, 0.0], 10.0, 90.0, 270.0),
    ]
    .concat()
}

/// A ring that begins and ends at a node is an open row, and no line of no length.
#[test]
fn a_row_that_leads_back_to_its_node_has_no_line_without_length() {
    let mut ring = arc([0.0, 0.0], 5.0, 0.0, 360.0);
    ring.push(ring[0]);
    let mut there_and_back = line([0.0; 3], [8.0, 0.0, 0.0]);
    there_and_back.extend(line([8.0, 0.0, 0.0], [0.0; 3]));
    there_and_back.push([0.0; 3]);
    for row in [ring, there_and_back] {
        for piece in found(&row, false, 0.05) {
            let length =
                if matches!(piece.shape, Shape::Line) { distance(piece.from, piece.to) } else { 1.0 };
            assert!(length > 0.0 && piece.deviation < 0.5, "{piece:?}");
        }
    }
}

#[test]
fn a_straight_strip_is_one_line_from_node_to_node() {
    let points = line([0.0; 3], [30.0, 20.0, 10.0]);
    for seed in 0..20 {
        let shaken = shaken(&points, 0.1, seed);
        let pieces = found(&shaken, false, 0.1);
        assert_eq!(names(&pieces), ["line"], "seed {seed}");
        assert_eq!((pieces[0].from, pieces[0].to), (shaken[0], shaken[shaken.len() - 1]));
        assert!(pieces[0].sigma.is_some());
    }
}

#[test]
fn a_slot_is_two_lines_and_two_arcs_that_meet() {
    for (sigma, off) in [(0.0, 0.02), (0.1, 0.4)] {
        for seed in 0..10 {
            let pieces = found(&shaken(&slot(), sigma, seed), true, sigma);
            let mut sorted = names(&pieces);
            sorted.sort_unstable();
            assert_eq!(sorted, ["arc", "arc", "line", "line"], "noise {sigma}, seed {seed}");
            for k in 0..4 {
                assert_eq!(pieces[k].to, pieces[(k + 1) % 4].from);
                assert_eq!(pieces[k].last, pieces[(k + 1) % 4].first);
            }
            for arc in pieces.iter().filter(|p| p.shape.name() == "arc") {
                assert!((radius(arc) - 10.0).abs() < off, "{} at noise {sigma}", radius(arc));
            }
        }
    }
}

#[test]
fn ends_lie_on_their_arc() {
    let points = [line([0.0, 0.0, 2.0], [20.0, 0.0, 2.0]), arc([20.0, 8.0], 8.0, -90.0, 30.0)].concat();
    let pieces = found(&points, false, 0.0);
    assert_eq!(names(&pieces), ["line", "arc"]);
    let Shape::Arc { round, sweep } = &pieces[1].shape else { panic!("{pieces:?}") };
    for end in [pieces[1].from, pieces[1].to] {
        assert!((distance(end, round.centre) - round.radius).abs() < 1e-9 * round.radius);
        let [x, y, z] = sub(end, round.centre);
        let [a, b, c] = round.normal;
        assert!((x * a + y * b + z * c).abs() < 1e-9 * round.radius);
    }
    assert!((sweep.to_degrees() - 120.0).abs() < 6.0, "{}", sweep.to_degrees());
}

#[test]
fn pieces_on_curves_that_moved_meet_again_and_keep_their_nodes() {
    let points = [line([0.0, 0.0, 2.0], [20.0, 0.0, 2.0]), arc([20.0, 8.0], 8.0, -90.0, 30.0)].concat();
    let pieces = found(&points, false, 0.0);
    let moved = |piece: &Piece| match Free::of(piece) {
        Free::Arc(round) => Free::Arc(Round { radius: round.radius - 0.1, ..round }),
        Free::Line { at: [x, y, z], direction } => Free::Line { at: [x, y + 0.1, z], direction },
        Free::Ellipse(_) | Free::Other => Free::Other,
    };
    let free: Vec<Free> = pieces.iter().map(moved).collect();
    let again = rejoin(&pieces, &free, false, 0.5).unwrap();
    assert_eq!(names(&again), ["line", "arc"]);
    assert_eq!((again[0].from, again[1].to), (pieces[0].from, pieces[1].to));
    assert_eq!(again[0].to, again[1].from);
    assert!((radius(&again[1]) - 7.9).abs() < 0.02, "{}", radius(&again[1]));
    let Shape::Arc { round, .. } = &again[1].shape else { panic!("{again:?}") };
    assert!([again[1].from, again[1].to].iter().all(|&p| distance(round.foot(p), p) < 1e-9));
}

#[test]
fn an_arc_that_would_turn_otherwise_is_left() {
    let points = [line([0.0, 0.0, 2.0], [20.0, 0.0, 2.0]), arc([20.0, 8.0], 8.0, -90.0, 30.0)].concat();
    let pieces = found(&points, false, 0.0);
    let far = Round { centre: [20.0, -20.0, 2.0], normal: [0.0, 0.0, 1.0], radius: 40.0 };
    assert!(rejoin(&pieces, &[Free::of(&pieces[0]), Free::Arc(far)], false, 0.5).is_none());
}

#[test]
fn a_closed_circle_is_one_circle_however_dense() {
    for steps in [24, 100, 999] {
        let at = |k: i32| (f64::from(k) * std::f64::consts::TAU / f64::from(steps)).sin_cos();
        let points: Vec<[f64; 3]> = (0..steps).map(at).map(|(s, c)| [6.0 * c, 1.0, 6.0 * s]).collect();
        let pieces = found(&shaken(&points, 0.05, 1), true, 0.05);
        assert_eq!(names(&pieces), ["circle"], "{steps} points");
        assert!((radius(&pieces[0]) - 6.0).abs() < 0.05);
    }
}

#[test]
fn a_long_polygon_breaks_at_its_corners() {
    let corners = [[0.0; 3], [300.0, 0.0, 0.0], [300.0, 7.0, 0.0], [100.0, 90.0, 50.0]];
    let mut points: Vec<[f64; 3]> = corners.windows(2).flat_map(|w| line(w[0], w[1])).collect();
    points.push(corners[3]);
    let pieces = found(&points, false, 0.0);
    assert_eq!(names(&pieces), ["line"; 3]);
    for (piece, corner) in pieces.iter().zip(&corners[1..]) {
        assert!(distance(piece.to, *corner) < 0.02, "{:?}", piece.to);
    }
}

#[test]
fn a_free_curve_is_a_spline_and_two_points_are_a_line() {
    let at = |k: i32| f64::from(k) * 0.25;
    let points: Vec<[f64; 3]> =
        (0..160).map(at).map(|t| [t, 6.0 * (0.2 * t).sin(), 0.004 * t * t * t.sqrt()]).collect();
    let pieces = found(&points, false, 0.0);
    assert!(names(&pieces).contains(&"b-spline"), "{:?}", names(&pieces));
    assert_eq!(names(&found(&[[0.0; 3], [1.0, 0.0, 0.0]], false, 0.1)), ["line"]);
    assert!(found(&[[0.0; 3]], false, 0.1).is_empty());
}

/// Points about `0.5` apart on an ellipse of half axes `a` and `b`, tilted in space, over a part of its parameter; the last one left out.
fn oval([a, b]: [f64; 2], from: f64, sweep: f64) -> Vec<[f64; 3]> {
    let steps = (sweep * 0.5 * (a + b) / 0.5).round() as usize;
    let at = |k: usize| (from + sweep * k as f64 / steps as f64).sin_cos();
    (0..steps).map(at).map(|(s, c)| [a * c, 0.8 * b * s, 0.6 * b * s]).collect()
}

fn axes(piece: &Piece) -> Option<[f64; 2]> {
    match &piece.shape {
        Shape::Ellipse { ellipse, .. } => Some([norm(ellipse.major), ellipse.minor]),
        _ => None,
    }
}

#[test]
fn an_ellipse_is_one_whole_or_in_part_and_lies_within_its_deviations() {
    for seed in 0..10 {
        let whole = found(&shaken(&oval([15.0, 9.0], 0.0, TAU), 0.1, seed), true, 0.1);
        let [piece] = &whole[..] else { panic!("{:?}", names(&whole)) };
        let Some(Sigma::Ellipse { covariance, .. }) = piece.sigma else { panic!("{piece:?}") };
        for (k, (found, size)) in axes(piece).unwrap().into_iter().zip([15.0, 9.0]).enumerate() {
            assert!((found - size).abs() < 4.0 * covariance[3 + k][3 + k].sqrt(), "{seed}: {piece:?}");
        }
        // Half of it, and lines that lead on straight from its ends.
        let mut row = line([15.0, -16.0, -12.0], [15.0, 0.0, 0.0]);
        row.extend(oval([15.0, 9.0], 0.0, PI));
        row.extend(line([-15.0, 0.0, 0.0], [-15.0, -16.0, -12.0]));
        let parts = found(&shaken(&row, 0.05, seed), false, 0.05);
        assert_eq!(names(&parts), ["line", "ellipse", "line"], "{seed}");
        let Shape::Ellipse { ellipse, sweep } = &parts[1].shape else { panic!() };
        assert!((sweep - PI).abs() < 0.3, "{sweep}");
        for end in [parts[1].from, parts[1].to] {
            assert!(distance(ellipse.foot(end), end) < 1e-9 * 15.0, "{:?}", parts[1]);
        }
        assert!(distance(ellipse.at(ellipse.angle(parts[1].from) + sweep), parts[1].to) < 1e-8);
    }
}

#[test]
fn what_is_round_or_free_is_no_ellipse() {
    for seed in 0..40 {
        for radius in [3.0, 8.0, 30.0] {
            let round = shaken(&arc([5.0, 1.0], radius, 0.0, 360.0), 0.1, seed);
            assert_eq!(names(&found(&round, true, 0.1)), ["circle"], "{radius} {seed}");
        }
        // A wave, a squared circle, and the curve in which pipes of radius 10 and 7 meet.
        let wave = |k: i32| [0.3 * f64::from(k), 6.0 * (0.05 * f64::from(k)).sin(), 0.0];
        let turn = |k: i32| (f64::from(k) * TAU / 150.0).sin_cos();
        let square = |k: i32| {
            let (s, c) = turn(k);
            let r = 12.0 / (s.powi(4) + c.powi(4)).powf(0.25);
            [r * c, r * s, 0.0]
        };
        let saddle = |k: i32| {
            let (s, c) = turn(k);
            [7.0 * c, 7.0 * s, (100.0 - 49.0 * s * s).sqrt()]
        };
        for (curve, closed) in [(&wave as &dyn Fn(i32) -> [f64; 3], false), (&square, true), (&saddle, true)]
        {
            let points: Vec<[f64; 3]> = (0..150).map(curve).collect();
            let found = found(&shaken(&points, 0.05, seed), closed, 0.05);
            assert!(found.iter().all(|p| axes(p).is_none()), "{seed}: {:?}", names(&found));
        }
    }
}

/// An edge whose row bends to a node beside it stays where it is, and a short line leads to the node.
#[test]
fn a_line_that_misses_its_node_is_parted_from_the_bend() {
    for (off, names_of) in [(0.2, &["line"][..]), (1.5, &["line", "line"])] {
        let mut points = line([0.0; 3], [30.0, 0.0, 0.0]);
        points.extend(line([30.0, 0.0, 0.0], [32.0, off, 0.0]));
        points.push([32.0, off, 0.0]);
        let pieces = found(&shaken(&points, 0.02, 3), false, 0.02);
        assert_eq!(names(&pieces), names_of, "{off}");
        let worst = pieces[0].from[1].abs().max(pieces[0].to[1].abs());
        assert!(worst < 0.3, "{worst}");
    }
}
