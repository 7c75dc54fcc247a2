//! The stretch of a section over which the surface bends between two straight ones.

use super::walk::Place;

/// Half the length over which a curvature is taken, in places.
const HALF: usize = 2;
/// Least curvature at the seed, per spacing: that of the greatest blend.
const LEAST: f64 = 0.1;
/// Share of the curvature of the bend below which it ends.
const ENDED: f64 = 0.45;
/// Length of a face beside the bend that is looked at, in spacings, and what a radius adds.
const FACE: (f64, f64) = (3.0, 0.6);

/// A bend with the straight stretches beside it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ramp {
    /// The lengths along the surface between which points are taken.
    pub(super) window: [f64; 2],
    /// The outer places of both straight stretches, and the places where the bend begins and ends, as indices.
    pub(super) faces: [[usize; 2]; 2],
    /// An estimate of the radius.
    pub(super) radius: f64,
}

/// The bend in the middle of the places; `None` if the surface does not bend there, or has no end of bending on a side.
pub(super) fn ramp(places: &[Place]) -> Option<Ramp> {
    let bend = |k: usize| {
        let (a, b) = (k.checked_sub(HALF)?, k + HALF);
        let (a, b) = (places.get(a)?, places.get(b)?);
        Some((b.turn - a.turn) / (b.along - a.along))
    };
    let seed = places.iter().position(|p| p.along == 0.0)?;
    let own = bend(seed)?;
    if own.abs() < LEAST {
        return None;
    }
    let near = (seed.saturating_sub(HALF)..=seed + HALF).filter_map(bend);
    let most = near.map(|b| b * own.signum()).fold(0.0, f64::max);
    let bends = |k: usize| bend(k).map(|b| b * own.signum() > ENDED * most);
    let edge = |step: isize| {
        let mut k = seed;
        while bends(k)? {
            k = k.checked_add_signed(step)?;
        }
        Some(k)
    };
    let (first, last) = (edge(-1)?, edge(1)?);
    let turned = (places[last].turn - places[first].turn).abs();
    let radius = (places[last].along - places[first].along) / turned.max(0.1);
    let far = FACE.0 + FACE.1 * radius;
    // A face ends where it bends as much as the blend, or where the walk ends.
    let outer = |from: usize, step: isize| {
        let mut k = from;
        while let Some(next) = k.checked_add_signed(step).filter(|&n| n < places.len()) {
            let bends = bend(next).is_some_and(|b| b.abs() > ENDED * most);
            if bends || (places[next].along - places[from].along).abs() > far {
                break;
            }
            k = next;
        }
        k
    };
    let ends = [outer(first, -1), outer(last, 1)];
    let window = ends.map(|k| places[k].along);
    Some(Ramp { window, faces: [[ends[0], first], [last, ends[1]]], radius })
}
