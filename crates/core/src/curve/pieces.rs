//! A row of points along a curve as lines, arcs, circles, ellipses and splines end to end, those of least description length.
//!
//! `search` finds the breaks between lines and arcs, `refine` moves them, `merge` puts runs of short arcs together where an
//! ellipse (`oval`) or a spline says them in fewer numbers, `join` lets the pieces meet, `rejoin` again after their curves have moved.

mod free;
mod hook;
mod join;
mod merge;
pub(crate) mod noise;
mod observed;
mod oval;
mod piece;
mod refine;
mod rejoin;
pub(crate) mod search;
mod sigma;

pub(crate) use free::Free;
pub(crate) use hook::AT_END;
pub(crate) use join::ellipse;
pub(crate) use merge::spline;
pub(crate) use noise::Noise;
pub(crate) use observed::Observed;
pub(crate) use oval::oval;
pub use piece::{Piece, Shape, Sigma};
pub(crate) use rejoin::rejoin;

use noise::{Kind, Span};

/// The pieces of a row of points in order, end to end. The first and last point of an open row are held, and the row may bend over a
/// length of `bent` beside them.
pub(crate) fn pieces(points: &[[f64; 3]], closed: bool, noise: &Noise, bent: f64) -> Vec<Piece> {
    if points.len() < 2 {
        return Vec::new();
    }
    if !closed {
        let weights = weights(points.len(), noise);
        let mut spans = spans(points, &weights, noise);
        hook::hook(points, &mut spans, noise, bent);
        return join::join(points, &spans, noise, false, 0);
    }
    closed_pieces(points, noise)
}

/// Weight of a node against a point in the middle of a strip.
const NODE_WEIGHT: f64 = 0.25;
/// Points from a node on over which the weight rises to that of the others.
const BESIDE_NODE: usize = 4;

/// Error of the vertices of a crease whose fold changes along it, as where a cylinder is cut aslant, against that of others.
const LOOSE: f64 = 2.0;

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
    if let Some(ellipse) = loose_ellipse(points, &row, &weights, noise).filter(|_| found.len() > 2) {
        return vec![ellipse];
    }
    // The first row was broken where it happened to begin.
    let start = found[found.len() / 2].first;
    let row = turned(start);
    let found = spans(&row, &weights, noise);
    join::join(&row, &found, noise, true, start)
}

/// The ellipse of a ring whose points err more than others, if it is the shortest description by that error too.
fn loose_ellipse(points: &[[f64; 3]], row: &[[f64; 3]], weights: &[f64], noise: &Noise) -> Option<Piece> {
    let noise = Noise { sigma: LOOSE * noise.sigma, ..*noise };
    let parts = merge::cost(row, weights, &noise, &spans(row, weights, &noise));
    merge::whole(points, &noise, parts).filter(|p| matches!(p.shape, Shape::Ellipse { .. }))
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
