//! Runs of pieces as one curve where that is the shorter description: lines and arcs that the search had to break where no break is, short
//! arcs that are a spline; and closed rows as one circle or spline.

use super::noise::{Kind, Noise, Span};
use super::oval::oval;
use super::piece::{Piece, Shape};
use super::sigma::sigma;
use crate::curve::moments::Moments;
use crate::curve::round::Round;
use crate::curve::rows::chord_lengths;
use crate::curve::{BSpline, FitOptions, fit};
use crate::math::vec3::distance2;

/// Most pieces that are put together at once.
const LONGEST_RUN: usize = 6;
/// Most pieces that an ellipse is put together of: its flat parts take few, its ends many.
const LONGEST_OVAL: usize = 16;
/// Weight of a spline's second differences against one point: enough to solve it.
const CALM: f64 = 1e-4;
/// Most spans of a spline.
const MOST_SPANS: usize = 64;

/// The least description of spans and of single curves over runs of them, by dynamic programming.
pub(super) fn merge(points: &[[f64; 3]], weights: &[f64], noise: &Noise, spans: &[Span]) -> Vec<Span> {
    let own: Vec<f64> = spans.iter().map(|s| span_cost(points, weights, noise, s)).collect();
    let n = spans.len();
    let mut best: Vec<(f64, usize, Kind)> = vec![(f64::INFINITY, 0, Kind::Line); n + 1];
    best[0].0 = 0.0;
    for a in 0..n {
        let before = best[a].0;
        for b in a + 1..=n.min(a + LONGEST_OVAL) {
            let parts = own[a..b].iter().sum();
            let (cost, kind) = match b {
                _ if b == a + 1 => (own[a], spans[a].kind),
                _ => run(points, weights, noise, &spans[a..b], parts),
            };
            if before + cost < best[b].0 {
                best[b] = (before + cost, a, kind);
            }
        }
    }
    let (mut merged, mut end) = (Vec::new(), n);
    while end > 0 {
        let (_, a, kind) = best[end];
        merged.push(Span { first: spans[a].first, last: spans[end - 1].last, kind });
        end = a;
    }
    merged.reverse();
    merged
}

/// The shortest description of a run of spans by one curve; `parts` is that by the spans themselves.
fn run(points: &[[f64; 3]], weights: &[f64], noise: &Noise, spans: &[Span], parts: f64) -> (f64, Kind) {
    let (first, last) = (spans[0].first, spans[spans.len() - 1].last);
    let one = |kind| (span_cost(points, weights, noise, &Span { first, last, kind }), kind);
    let (row, weighted) = (&points[first..=last], &weights[first..=last]);
    let oval = || oval(row, weighted, noise, parts).map_or(f64::INFINITY, |o| o.1);
    if spans.len() > LONGEST_RUN {
        return (oval(), Kind::Ellipse);
    }
    let (_, controls, cost) = spline(row, weighted, noise, false);
    let kinds = [one(Kind::Line), one(Kind::Arc), (oval(), Kind::Ellipse), (cost, Kind::Spline(controls))];
    kinds.into_iter().fold((f64::INFINITY, Kind::Line), |best, k| if k.0 < best.0 { k } else { best })
}

/// The description length of all spans.
pub(super) fn cost(points: &[[f64; 3]], weights: &[f64], noise: &Noise, spans: &[Span]) -> f64 {
    spans.iter().map(|s| span_cost(points, weights, noise, s)).sum()
}

fn span_cost(points: &[[f64; 3]], weights: &[f64], noise: &Noise, span: &Span) -> f64 {
    let (points, weights) = (&points[span.first..=span.last], &weights[span.first..=span.last]);
    let mut moments = Moments::at(points[0]);
    points.iter().zip(weights).for_each(|(&p, &w)| moments.push(p, w));
    let squares = match span.kind {
        Kind::Line => moments.squares().line,
        Kind::Arc => moments.squares().circle,
        Kind::Ellipse => {
            return oval(points, weights, noise, f64::INFINITY).map_or(f64::INFINITY, |o| o.1);
        }
        Kind::Spline(_) => return spline(points, weights, noise, false).2,
    };
    noise.cost(noise.parameters(span.kind), squares)
}

/// The spline of least description length, its number of control points, and that length.
pub(crate) fn spline(
    points: &[[f64; 3]],
    weights: &[f64],
    noise: &Noise,
    closed: bool,
) -> (BSpline, usize, f64) {
    let length: f64 = points.windows(2).map(|w| distance2(w[0], w[1]).sqrt()).sum();
    let mut best = (BSpline::default(), 0, f64::INFINITY);
    let mut spans = if closed { 4 } else { 1 };
    while spans <= MOST_SPANS.min(points.len()) {
        let options = FitOptions { span: length / spans as f64, smoothing: CALM, closed };
        let (curve, parameters) = fit(points, options);
        let off = |((&p, &t), w): ((&[f64; 3], &f64), &f64)| w * distance2(p, curve.point(t));
        let squares: f64 = points.iter().zip(&parameters).zip(weights).map(off).sum();
        let controls = curve.controls.len();
        let cost = noise.cost(noise.parameters(Kind::Spline(controls)), squares);
        if cost < best.2 {
            best = (curve, controls, cost);
        } else if cost > best.2 + 4.0 * noise.log_count {
            break;
        }
        spans = (spans + 1).max(spans * 5 / 4);
    }
    best
}

/// A closed row as one circle, ellipse or spline, where that is no longer a description than `other`.
pub(super) fn whole(points: &[[f64; 3]], noise: &Noise, other: f64) -> Option<Piece> {
    let weights = vec![noise.share; points.len()];
    let piece = |shape, squares: f64, at| {
        let deviation = (squares / points.len() as f64).sqrt();
        let whole = Piece { shape, from: at, to: at, first: 0, last: points.len(), deviation, sigma: None };
        Piece { sigma: sigma(&whole, points, noise), ..whole }
    };
    if let Some(round) = Round::fit(points) {
        let squares: f64 = points.iter().map(|&p| distance2(p, round.foot(p))).sum();
        let turns = round.sweep(points).abs() > std::f64::consts::PI;
        let cost = noise.cost(noise.parameters(Kind::Arc), noise.share * squares);
        if turns && cost <= other {
            let better = |c: f64| ellipse(points, &weights, noise, c);
            let (shape, squares, at) =
                better(cost).unwrap_or((Shape::Circle(round), squares, round.foot(points[0])));
            return Some(piece(shape, squares, at));
        }
    }
    if let Some((shape, squares, at)) = ellipse(points, &weights, noise, other) {
        return Some(piece(shape, squares, at));
    }
    let (curve, _, cost) = spline(points, &weights, noise, true);
    let squares = |c: &BSpline| {
        let (parameters, _) = chord_lengths(points, true);
        points.iter().zip(parameters).map(|(&p, t)| distance2(p, c.point(t))).sum()
    };
    (cost < other).then(|| {
        let (squares, at) = (squares(&curve), curve.point(0.0));
        piece(Shape::Spline(curve), squares, at)
    })
}

/// The ellipse all the way round, the squared distances from it and where it begins, if its description is shorter than `limit`.
fn ellipse(
    points: &[[f64; 3]],
    weights: &[f64],
    noise: &Noise,
    limit: f64,
) -> Option<(Shape, f64, [f64; 3])> {
    let (found, _) = oval(points, weights, noise, limit)?;
    let turned = found.sweep(points);
    let found = if turned < 0.0 { found.turned() } else { found };
    let squares: f64 = points.iter().map(|&p| distance2(p, found.foot(p))).sum();
    let shape = Shape::Ellipse { ellipse: found, sweep: std::f64::consts::TAU };
    (turned.abs() > std::f64::consts::PI).then(|| (shape, squares, found.foot(points[0])))
}
