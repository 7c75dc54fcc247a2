//! Two straight sides of a vertex against one smooth curve through both.

use crate::math::eigen3::eigen3;
use crate::math::skyline::Skyline;
use crate::math::tensor::scatter;
use crate::math::vec3::{add, add_scaled, dot, norm, scale, sub, unit};

/// Greatest distance between path and corner beyond the distance due to the rounding, spacings.
const MISSED_BY: f64 = 0.35;

/// Two straight sides set against one smooth curve at a vertex.
#[derive(Clone, Copy, Debug)]
pub(super) struct Meeting {
    /// The place where their lines meet.
    pub(super) position: [f64; 3],
    /// Of the turn.
    cosine: f64,
    /// Ratio of the residual of the lines to that of the smooth curve.
    pub(super) ratio: f64,
}

impl Meeting {
    /// The meeting of two sides: vertices with their distance along the path, of which `length` is the greatest. No residual
    /// counts for less than `least`.
    pub(super) fn new(sides: &[Vec<(f64, [f64; 3])>; 2], length: f64, least: f64) -> Option<Self> {
        let [behind, ahead] = [0, 1].map(|k| Line::fit(&sides[k]));
        let position = crossing(&behind, &ahead)?;
        let count = (sides[0].len() + sides[1].len()) as f64;
        let straight = ((behind.squares + ahead.squares) / count).sqrt();
        let ratio = straight / smooth_residual(sides, length).max(least);
        Some(Self { position, cosine: -dot(behind.direction, ahead.direction), ratio })
    }

    /// The turn, degrees, and the length of path on either side that is rounded if the path passes the corner at the distance
    /// `aside`, spacings: an arc of radius `r` misses a corner by `r (1 / cos(turn / 2) - 1)` and leaves its sides
    /// `r tan(turn / 2)` before it. `None` if no rounding explains the distance.
    pub(super) fn rounding(&self, aside: f64, rounded: f64) -> Option<(f64, f64)> {
        let half = 0.5 * self.cosine.clamp(-1.0, 1.0).acos();
        let missed = (1.0 / half.cos().max(0.1) - 1.0).max(1e-6);
        let radius = (aside / missed).min(rounded);
        (aside <= rounded * missed + MISSED_BY).then(|| (2.0 * half.to_degrees(), radius * half.tan()))
    }
}

/// A straight line through one side.
struct Line {
    centre: [f64; 3],
    /// Unit, away from the corner.
    direction: [f64; 3],
    /// Sum of the squared distances from the line.
    squares: f64,
}

impl Line {
    fn fit(side: &[(f64, [f64; 3])]) -> Line {
        let share = 1.0 / side.len() as f64;
        let centre = side.iter().fold([0.0; 3], |sum, s| add_scaled(sum, s.1, share));
        let axes = eigen3(&scatter(side.iter().map(|s| sub(s.1, centre))));
        let outward = sub(side[side.len() - 1].1, side[0].1);
        let axis = axes.vectors[2];
        let direction = if dot(axis, outward) < 0.0 { scale(axis, -1.0) } else { axis };
        Line { centre, direction, squares: axes.values[0].max(0.0) + axes.values[1].max(0.0) }
    }
}

/// The middle between the places where two lines pass nearest.
fn crossing(a: &Line, b: &Line) -> Option<[f64; 3]> {
    let cosine = dot(a.direction, b.direction);
    let sine2 = 1.0 - cosine * cosine;
    if sine2 < 1e-3 {
        return None;
    }
    let gap = sub(b.centre, a.centre);
    let (u, v) = (dot(gap, a.direction), dot(gap, b.direction));
    let p = add_scaled(a.centre, a.direction, (u - cosine * v) / sine2);
    let q = add_scaled(b.centre, b.direction, (cosine * u - v) / sine2);
    Some(scale(add(p, q), 0.5))
}

/// Root mean square residual of the best cubic curve through both sides, as a function of the distance along the path in units of
/// `length`.
fn smooth_residual(sides: &[Vec<(f64, [f64; 3])>; 2], length: f64) -> f64 {
    let all = || sides.iter().flatten().map(|&(s, p)| (s / length, p));
    let mut matrix = Skyline::zeros(vec![0; 4]);
    let mut right = vec![[0.0; 3]; 4];
    for (s, p) in all() {
        let powers = [1.0, s, s * s, s * s * s];
        for i in 0..4 {
            right[i] = add_scaled(right[i], p, powers[i]);
            (i..4).for_each(|j| matrix.add(i, j, powers[i] * powers[j]));
        }
    }
    if !matrix.factorise() {
        return 0.0;
    }
    matrix.solve(&mut right);
    let (mut squares, mut count) = (0.0, 0.0);
    for (s, p) in all() {
        let at =
            [s, s * s, s * s * s].iter().zip(&right[1..]).fold(right[0], |a, (&w, &c)| add_scaled(a, c, w));
        let tangent = unit(add_scaled(add_scaled(right[1], right[2], 2.0 * s), right[3], 3.0 * s * s));
        let d = sub(p, at);
        let aside = norm(add_scaled(d, tangent, -dot(d, tangent)));
        squares += aside * aside;
        count += 1.0;
    }
    (squares / count).sqrt()
}
