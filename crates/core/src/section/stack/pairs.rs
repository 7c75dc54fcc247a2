//! The way of an outline to another one, point by point: each part of a wall that leans evenly moves evenly with height.

use super::profile::Profile;
use crate::math::vec2::{along, cross, distance, dot, sub, unit};

/// Cosine of the angle within which walls face alike.
const FACING_COSINE: f64 = 0.7;

/// Points of the lower and of the higher outline that belong together, in order.
pub(super) type Pair = ([f64; 2], [f64; 2]);

/// The points of the larger outline, in order, each with its place on the smaller one. The other way round, points beside a
/// corner would miss the side that has moved.
pub(super) fn pairs(low: &Profile, high: &Profile, tolerance: f64) -> Vec<Pair> {
    if low.area >= high.area {
        onto(low, high, tolerance)
    } else {
        onto(high, low, tolerance).into_iter().map(|(p, q)| (q, p)).collect()
    }
}

/// The points of an outline, each with the nearest of another; where that lies along the wall and not across it, with the
/// nearest that faces alike: the end of a wall that has become shorter.
fn onto(from: &Profile, to: &Profile, tolerance: f64) -> Vec<Pair> {
    let [own, other] = [from, to].map(facing);
    let pair = |&(p, normal): &([f64; 2], [f64; 2])| {
        let (foot, off) = to.outline.nearest(p);
        if off <= tolerance || dot(sub(foot, p), normal).abs() >= FACING_COSINE * off {
            return (p, foot);
        }
        let alike = other.iter().filter(|o| dot(o.1, normal) >= FACING_COSINE).map(|o| o.0);
        let near = alike.min_by(|a, b| distance(*a, p).total_cmp(&distance(*b, p)));
        (p, near.unwrap_or(foot))
    };
    own.iter().map(pair).collect()
}

/// Points of an outline with the direction square to it, to its right.
fn facing(profile: &Profile) -> Vec<([f64; 2], [f64; 2])> {
    let points: Vec<[f64; 2]> = profile.sample().collect();
    let n = points.len();
    let normal = |k: usize| {
        let [x, y] = unit(sub(points[(k + 1) % n], points[(k + n - 1) % n]));
        [y, -x]
    };
    (0..n).map(|k| (points[k], normal(k))).collect()
}

/// The outline at a share of the way from the lower to the higher one.
pub(super) fn blend(pairs: &[Pair], share: f64) -> Vec<[f64; 2]> {
    pairs.iter().map(|&(a, b)| along(a, sub(b, a), share)).collect()
}

/// How the area grows with the square of the share of the way, were the walls to go on beyond both outlines: the area
/// that the moves of its points enclose. Moves that fold back on a straight wall enclose none.
pub(super) fn bent(pairs: &[Pair]) -> f64 {
    let moves: Vec<[f64; 2]> = pairs.iter().map(|&(a, b)| sub(b, a)).collect();
    let next = moves.iter().cycle().skip(1);
    let turn = pairs.iter().zip(pairs.iter().cycle().skip(1)).map(|(p, q)| cross(p.0, q.0)).sum::<f64>();
    0.5 * turn.signum() * moves.iter().zip(next).map(|(&a, &b)| cross(a, b)).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::polyline::Polyline;

    /// A rectangle with its lower left corner at the origin, points about a twentieth apart.
    fn rectangle(height: f64, x: f64, y: f64) -> Profile {
        let corners = [[0.0, 0.0], [x, 0.0], [x, y], [0.0, y]];
        let side = |k: usize| {
            let (from, way) = (corners[k], sub(corners[(k + 1) % 4], corners[k]));
            let steps = (20.0 * way[0].hypot(way[1])).round() as usize;
            (0..steps).map(move |s| along(from, way, s as f64 / steps as f64))
        };
        let points: Vec<[f64; 2]> = (0..4).flat_map(side).collect();
        Profile {
            id: (0, 0),
            height,
            outline: Polyline::new(&points, true, 0.05),
            hole: false,
            area: x * y,
            signed_area: x * y,
            length: 2.0 * (x + y),
            centroid: [0.5 * x, 0.5 * y],
            round: None,
            draft_deg: 0.0,
            steepest_deg: 0.0,
        }
    }

    #[test]
    fn the_moves_of_an_outline_tell_how_its_area_bends() {
        // From x by y to (x + dx) by (y + dy) the area grows with the square of the way by dx dy.
        for ([x, y], [dx, dy]) in
            [([2.0, 1.0], [0.4, 0.3]), ([2.0, 1.0], [0.0, 0.5]), ([3.0, 2.0], [0.5, -0.25])]
        {
            let (low, high) = (rectangle(0.0, x, y), rectangle(1.0, x + dx, y + dy));
            for (low, high) in [(&low, &high), (&high, &low)] {
                let found = bent(&pairs(low, high, 1e-3));
                // To about a step between points along a side.
                assert!((found - dx * dy).abs() < 0.02, "{found} of {}", dx * dy);
            }
        }
    }
}
