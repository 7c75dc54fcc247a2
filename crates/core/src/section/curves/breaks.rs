//! The breaks between the lines, arcs and splines of a contour: those of least description length.
//!
//! `pieces::search` looks at few of the places where long pieces may break; the places about those that it finds are then searched
//! anew, all of them. Runs of pieces that one spline describes in fewer numbers become that spline, between corners.

use super::data::{Blocks, Datum};
use crate::curve::BSpline;
use crate::curve::pieces::noise::{Kind, Noise, Span};
use crate::curve::pieces::search::{Row, search_row, spans};
use crate::curve::pieces::spline;
use crate::math::vec2::{sub, unit};

/// Blocks to both sides of a break that are looked at again.
const BESIDE: usize = 3;
/// Most places that a piece leads over.
const FARTHEST: usize = 64;
/// Fewest and most pieces that a spline stands for.
const RUN: (usize, usize) = (3, 16);

/// The pieces of the blocks in order, spans of blocks.
pub(super) fn breaks(blocks: &Blocks, noise: &Noise, corners: &[f64]) -> Vec<Span> {
    let found = again(blocks, noise, &search_row(blocks, noise));
    splined(blocks, noise, &found, corners)
}

/// The best pieces that break at places about those found, or none.
fn again(blocks: &Blocks, noise: &Noise, found: &[Span]) -> Vec<Span> {
    let last = blocks.last();
    let mut places: Vec<usize> = vec![0, last];
    for span in &found[1..] {
        places.extend(span.first.saturating_sub(BESIDE)..=(span.first + BESIDE).min(last));
    }
    places.sort_unstable();
    places.dedup();
    let between: Vec<_> = places.windows(2).map(|w| blocks.sum(w[0], w[1])).collect();
    let mut best = vec![(f64::INFINITY, 0, Kind::Line); places.len()];
    best[0].0 = 0.0;
    for a in 0..places.len() - 1 {
        let (before, mut sum) = (best[a].0, between[a]);
        for b in a + 1..places.len().min(a + FARTHEST) {
            if b > a + 1 {
                sum.add(&between[b - 1]);
            }
            let squares = sum.squares();
            for (kind, squares) in [(Kind::Line, squares.line), (Kind::Arc, squares.circle)] {
                let enough = places[b] - places[a] >= kind.fewest_steps();
                let cost = before + noise.cost(noise.parameters(kind), squares);
                if enough && cost < best[b].0 {
                    best[b] = (cost, a, kind);
                }
            }
        }
    }
    let place = |s: Span| Span { first: places[s.first], last: places[s.last], ..s };
    spans(&best).into_iter().map(place).collect()
}

/// The description length of a span.
pub(super) fn cost(blocks: &Blocks, noise: &Noise, span: &Span) -> f64 {
    let squares = blocks.sum(span.first, span.last).squares();
    match span.kind {
        Kind::Line => noise.cost(noise.parameters(span.kind), squares.line),
        Kind::Arc => noise.cost(noise.parameters(span.kind), squares.circle),
        Kind::Spline(_) => free(blocks, noise, span.first, span.last, false).2,
    }
}

/// The best spline over some blocks, its number of control points, and its description length.
pub(super) fn free(
    blocks: &Blocks,
    noise: &Noise,
    first: usize,
    last: usize,
    closed: bool,
) -> (BSpline, usize, f64) {
    let sums = &blocks.sums[first..last];
    let means: Vec<[f64; 2]> = sums.iter().map(|s| s.mean()).collect();
    let lifted: Vec<[f64; 3]> = means.iter().map(|&[x, y]| [x, y, 0.0]).collect();
    let weights: Vec<f64> = sums.iter().map(|s| s.weight).collect();
    let (curve, controls, cost) = spline(&lifted, &weights, noise, closed);
    // The spread of the data about the mean of their block, across the way.
    let way = |k: usize| unit(sub(means[(k + 1).min(means.len() - 1)], means[k.saturating_sub(1)]));
    let spread: f64 = sums.iter().enumerate().map(|(k, sum)| sum.across(way(k))).sum();
    (curve, controls, cost + noise.cost(0, spread))
}

/// The pieces with splines in place of the runs that they describe better.
fn splined(blocks: &Blocks, noise: &Noise, found: &[Span], corners: &[f64]) -> Vec<Span> {
    let n = found.len();
    if n < RUN.0 {
        return found.to_vec();
    }
    let own: Vec<f64> = found.iter().map(|s| cost(blocks, noise, s)).collect();
    let corner = |span: &Span| near_corner(blocks, span.first, corners);
    let mut best: Vec<(f64, usize, Kind)> = vec![(f64::INFINITY, 0, Kind::Line); n + 1];
    best[0].0 = 0.0;
    for a in 0..n {
        let before = best[a].0;
        for b in a + 1..=n.min(a + RUN.1) {
            if b > a + 1 && corner(&found[b - 1]) {
                break;
            }
            let (cost, kind) = match b - a {
                1 => (own[a], found[a].kind),
                k if k < RUN.0 => continue,
                _ => {
                    let (_, controls, cost) = free(blocks, noise, found[a].first, found[b - 1].last, false);
                    (cost, Kind::Spline(controls))
                }
            };
            if before + cost < best[b].0 {
                best[b] = (before + cost, a, kind);
            }
        }
    }
    let place = |s: Span| Span { first: found[s.first].first, last: found[s.last - 1].last, ..s };
    spans(&best).into_iter().map(place).collect()
}

/// Whether the last span of a ring and the first one are better described as one.
pub(super) fn one(blocks: &Blocks, noise: &Noise, last: &Span, first: &Span) -> bool {
    let mut sum = blocks.sum(last.first, last.last);
    sum.add(&blocks.sum(first.first, first.last));
    let squares = sum.squares();
    let line = noise.cost(noise.parameters(Kind::Line), squares.line);
    let arc = noise.cost(noise.parameters(Kind::Arc), squares.circle);
    line.min(arc) < cost(blocks, noise, last) + cost(blocks, noise, first)
}

/// Whether a corner of the outline lies at the beginning of a block.
fn near_corner(blocks: &Blocks, block: usize, corners: &[f64]) -> bool {
    let arc = |k: usize| blocks.data[blocks.starts[k.min(blocks.sums.len() - 1)]].arc;
    let (from, to) = (arc(block.saturating_sub(BESIDE)), arc(block + BESIDE));
    // Over the seam of a ring the arcs begin anew.
    corners.iter().any(|&c| if from <= to { (from..=to).contains(&c) } else { c >= from || c <= to })
}

/// The data of a span.
pub(super) fn data<'a>(blocks: &'a Blocks, span: &Span) -> &'a [Datum] {
    blocks.of(span.first, span.last)
}
