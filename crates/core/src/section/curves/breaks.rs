//! The breaks between the lines, arcs and splines of a contour: those of least description length.
//!
//! `pieces::search` looks at few of the places where long pieces may break; the places about those that it finds are then searched
//! anew, all of them. Runs of pieces that one ellipse or spline describes in fewer numbers become that, between corners.

use super::data::Blocks;
use crate::curve::pieces;
use crate::curve::pieces::noise::{Kind, Noise, Span};
use crate::curve::pieces::search::{search_row, spans};
use crate::curve::pieces::spline;
use crate::curve::{BSpline, Ellipse};
use crate::math::vec2::{sub, unit};

/// Blocks to both sides of a break whose beginnings are looked at again, and those of which every datum is.
const BESIDE: [usize; 2] = [4, 2];
/// Most places that a piece leads over.
const FARTHEST: usize = 200;
/// Fewest pieces that a spline stands for, and most that it or an ellipse does.
const RUN: (usize, usize) = (3, 16);
/// Fewest data of a line and of an arc, and the least standard deviation along each, spacings: what is shorter, or rounder, is not seen.
const LEAST: [(usize, f64); 2] = [(3, 0.2), (6, 0.4)];

/// The pieces in order, spans of data, each up to the first datum of the next.
pub(super) fn breaks(blocks: &Blocks, noise: &Noise, spacing: f64, corners: &[f64]) -> Vec<Span> {
    let mut found = search_row(blocks, noise);
    found.iter_mut().for_each(|s| (s.first, s.last) = (blocks.starts[s.first], blocks.starts[s.last]));
    let found = again(blocks, noise, spacing, &found);
    splined(blocks, noise, &found, corners)
}

/// The places that are looked at again: the beginnings of blocks about each break, and the data nearest to it.
fn places(blocks: &Blocks, found: &[Span]) -> Vec<usize> {
    let mut places: Vec<usize> = vec![0, blocks.data.len()];
    let starts = &blocks.starts;
    for span in &found[1..] {
        let block = starts.partition_point(|&s| s < span.first);
        let [far, near] = BESIDE.map(|b| (block.saturating_sub(b), (block + b).min(starts.len() - 1)));
        places.extend(&starts[far.0..=far.1]);
        places.extend(starts[near.0]..=starts[near.1]);
    }
    places.sort_unstable();
    places.dedup();
    places
}

/// The best pieces that break at places about those found, or none.
fn again(blocks: &Blocks, noise: &Noise, spacing: f64, found: &[Span]) -> Vec<Span> {
    let places = places(blocks, found);
    let between: Vec<_> = places.windows(2).map(|w| blocks.of(w[0], w[1])).collect();
    let mut best = vec![(f64::INFINITY, 0, Kind::Line); places.len()];
    best[0].0 = 0.0;
    for a in 0..places.len() - 1 {
        let (before, mut sum) = (best[a].0, between[a]);
        if !before.is_finite() {
            continue;
        }
        for b in a + 1..places.len().min(a + FARTHEST) {
            if b > a + 1 {
                sum.add(&between[b - 1]);
            }
            let (count, spread) = (places[b] - places[a], sum.spread());
            let enough = LEAST.map(|(fewest, least)| count >= fewest && spread >= least * spacing);
            let whole = a == 0 && b + 1 == places.len();
            if !enough[0] && !whole {
                continue;
            }
            let squares = sum.squares();
            let mut take = |kind, squares| {
                let cost = before + noise.cost(noise.parameters(kind), squares);
                if cost < best[b].0 {
                    best[b] = (cost, a, kind);
                }
            };
            take(Kind::Line, squares.line);
            if enough[1] {
                take(Kind::Arc, squares.circle);
            }
        }
    }
    if !best[places.len() - 1].0.is_finite() {
        return found.to_vec();
    }
    let place = |s: Span| Span { first: places[s.first], last: places[s.last], ..s };
    spans(&best).into_iter().map(place).collect()
}

/// The description length of a span.
fn cost(blocks: &Blocks, noise: &Noise, span: &Span) -> f64 {
    let squares = blocks.of(span.first, span.last).squares();
    match span.kind {
        Kind::Line => noise.cost(noise.parameters(span.kind), squares.line),
        Kind::Arc => noise.cost(noise.parameters(span.kind), squares.circle),
        Kind::Ellipse => {
            oval(blocks, noise, span.first, span.last, f64::INFINITY).map_or(f64::INFINITY, |o| o.1)
        }
        Kind::Spline(_) => free(blocks, noise, span.first, span.last).2,
    }
}

/// The description length of all spans.
pub(super) fn costs(blocks: &Blocks, noise: &Noise, spans: &[Span]) -> f64 {
    spans.iter().map(|s| cost(blocks, noise, s)).sum()
}

/// The best spline over some data, its number of control points, and its description length.
fn free(blocks: &Blocks, noise: &Noise, first: usize, last: usize) -> (BSpline, usize, f64) {
    let (row, weights, spread) = means(blocks, noise, first, last);
    let (curve, controls, cost) = spline(&row, &weights, noise, false);
    (curve, controls, cost + spread)
}

/// The ellipse over some data and its description length, if that is less than `limit`.
pub(super) fn oval(
    blocks: &Blocks,
    noise: &Noise,
    first: usize,
    last: usize,
    limit: f64,
) -> Option<(Ellipse, f64)> {
    let (row, weights, spread) = means(blocks, noise, first, last);
    pieces::oval(&row, &weights, noise, limit - spread).map(|(found, cost)| (found, cost + spread))
}

/// The means of the blocks within some data, their weights, and what the spread of the data about them costs, across the way.
pub(super) fn means(
    blocks: &Blocks,
    noise: &Noise,
    first: usize,
    last: usize,
) -> (Vec<[f64; 3]>, Vec<f64>, f64) {
    let sums = blocks.within(first, last);
    let means: Vec<[f64; 2]> = sums.iter().map(|s| s.mean()).collect();
    let way = |k: usize| unit(sub(means[(k + 1).min(means.len() - 1)], means[k.saturating_sub(1)]));
    let spread: f64 = sums.iter().enumerate().map(|(k, sum)| sum.across(way(k))).sum();
    let row = means.iter().map(|&[x, y]| [x, y, 0.0]).collect();
    (row, sums.iter().map(|s| s.weight).collect(), noise.cost(0, spread))
}

/// The pieces with splines in place of the runs that they describe better.
fn splined(blocks: &Blocks, noise: &Noise, found: &[Span], corners: &[f64]) -> Vec<Span> {
    let n = found.len();
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
            let parts: f64 = own[a..b].iter().sum();
            let (cost, kind) = match b - a {
                1 => (own[a], found[a].kind),
                k => {
                    let (first, last) = (found[a].first, found[b - 1].last);
                    let (_, controls, cost) = match k {
                        _ if k < RUN.0 => (BSpline::default(), 0, f64::INFINITY),
                        _ => free(blocks, noise, first, last),
                    };
                    oval(blocks, noise, first, last, cost.min(parts))
                        .map_or((cost, Kind::Spline(controls)), |o| (o.1, Kind::Ellipse))
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

/// The standard deviation of a datum of weight 1 from the pieces.
pub(super) fn error(blocks: &Blocks, found: &[Span]) -> f64 {
    let (mut sum, mut freedom) = (0.0, 0.0);
    for span in found {
        let squares = blocks.of(span.first, span.last).squares();
        let (squares, parameters) = match span.kind {
            Kind::Line => (squares.line, 2.0),
            Kind::Arc => (squares.circle, 3.0),
            Kind::Ellipse | Kind::Spline(_) => continue,
        };
        sum += squares;
        freedom += ((span.last - span.first) as f64 - parameters).max(0.0);
    }
    if freedom > 0.0 { (sum / freedom).sqrt() } else { 0.0 }
}

/// Whether the last span of a ring and the first one are better described as one.
pub(super) fn one(blocks: &Blocks, noise: &Noise, last: &Span, first: &Span) -> bool {
    let mut sum = blocks.of(last.first, last.last);
    sum.add(&blocks.of(first.first, first.last));
    let squares = sum.squares();
    let line = noise.cost(noise.parameters(Kind::Line), squares.line);
    let arc = noise.cost(noise.parameters(Kind::Arc), squares.circle);
    line.min(arc) < cost(blocks, noise, last) + cost(blocks, noise, first)
}

/// Whether a corner of the outline lies within a few blocks of a datum.
fn near_corner(blocks: &Blocks, datum: usize, corners: &[f64]) -> bool {
    let starts = &blocks.starts;
    let block = starts.partition_point(|&s| s < datum);
    let arc = |k: usize| blocks.data[starts[k].min(blocks.data.len() - 1)].arc;
    let (from, to) = (arc(block.saturating_sub(BESIDE[0])), arc((block + BESIDE[0]).min(starts.len() - 1)));
    // Over the seam of a ring the arcs begin anew.
    corners.iter().any(|&c| if from <= to { (from..=to).contains(&c) } else { c >= from || c <= to })
}
