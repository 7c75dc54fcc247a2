//! The greatest distance of a contour's vertices from its pieces; where that is beyond the bound, a spline through the vertices instead.

use super::data::Blocks;
use super::{Piece, Shape};
use crate::curve::circle::Circle;
use crate::curve::fit_within;
use crate::curve::pieces::noise::Span;
use crate::math::vec2::{cross, onto, sub, unit};
use crate::section::contour::chain::Vertex;

/// Points of a spline for each of its control points, of which the nearest is taken.
const SAMPLES: usize = 16;

/// The pieces with their greatest distances from the vertices, at most `limit` where splines can.
pub(super) fn bound(
    pieces: Vec<Piece>,
    blocks: &Blocks,
    spans: &[Span],
    (vertices, arcs): (&[Vertex], &[f64]),
    limit: f64,
) -> Vec<Piece> {
    let mut own: Vec<Vec<[f64; 2]>> = vec![Vec::new(); pieces.len()];
    let order = in_order(blocks, arcs);
    let mut span = 0;
    for (place, v) in order {
        while span + 1 < spans.len() && place >= spans[span].last {
            span += 1;
        }
        own[span].push(vertices[v].at);
    }
    let n = pieces.len();
    let worst = |(k, own): (usize, &Vec<[f64; 2]>)| {
        // Where pieces touch, the data do not say to which a vertex belongs.
        let near = [k, (k + 1) % n, (k + n - 1) % n];
        let least = |&p: &[f64; 2]| near.iter().map(|&j| off(&pieces[j], p)).fold(f64::INFINITY, f64::min);
        own.iter().map(least).fold(0.0, f64::max)
    };
    let worst: Vec<f64> = own.iter().enumerate().map(worst).collect();
    let bounded = |((piece, own), worst): ((Piece, Vec<[f64; 2]>), f64)| bounded(piece, &own, worst, limit);
    pieces.into_iter().zip(own).zip(worst).map(bounded).collect()
}

/// A ring that is no circle and has no break as one spline through its vertices.
pub(super) fn ring(vertices: &[Vertex], limit: f64) -> Vec<Piece> {
    let row: Vec<[f64; 2]> = vertices.iter().chain(&vertices[..1]).map(|v| v.at).collect();
    let [from, to] = [row[0], row[row.len() - 1]];
    match fit_within(&row, limit) {
        Some((spline, worst)) => vec![Piece { shape: Shape::Free(spline), from, to, worst }],
        None => {
            row.windows(2).map(|w| Piece { shape: Shape::Line, from: w[0], to: w[1], worst: 0.0 }).collect()
        }
    }
}

/// Each vertex with the first datum after it, in the order of the data, which may begin anywhere on a ring.
fn in_order(blocks: &Blocks, arcs: &[f64]) -> Vec<(usize, usize)> {
    let n = blocks.data.len();
    let seam = (1..n).find(|&k| blocks.data[k].arc < blocks.data[k - 1].arc).unwrap_or(0);
    let (late, early) = blocks.data.split_at(seam);
    let place = |arc: f64| {
        let in_early = early.partition_point(|d| d.arc < arc);
        if seam == 0 {
            in_early
        } else if in_early < early.len() {
            seam + in_early
        } else {
            // After the end of the early ones: among the late ones, which come first.
            late.partition_point(|d| d.arc < arc)
        }
    };
    let mut order: Vec<(usize, usize)> = arcs.iter().enumerate().map(|(v, &arc)| (place(arc), v)).collect();
    order.sort_unstable();
    order
}

fn bounded(mut piece: Piece, own: &[[f64; 2]], worst: f64, limit: f64) -> Piece {
    piece.worst = worst;
    if piece.worst <= limit {
        return piece;
    }
    let inner = own.iter().copied().filter(|&p| p != piece.from && p != piece.to);
    let row: Vec<[f64; 2]> = std::iter::once(piece.from).chain(inner).chain([piece.to]).collect();
    match fit_within(&row, limit) {
        Some((spline, worst)) if worst < piece.worst => Piece { shape: Shape::Free(spline), worst, ..piece },
        _ => piece,
    }
}

/// Distance of a point from a piece, lines and arcs taken as endless.
fn off(piece: &Piece, p: [f64; 2]) -> f64 {
    match &piece.shape {
        Shape::Line => {
            let way = unit(sub(piece.to, piece.from));
            cross(way, sub(p, piece.from)).abs()
        }
        Shape::Arc { centre, radius, .. } | Shape::Circle { centre, radius } => {
            Circle { centre: *centre, radius: *radius }.off(p)
        }
        Shape::Ellipse { ellipse, .. } => crate::math::vec2::distance(ellipse.foot(p), p),
        Shape::Free(curve) => {
            let (from, to) = curve.domain();
            let count = SAMPLES * curve.controls.len();
            let at = |k: usize| curve.point(from + (to - from) * k as f64 / count as f64);
            (0..count).map(|k| onto(at(k), at(k + 1), p).1).fold(f64::INFINITY, f64::min)
        }
    }
}
