//! Where a row breaks into lines and arcs: the breaks of least description length, by dynamic programming.
//!
//! A piece of `k` parameters whose points lie at distances `d` costs `sum of w d^2 / (2 sigma^2) + k/2 ln n` (Rissanen 1978, Modeling by
//! shortest data description, the two-part code; the penalty is that of Schwarz 1978). The best way to a point goes through the best
//! way to its last break, so that the sum is least over all breaks looked at. Pieces of up to [`SHORT`] points may break anywhere,
//! longer ones at every second, fourth, ... point: a row of `n` points costs `O(n)` fits, each in constant time from sums over
//! blocks. [`refine`](super::refine) then moves the breaks of long pieces.

use super::noise::{Kind, Noise, Span};
use crate::curve::moments::{Moments, Squares};

/// Greatest number of blocks of one length that a piece is made of.
pub(crate) const SHORT: usize = 24;

/// A row that pieces are cut from: places to break at, with points between them.
pub(crate) trait Row {
    /// Sums over points from which the squared distances from curves follow.
    type Sum: Copy;
    /// The last place to break at, the first being 0.
    fn last(&self) -> usize;
    /// The points from the place `k` to before the next.
    fn block(&self, k: usize) -> Self::Sum;
    /// Sums over no points, with others from the place `k` on to follow.
    fn empty(&self, k: usize) -> Self::Sum;
    /// Adds a sum.
    fn add(&self, sum: &mut Self::Sum, other: &Self::Sum);
    /// Adds the points from the place `k` to before the next.
    fn push(&self, sum: &mut Self::Sum, k: usize);
    /// Adds what a piece that ends at the place `k` has there.
    fn close(&self, sum: &mut Self::Sum, k: usize);
    /// The squared distances of the points from their best curves.
    fn squares(&self, sum: &Self::Sum) -> Squares;
}

/// Points in space, each of them a place to break at, which then belongs to both pieces.
struct Points<'a> {
    points: &'a [[f64; 3]],
    weights: &'a [f64],
}

impl Row for Points<'_> {
    type Sum = Moments;

    fn last(&self) -> usize {
        self.points.len() - 1
    }

    fn block(&self, k: usize) -> Moments {
        let mut sum = Moments::at(self.points[k]);
        self.push(&mut sum, k);
        sum
    }

    fn empty(&self, k: usize) -> Moments {
        Moments::at(self.points[k])
    }

    fn add(&self, sum: &mut Moments, other: &Moments) {
        sum.add(other);
    }

    fn push(&self, sum: &mut Moments, k: usize) {
        sum.push(self.points[k], self.weights[k]);
    }

    fn close(&self, sum: &mut Moments, k: usize) {
        self.push(sum, k);
    }

    fn squares(&self, sum: &Moments) -> Squares {
        sum.squares()
    }
}

/// Sums over blocks of 1, 2, 4, ... places.
struct Pyramid<'a, R: Row> {
    row: &'a R,
    levels: Vec<Vec<R::Sum>>,
}

impl<'a, R: Row> Pyramid<'a, R> {
    fn new(row: &'a R) -> Self {
        let mut levels: Vec<Vec<R::Sum>> = vec![(0..row.last()).map(|k| row.block(k)).collect()];
        while levels[levels.len() - 1].len() > SHORT {
            let finer = &levels[levels.len() - 1];
            let pair = |two: &[R::Sum]| {
                let mut sum = two[0];
                two[1..].iter().for_each(|m| row.add(&mut sum, m));
                sum
            };
            levels.push(finer.chunks(2).map(pair).collect());
        }
        Self { row, levels }
    }

    /// Calls `visit(end, sums of first..=end)` for the pieces from `first` that are looked at.
    fn pieces_from(&self, first: usize, mut visit: impl FnMut(usize, &R::Sum)) {
        let last = self.row.last();
        for (level, blocks) in self.levels.iter().enumerate() {
            let size = 1 << level;
            if !first.is_multiple_of(size) {
                break;
            }
            let mut sum = self.row.empty(first);
            for count in 1..=SHORT {
                let block = first / size + count - 1;
                let end = (first + count * size).min(last);
                if let Some(m) = blocks.get(block).filter(|_| first + count * size <= last) {
                    self.row.add(&mut sum, m);
                } else {
                    (first + (count - 1) * size..last).for_each(|i| self.row.push(&mut sum, i));
                }
                // Half as many blocks of twice the size were no other piece.
                if level == 0 || count > SHORT / 2 || end == last {
                    let mut piece = sum;
                    self.row.close(&mut piece, end);
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
    search_row(&Points { points, weights }, noise)
}

/// The spans of least description length of a row that has two places at least.
pub(crate) fn search_row<R: Row>(row: &R, noise: &Noise) -> Vec<Span> {
    let n = row.last() + 1;
    let pyramid = Pyramid::new(row);
    let mut best = vec![(f64::INFINITY, 0, Kind::Line); n];
    best[0].0 = 0.0;
    for first in 0..n - 1 {
        let before = best[first].0;
        if !before.is_finite() {
            continue;
        }
        pyramid.pieces_from(first, |end, sum| {
            let squares = row.squares(sum);
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
    spans(&best)
}

/// The spans that lead to the last place, of which each has the cost so far, the place it is reached from, and how.
pub(crate) fn spans(best: &[(f64, usize, Kind)]) -> Vec<Span> {
    let mut spans = Vec::new();
    let mut end = best.len() - 1;
    while end > 0 {
        let (_, first, kind) = best[end];
        spans.push(Span { first, last: end, kind });
        end = first;
    }
    spans.reverse();
    spans
}
