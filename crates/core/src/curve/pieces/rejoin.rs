//! Pieces that meet again after their curves have moved.

use super::free::{Free, meet};
use super::piece::{Piece, Shape};
use crate::curve::round::Round;
use crate::math::vec3::{dot, scale};

/// Samples of an arc by which it is fitted to ends that moved.
const SAMPLES: usize = 17;
/// Weight of the radius against that of all samples: both ends are nodes, or lie on a neighbour, and know less of the radius than the
/// circle that the arc is laid along.
const HOLD: f64 = 10.0;
/// Greatest change of the angle that an arc sweeps, radians.
const TURN: f64 = 1.0;

/// The pieces on the curves `free`, one each: neighbours meet where these do, if that is within `reach` of where they met, and the first
/// and last end of an open row stay. `None` where an arc would become another.
pub(crate) fn rejoin(pieces: &[Piece], free: &[Free], closed: bool, reach: f64) -> Option<Vec<Piece>> {
    if let ([circle], [Free::Arc(round)]) = (pieces, free)
        && matches!(circle.shape, Shape::Circle(_))
    {
        let at = round.foot(circle.from);
        return Some(vec![Piece { shape: Shape::Circle(*round), from: at, to: at, ..circle.clone() }]);
    }
    let n = pieces.len();
    let joint = |k: usize| match (k, closed) {
        (0, false) => pieces[0].from,
        (k, false) if k == n => pieces[n - 1].to,
        _ => meet(&free[(k + n - 1) % n], &free[k % n], pieces[k % n].from, reach),
    };
    pieces.iter().zip(free).enumerate().map(|(k, (p, f))| between(p, f, [joint(k), joint(k + 1)])).collect()
}

/// A piece along a curve from one end to another.
fn between(piece: &Piece, free: &Free, [from, to]: [[f64; 3]; 2]) -> Option<Piece> {
    let shape = match (&piece.shape, free) {
        (Shape::Arc { round, sweep }, Free::Arc(moved)) => arc(round, *sweep, moved, piece.from, [from, to])?,
        (Shape::Spline(curve), _) => {
            let mut curve = curve.clone();
            if let ([first, .., last], false) = (&mut curve.controls[..], curve.periodic) {
                (*first, *last) = (from, to);
            }
            Shape::Spline(curve)
        }
        (Shape::Ellipse { ellipse, sweep }, _) => {
            let moved = ellipse.through(from, to)?;
            let swept = moved.sweep_between(from, to);
            ((swept - sweep).abs() < TURN).then_some(Shape::Ellipse { ellipse: moved, sweep: swept })?
        }
        (shape, _) => shape.clone(),
    };
    Some(Piece { shape, from, to, ..piece.clone() })
}

/// The arc along the circle `moved` in the sense of `old`, which began at `start`, through two ends.
fn arc(old: &Round, sweep: f64, moved: &Round, start: [f64; 3], [from, to]: [[f64; 3]; 2]) -> Option<Shape> {
    let turned = |r: Round| {
        if dot(r.normal, old.normal) < 0.0 { Round { normal: scale(r.normal, -1.0), ..r } } else { r }
    };
    let moved = turned(*moved);
    let samples = moved.samples(start, sweep, SAMPLES);
    let round = turned(moved.through(from, to, &samples, HOLD * SAMPLES as f64)?);
    let swept = round.sweep_between(from, to);
    ((swept - sweep).abs() < TURN).then_some(Shape::Arc { round, sweep: swept })
}
