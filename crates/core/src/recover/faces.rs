//! Circles and arcs from the faces: the vertices of a crease are means over tangent planes, which bend away from the wall of a
//! bore, so that its circle comes out too large. Here the two faces beside each line, arc and circle are fitted together with the
//! edge in which they meet, in the cross-section that moves along it; the curve is that edge.

mod fitted;
mod gather;
mod lengths;
mod profile;
mod solve;
mod sweep;

use crate::curve::pieces::{Free, Piece, Shape, rejoin};
use crate::math::vec3::distance2;
use crate::neighbors::{Neighbors, riemannian::Scratch};
use crate::network::{Network, Strip, StripKind};
use crate::parallel;
use crate::surface::Scales;
pub(super) use fitted::Fitted;
pub(crate) use gather::HOPS;
pub(super) use gather::near;
pub(super) use lengths::Lengths;
pub(super) use profile::Profile;
pub(super) use solve::fit;
pub(super) use sweep::{Seen, Sweep};

/// Fewest points on a face.
pub(super) const FACE_POINTS: usize = 8;
/// Least sine of the fold.
const FOLD_SINE: f64 = 0.2;
/// Points of the path that the prior holds.
const HELD: usize = 5;
/// Length of a piece, in spacings, from which on the points beside its ends are left to the faces there.
const LONG: f64 = 6.0;

/// Fits the typed curves of creases with arcs to the faces beside them; local frame, sources as canonical indices.
pub(crate) fn refit(network: &mut Network, points: &[[f64; 3]], graph: &Neighbors, scales: Scales) {
    let is_round = |p: &Piece| matches!(p.shape, Shape::Arc { .. } | Shape::Circle(_));
    let strips = &network.strips;
    let moved = parallel::map_with(strips.len(), parallel::TASK, |scratch: &mut Scratch, s| {
        let strip = &strips[s];
        if strip.kind != StripKind::Crease || !strip.curves.iter().any(is_round) {
            return None;
        }
        let near = gather::near(strip, graph, scratch);
        let near: Vec<[f64; 3]> = near.iter().map(|&i| points[i as usize]).collect();
        one(strip, &near, Lengths::of(scales.finest(&strip.sources)))
    });
    for (strip, moved) in network.strips.iter_mut().zip(moved) {
        if let Some(moved) = moved {
            strip.curves = moved;
        }
    }
}

/// The pieces of a strip, fitted to the points near it; `None` if they do not join.
fn one(strip: &Strip, near: &[[f64; 3]], lengths: Lengths) -> Option<Vec<Piece>> {
    let fitted: Vec<Option<Fitted>> = strip.curves.iter().map(|p| of_piece(p, near, lengths)).collect();
    let free: Vec<Free> = strip
        .curves
        .iter()
        .zip(&fitted)
        .map(|(piece, f)| f.as_ref().map_or_else(|| Free::of(piece), |f| f.sweep.free()))
        .collect();
    let mut moved = rejoin(&strip.curves, &free, strip.closed, lengths.spacing)?;
    for (piece, fitted) in moved.iter_mut().zip(&fitted) {
        if let Some(fitted) = fitted {
            piece.sigma = fitted.sigma();
            piece.deviation = deviation(piece, &strip.points);
        }
    }
    Some(moved)
}

/// The edge along a piece, fitted to the points beside it; `None` where they do not show two faces.
pub(super) fn of_piece(piece: &Piece, near: &[[f64; 3]], lengths: Lengths) -> Option<Fitted> {
    let sweep = Sweep::of(piece)?;
    let (from, to) = sweep.range(piece);
    let whole = matches!(piece.shape, Shape::Circle(_));
    let margin = if whole || to - from < LONG * lengths.spacing { 0.0 } else { lengths.spacing };
    let beside = |p: &&[f64; 3]| {
        let seen = sweep.see(**p);
        let off = seen.at[0].hypot(seen.at[1]);
        seen.phase >= from + margin && seen.phase <= to - margin && off <= lengths.reach + lengths.spacing
    };
    let points: Vec<[f64; 3]> = near.iter().filter(beside).copied().collect();
    if points.len() < 2 * FACE_POINTS {
        return None;
    }
    let phase = |k: usize| from + (to - from) * k as f64 / (HELD - 1) as f64;
    let held: Vec<[f64; 3]> = (0..HELD).map(|k| sweep.point(phase(k))).collect();
    let fitted = fit(&points, &held, sweep, lengths)?;
    let moved = |&p: &[f64; 3]| {
        let [x, y] = fitted.sweep.see(p).at;
        x.hypot(y)
    };
    let stays = held.iter().map(moved).fold(0.0, f64::max) <= lengths.far;
    let known = fitted.counts.iter().all(|&c| c >= FACE_POINTS) && fitted.fold_sine >= FOLD_SINE;
    (stays && known && fitted.spread <= lengths.loose).then_some(fitted)
}

/// Root mean square distance of the strip's points from a piece.
fn deviation(piece: &Piece, points: &[[f64; 3]]) -> f64 {
    let n = points.len();
    let last = if piece.last <= piece.first { piece.last + n } else { piece.last };
    let squares: f64 = (piece.first..=last).map(|k| points[k % n]).map(|p| distance2(p, piece.foot(p))).sum();
    (squares / (last + 1 - piece.first) as f64).sqrt()
}

#[cfg(test)]
mod tests;
