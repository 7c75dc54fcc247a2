//! Ends of an open row that bend away from their curve to a node that this does not lead to: a short line of their own, so that the curve
//! stays where its points are.

use super::free::Free;
use super::join::free;
use super::noise::{Kind, Noise, Span};
use crate::math::vec3::distance;

/// Least miss of a node, in lengths over which rows bend beside nodes.
const MISSED: f64 = 0.2;
/// Standard deviations of the curve at its end that the node must lie away.
const SURE: f64 = 3.0;
/// Variance at the end of a line through points of variance 1, times the number of these; that of an arc.
pub(crate) const AT_END: [f64; 2] = [4.0, 9.0];

/// Parts the ends of an open row from lines and arcs that miss its nodes; rows bend over a length of `bent` beside these.
pub(super) fn hook(points: &[[f64; 3]], spans: &mut Vec<Span>, noise: &Noise, bent: f64) {
    let (Some(&first), Some(&last)) = (spans.first(), spans.last()) else { return };
    let row: Vec<[f64; 3]> = points[first.first..=first.last].to_vec();
    let ahead = beside(&row, bent).filter(|&k| misses(&row[k..], first.kind, row[0], noise, bent));
    let mut row: Vec<[f64; 3]> = points[last.first..=last.last].to_vec();
    row.reverse();
    let mut behind = beside(&row, bent).filter(|&k| misses(&row[k..], last.kind, row[0], noise, bent));
    if let (Some(a), Some(b), 1) = (ahead, behind, spans.len()) {
        // One span that is parted at both ends must have something left.
        behind = Some(b).filter(|b| a + b + last.kind.fewest_steps() < row.len());
    }
    if let Some(k) = behind {
        let at = last.last - k;
        let end = spans.len() - 1;
        spans[end].last = at;
        spans.push(Span { first: at, last: last.last, kind: Kind::Line });
    }
    if let Some(k) = ahead {
        let at = first.first + k;
        spans[0].first = at;
        spans.insert(0, Span { first: first.first, last: at, kind: Kind::Line });
    }
}

/// The first point of the row that is `bent` or more along it from its first one.
fn beside(row: &[[f64; 3]], bent: f64) -> Option<usize> {
    let mut length = 0.0;
    (1..row.len()).find(|&k| {
        length += distance(row[k - 1], row[k]);
        length >= bent
    })
}

/// Whether the curve through points that lie `bent` and more from a node does not lead to it.
fn misses(row: &[[f64; 3]], kind: Kind, node: [f64; 3], noise: &Noise, bent: f64) -> bool {
    let factor = match kind {
        Kind::Line => AT_END[0],
        Kind::Arc => AT_END[1],
        _ => return false,
    };
    let length: f64 = row.windows(2).map(|w| distance(w[0], w[1])).sum();
    if row.len() <= kind.fewest_steps() + 1 || length < 2.0 * bent {
        return false;
    }
    let curve = free(row, kind);
    let many = (noise.share * row.len() as f64).max(1.0);
    let sigma = noise.sigma * (factor / many).sqrt();
    !matches!(curve, Free::Other) && distance(curve.foot(node), node) > (MISSED * bent).max(SURE * sigma)
}
