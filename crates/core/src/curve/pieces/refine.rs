//! Breaks between long pieces moved to where both fit best: the search looks at few of their places.

use super::noise::{Kind, Noise, Span};
use super::search::SHORT;
use crate::curve::moments::Moments;

/// Times that every break is looked at.
const ROUNDS: usize = 2;
/// Points looked at on both sides of a break that the search could place anywhere.
const LEAST_WINDOW: usize = 2;

/// Moves each break, with the kinds of the pieces as they are.
pub(super) fn refine(points: &[[f64; 3]], weights: &[f64], noise: &Noise, spans: &mut [Span]) {
    for _ in 0..ROUNDS {
        for k in 1..spans.len() {
            let (before, after) = spans.split_at_mut(k);
            let (a, b) = (&mut before[k - 1], &mut after[0]);
            if [a.kind, b.kind].iter().any(|kind| matches!(kind, Kind::Ellipse | Kind::Spline(_))) {
                continue;
            }
            let at = best_break(points, weights, noise, a, b);
            (a.last, b.first) = (at, at);
        }
    }
}

/// The best place of the break between two spans within what the search left open.
fn best_break(points: &[[f64; 3]], weights: &[f64], noise: &Noise, a: &Span, b: &Span) -> usize {
    let longer = (a.last - a.first).max(b.last - b.first);
    let window = LEAST_WINDOW + 2 * (longer / SHORT);
    let low = (a.first + a.kind.fewest_steps()).max(a.last.saturating_sub(window)).min(a.last);
    let high = (b.last.saturating_sub(b.kind.fewest_steps())).min(a.last + window).max(a.last);
    let mut left = Moments::at(points[low]);
    (a.first..low).for_each(|i| left.push(points[i], weights[i]));
    let mut right = Moments::at(points[high]);
    (low + 1..=b.last).for_each(|i| right.push(points[i], weights[i]));
    let mut best = (f64::INFINITY, a.last);
    for at in low..=high {
        // The break belongs to both.
        left.push(points[at], weights[at]);
        let mut own = right;
        own.push(points[at], weights[at]);
        let cost = noise.cost(0, squares(a.kind, &left) + squares(b.kind, &own));
        if cost < best.0 {
            best = (cost, at);
        }
        if at < high {
            right.push(points[at + 1], -weights[at + 1]);
        }
    }
    best.1
}

fn squares(kind: Kind, moments: &Moments) -> f64 {
    let squares = moments.squares();
    if kind == Kind::Line { squares.line } else { squares.circle }
}
