//! A row of points along a curve as lines, arcs, circles and splines end to end, those of least description length.
//!
//! `search` finds the breaks between lines and arcs, `refine` moves them, `merge` puts runs of short arcs together where a spline
//! says them in fewer numbers, `join` lets the pieces meet, `rejoin` again after their curves have moved.

mod free;
mod join;
mod merge;
pub(crate) mod noise;
mod observed;
mod piece;
mod refine;
mod rejoin;
pub(crate) mod search;
mod sigma;

pub(crate) use free::Free;
pub(crate) use merge::spline;
pub(crate) use noise::Noise;
pub(crate) use observed::Observed;
pub use piece::{Piece, Shape, Sigma};
pub(crate) use rejoin::rejoin;

use noise::{Kind, Span};

/// The pieces of a row of points in order, end to end. The first and last point of an open row are held.
pub(crate) fn pieces(points: &[[f64; 3]], closed: bool, noise: &Noise) -> Vec<Piece> {
    if points.len() < 2 {
        return Vec::new();
    }
    if !closed {
        let weights = weights(points.len(), noise);
        let spans = spans(points, &weights, noise);
        return join::join(points, &spans, noise, false, 0);
    }
    closed_pieces(points, noise)
}

/// Weight of a node against a point in the middle of a strip.
const NODE_WEIGHT: f64 = 0.25;
/// Points from a node on over which the weight rises to that of the others.
const BESIDE_NODE: usize = 4;

fn closed_pieces(points: &[[f64; 3]], noise: &Noise) -> Vec<Piece> {
    let n = points.len();
    let turned = |start: usize| -> Vec<[f64; 3]> { (0..=n).map(|k| points[(start + k) % n]).collect() };
    let weights = vec![noise.share; n + 1];
    let row = turned(0);
    let found = spans(&row, &weights, noise);
    let other = match found[..] {
        // An arc that comes back to where it began is the circle.
        [Span { kind: Kind::Arc, .. }] => f64::INFINITY,
        _ => merge::cost(&row, &weights, noise, &found),
    };
    if let Some(whole) = merge::whole(points, noise, other) {
        return vec![whole];
    }
    // The first row was broken where it happened to begin.
    let start = found[found.len() / 2].first;
    let row = turned(start);
    let found = spans(&row, &weights, noise);
    join::join(&row, &found, noise, true, start)
}

/// Weights of an open row: the nodes at its ends, and the points beside them, are less certain than those between.
fn weights(count: usize, noise: &Noise) -> Vec<f64> {
    let mut weights = vec![noise.share; count];
    for k in 0..BESIDE_NODE.min(count / 3).max(1) {
        let share = NODE_WEIGHT + (1.0 - NODE_WEIGHT) * k as f64 / BESIDE_NODE as f64;
        weights[k] *= share;
        weights[count - 1 - k] *= share;
    }
    weights
}

fn spans(points: &[[f64; 3]], weights: &[f64], noise: &Noise) -> Vec<Span> {
    let mut spans = search::search(points, weights, noise);
    refine::refine(points, weights, noise, &mut spans);
    let mut spans = merge::merge(points, weights, noise, &spans);
    refine::refine(points, weights, noise, &mut spans);
    spans
}

#[cfg(test)]
mod tests;
