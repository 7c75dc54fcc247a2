//! Pieces that meet: each fitted by itself, the joints where neighbours cross or come nearest, then each through its joints.

use super::free::{Free, meet};
use super::merge::spline;
use super::noise::{Kind, Noise, Span};
use super::piece::{Piece, Shape};
use super::sigma::sigma;
use crate::curve::ellipse::Ellipse;
use crate::curve::round::{Round, plane};
use crate::math::vec3::{distance, distance2, sub, unit};

/// Points left out at both ends of an arc's fit, where it has enough others.
const ENDS: usize = 1;
/// Weight of an end of an elliptic arc, which it has to lead through, against that of a point.
const HOLD: f64 = 1e4;

/// A span fitted by itself.
pub(super) fn free(points: &[[f64; 3]], kind: Kind) -> Free {
    let inner = if points.len() > 2 * ENDS + 4 { &points[ENDS..points.len() - ENDS] } else { points };
    match kind {
        Kind::Line => match plane(inner) {
            Some((at, [direction, ..])) => Free::Line { at, direction },
            None => Free::Line { at: points[0], direction: unit(sub(points[points.len() - 1], points[0])) },
        },
        Kind::Arc => Round::fit(inner).map_or(Free::Other, Free::Arc),
        Kind::Ellipse => {
            Ellipse::fit(inner, &vec![1.0; inner.len()], f64::INFINITY).map_or(Free::Other, Free::Ellipse)
        }
        Kind::Spline(_) => Free::Other,
    }
}

/// The pieces of the spans in order. `closed`: the row's last point is its first again, and point `k` of the row is point
/// `start + k` of a closed row one shorter.
pub(super) fn join(
    points: &[[f64; 3]],
    spans: &[Span],
    noise: &Noise,
    closed: bool,
    start: usize,
) -> Vec<Piece> {
    let free: Vec<Free> = spans.iter().map(|s| free(&points[s.first..=s.last], s.kind)).collect();
    let joint = |a: &Free, b: &Free, at: usize| meet(a, b, points[at], reach(points, at));
    let n = spans.len();
    let mut joints = vec![points[0]];
    joints.extend((1..n).map(|k| joint(&free[k - 1], &free[k], spans[k].first)));
    joints.push(points[points.len() - 1]);
    if closed && n > 1 {
        joints[0] = joint(&free[n - 1], &free[0], 0);
        joints[n] = joints[0];
    }
    let piece = |(k, span): (usize, &Span)| {
        let mut piece = through(points, span, &free[k], noise, [joints[k], joints[k + 1]]);
        if closed {
            let count = points.len() - 1;
            (piece.first, piece.last) = ((piece.first + start) % count, (piece.last + start) % count);
        }
        piece
    };
    spans.iter().enumerate().map(piece).collect()
}

/// How far from the point of their break two curves may meet.
fn reach(points: &[[f64; 3]], at: usize) -> f64 {
    let before = distance(points[at], points[at.saturating_sub(1)]);
    let after = distance(points[at], points[(at + 1).min(points.len() - 1)]);
    3.0 * before.max(after)
}

fn through(points: &[[f64; 3]], span: &Span, free: &Free, noise: &Noise, [from, to]: [[f64; 3]; 2]) -> Piece {
    let mut row = points[span.first..=span.last].to_vec();
    let last = row.len() - 1;
    (row[0], row[last]) = (from, to);
    let shape = match (free, span.kind) {
        (Free::Arc(round), _) => arc(round, &row).unwrap_or_else(|| plain(&row, noise)),
        (Free::Ellipse(_), _) => ellipse(&row).unwrap_or_else(|| free_form(&row, noise)),
        (Free::Other, Kind::Spline(_) | Kind::Ellipse) => free_form(&row, noise),
        _ if from == to => free_form(&row, noise),
        _ => Shape::Line,
    };
    let mut piece =
        Piece { shape, from, to, first: span.first, last: span.last, deviation: 0.0, sigma: None };
    let squares: f64 = row.iter().map(|&p| distance2(p, piece.foot(p))).sum();
    piece.deviation = (squares / row.len() as f64).sqrt();
    piece.sigma = sigma(&piece, &row, noise);
    piece
}

/// The line or the spline through the ends of the row, whichever is the shorter description. No line leads back to where it began.
fn plain(row: &[[f64; 3]], noise: &Noise) -> Shape {
    let (from, to) = (row[0], row[row.len() - 1]);
    let line = Free::Line { at: from, direction: unit(sub(to, from)) };
    let squares: f64 = row.iter().map(|&p| distance2(p, line.foot(p))).sum();
    let (curve, _, cost) = spline(row, &vec![noise.share; row.len()], noise, false);
    let straight = from != to && noise.cost(noise.parameters(Kind::Line), noise.share * squares) <= cost;
    if straight { Shape::Line } else { Shape::Spline(curve) }
}

fn free_form(row: &[[f64; 3]], noise: &Noise) -> Shape {
    Shape::Spline(spline(row, &vec![noise.share; row.len()], noise, false).0)
}

/// The ellipse through the ends of the row, its normal such that it runs counter-clockwise.
pub(crate) fn ellipse(row: &[[f64; 3]]) -> Option<Shape> {
    let last = row.len() - 1;
    let mut weights = vec![1.0; row.len()];
    (weights[0], weights[last]) = (HOLD, HOLD);
    let found = Ellipse::fit(row, &weights, f64::INFINITY)?.through(row[0], row[last])?;
    let turned = found.sweep(row);
    let found = if turned < 0.0 { found.turned() } else { found };
    let sweep = found.sweep_between(row[0], row[last]);
    ((sweep - turned.abs()).abs() < 1.0).then_some(Shape::Ellipse { ellipse: found, sweep })
}

/// The arc through the ends of the row, its normal such that it runs counter-clockwise.
fn arc(round: &Round, row: &[[f64; 3]]) -> Option<Shape> {
    let (from, to) = (row[0], row[row.len() - 1]);
    let mut round = round.through(from, to, row, 0.0)?;
    let turned = round.sweep(row);
    if turned < 0.0 {
        round.normal = round.normal.map(|x| -x);
    }
    let sweep = round.sweep_between(from, to);
    // Points that go back and forth across the chord are no arc.
    ((sweep - turned.abs()).abs() < 1.0).then_some(Shape::Arc { round, sweep })
}
