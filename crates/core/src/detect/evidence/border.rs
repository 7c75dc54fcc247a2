//! The robust border penalties.
//!
//! The open angle (Gumhold 2001, equation 8) counts only if it is wider than chance would leave it in as many directions.
//! The direction of the border is at right angles to the middle of the opening, which holds at short borders where the
//! ellipsoid (equation 7) shows none.

use super::open_angle::{chance_opening, open_angle};
use crate::math::tensor::ellipsoid;
use crate::math::vec3::{add_scaled, cross, dot, norm, sub};
use crate::measure::Row;
use crate::params::PenaltyParams;
use crate::resolution::Resolution;
use std::f64::consts::{PI, TAU};

/// Least distance of the direct neighbours' centre from a point of a border, in their mean distance: half a disc has its
/// centre at two thirds, a whole one at its own point, give or take chance. Most points lie below.
const BORDER_LEAN: f64 = 0.3;
/// Sine of half the fold from which on one face hides the other, and an opening is no border: 108 degrees.
pub(crate) const HIDING_FOLD: f64 = 0.809;
/// Openings wider than this leave less than half of a plane: the border turns.
const TURNING_OPENING: f64 = 1.2 * PI;

/// Whether the direct neighbours lie to one side: a cheap test that spares most points the open angle.
pub fn may_be_border(points: &[[f64; 3]], i: usize, near: &[u32]) -> bool {
    let (sum, distances) = near.iter().fold(([0.0; 3], 0.0), |(sum, total), &j| {
        let d = sub(points[j as usize], points[i]);
        (add_scaled(sum, d, 1.0), total + norm(d))
    });
    norm(sum) >= BORDER_LEAN * distances
}

/// The border penalties of point `i` with neighbourhood `wide`; `None` if it cannot lie on a border.
pub fn border(
    points: &[[f64; 3]],
    i: usize,
    wide: &[u32],
    scale: Resolution,
    params: &PenaltyParams,
    angles: &mut Vec<f64>,
) -> Option<Row> {
    let normal = ellipsoid(points, i, wide).axes.vectors[0];
    let opening = open_angle(points, i, wide, normal, angles);
    let least = params.opening_deg.to_radians();
    if opening.angle < chance_opening(angles.len(), params.opening_chance).max(least) {
        return None;
    }
    let along = cross(normal, opening.middle);
    let outward = outermost(points, i, wide, along, opening.middle, scale);
    Some(Row {
        scalar: (1.0 - opening.angle / TAU) as f32, // equation 8
        vector: along.map(|x| x as f32),
        corner: if opening.angle > TURNING_OPENING { 0.5 } else { 1.0 },
        foot: add_scaled(points[i], opening.middle, outward),
        evidence: None,
    })
}

/// How far the border lies outward of point `i`: a little beyond the outermost of the points beside it.
///
/// In a strip two spacings wide with one point a square spacing, the outermost one lies .35 spacings within the border in
/// the median; noise carries it outward by about as much of its standard deviation.
fn outermost(
    points: &[[f64; 3]],
    i: usize,
    wide: &[u32],
    along: [f64; 3],
    outward: [f64; 3],
    scale: Resolution,
) -> f64 {
    let beside = wide
        .iter()
        .map(|&j| sub(points[j as usize], points[i]))
        .filter(|&d| dot(d, along).abs() <= scale.unit());
    let farthest = beside.map(|d| dot(d, outward)).fold(0.0, f64::max);
    farthest + 0.35 * (scale.spacing - scale.noise).max(0.0)
}
