//! Where a strip breaks into lines and arcs: the breaks of least description length, by dynamic programming.
//!
//! A piece of `k` parameters whose points lie at distances `d` costs `sum of w d^2 / (2 sigma^2) + k/2 ln n` (Rissanen 1978, Modeling by
//! shortest data description, the two-part code; the penalty is that of Schwarz 1978). The best way to a point goes through the best
//! way to its last break, so that the sum is least over all breaks looked at. Pieces of up to [`SHORT`] points may break anywhere,
//! longer ones at every second, fourth, ... point: a strip of `n` points costs `O(n)` fits, each in constant time from sums over
//! blocks. [`refine`](super::refine) then moves the breaks of long pieces.

use super::noise::{Kind, Noise, Span};
use crate::curve::moments::Moments;

/// Greatest number of blocks of one length that a piece is made of.
pub(super) const SHORT: usize = 24;

/// Sums over blocks of 1, 2, 4, ... points.
struct Pyramid<'a> {
    points: &'a [[f64; 3]],
    weights: &'a [f64],
    levels: Vec<Vec<Moments>>,
}

impl<'a> Pyramid<'a> {
    fn new(points: &'a [[f64; 3]], weights: &'a [f64]) -> Self {
        let single = |(&p, &w): (&[f64; 3], &f64)| {
            let mut m = Moments::at(p);
            m.push(p, w);
            m
        };
        let mut levels: Vec<Vec<Moments>> = vec![points.iter().zip(weights).map(single).collect()];
        while levels[levels.len() - 1].len() > SHORT {
            let finer = &levels[levels.len() - 1];
            let pair = |two: &[Moments]| {
                let mut sum = two[0];
                two[1..].iter().for_each(|m| sum.add(m));
                sum
            };
            levels.push(finer.chunks(2).map(pair).collect());
        }
        Self { points, weights, levels }
    }

    /// Calls `visit(end, moments of first..=end)` for the pieces from `first` that are looked at.
    fn pieces_from(&self, first: usize, mut visit: impl FnMut(usize, &Moments)) {
        let last = self.points.len() - 1;
        for (level, blocks) in self.levels.iter().enumerate() {
            let size = 1 << level;
            if !first.is_multiple_of(size) {
                break;
            }
            let mut sum = Moments::at(self.points[first]);
            for count in 1..=SHORT {
                let block = first / size + count - 1;
                let end = (first + count * size).min(last);
                if let Some(m) = blocks.get(block).filter(|_| first + count * size <= last) {
                    sum.add(m);
                } else {
                    (first + (count - 1) * size..last)
                        .for_each(|i| sum.push(self.points[i], self.weights[i]));
                }
                // Half as many blocks of twice the size were no other piece.
                if level == 0 || count > SHORT / 2 || end == last {
                    let mut piece = sum;
                    piece.push(self.points[end], self.weights[end]);
                    visit(end, &piece);
                }
                if end == last {
                    break;
                }
            }
        }
    }
}

/// The spans of least description length from the first point to the last, of which there are two at least.
pub(super) fn search(points: &[[f64; 3]], weights: &[f64], noise: &Noise) -> Vec<Span> {
    let n = points.len();
    let pyramid = Pyramid::new(points, weights);
    let mut best = vec![(f64::INFINITY, 0, Kind::Line); n];
    best[0].0 = 0.0;
    for first in 0..n - 1 {
        let before = best[first].0;
        if !before.is_finite() {
            continue;
        }
        pyramid.pieces_from(first, |end, moments| {
            let squares = moments.squares();
            for (kind, squares) in [(Kind::Line, squares.line), (Kind::Arc, squares.circle)] {
                // Three points always lie on a circle.
                if kind == Kind::Arc && end - first < 3 {
                    continue;
                }
                let cost = before + noise.cost(noise.parameters(kind), squares);
                if cost < best[end].0 {
                    best[end] = (cost, first, kind);
                }
            }
        });
    }
    let mut spans = Vec::new();
    let mut end = n - 1;
    while end > 0 {
        let (_, first, kind) = best[end];
        spans.push(Span { first, last: end, kind });
        end = first;
    }
    spans.reverse();
    spans
}
