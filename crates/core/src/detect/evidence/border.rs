//! The robust border penalties.
//!
//! The open angle (Gumhold 2001, equation 8) counts only if it is wider than the angle that chance leaves between as many
//! directions. The border runs at right angles to the middle of the opening; this holds at short borders too, where the
//! ellipsoid (equation 7) shows no direction.

use super::open_angle::{chance_opening, open_angle};
use super::surroundings::Surroundings;
use crate::math::tensor::ellipsoid;
use crate::math::vec3::{add_scaled, cross, dot, norm, sub};
use crate::measure::Row;
use crate::params::PenaltyParams;
use crate::resolution::Resolution;
use std::f64::consts::{PI, TAU};

/// Least distance between a border point and the centre of its direct neighbours, in units of their mean distance. The centre
/// of half a disc lies at two thirds, that of a whole disc at the point itself, apart from chance. Most points are below it.
const BORDER_LEAN: f64 = 0.3;
/// Sine of half the fold, 108 degrees, above which one face hides the other and an opening is not a border.
pub(crate) const HIDING_FOLD: f64 = 0.809;
/// Opening above which the border turns, as less than half of the plane is left.
const TURNING_OPENING: f64 = 1.2 * PI;

/// Whether the direct neighbours lie to one side: a cheap test that saves computing the open angle of most points.
pub fn may_be_border(points: &[[f64; 3]], i: usize, near: &[u32]) -> bool {
    let (sum, distances) = near.iter().fold(([0.0; 3], 0.0), |(sum, total), &j| {
        let d = sub(points[j as usize], points[i]);
        (add_scaled(sum, d, 1.0), total + norm(d))
    });
    norm(sum) >= BORDER_LEAN * distances
}

/// Rise of a face over the tangent plane of one of its points, by distance in the plane and at the point itself, in spacings, and
/// what a spacing of noise adds: points farther off lie on another sheet.
const RISE: (f64, f64, f64) = (0.5, 0.5, 2.0);

/// The border penalties of point `i` with neighbourhood `wide`, where the surface folds by `fold`, the sine of half the angle;
/// `None` if it cannot lie on a border.
///
/// Where the surface is smooth its own face alone counts: two sheets a few spacings apart are thicker than their rims are deep, so
/// that the ellipsoid of both stands on end.
pub(crate) fn border(
    surroundings: &Surroundings,
    i: usize,
    wide: &[u32],
    fold: f64,
    params: &PenaltyParams,
    angles: &mut Vec<f64>,
) -> Option<Row> {
    let (points, scale) = (surroundings.points, surroundings.scales.at(i));
    if fold < surroundings.least_fold {
        let normal = surroundings.normal(i);
        return row(points, i, &face(points, i, wide, normal, scale), normal, scale, params, angles);
    }
    let normal = ellipsoid(points, i, wide).axes.vectors[0];
    row(points, i, wide, normal, scale, params, angles)
}

/// The points of `wide` that can lie on one face with point `i`, of which `normal` is the normal.
fn face(points: &[[f64; 3]], i: usize, wide: &[u32], normal: [f64; 3], scale: Resolution) -> Vec<u32> {
    let (slope, least, noisy) = RISE;
    let least = least * scale.spacing + noisy * scale.noise;
    let on = |j: &u32| {
        let d = sub(points[*j as usize], points[i]);
        let height = dot(d, normal).abs();
        height <= least + slope * (dot(d, d) - height * height).max(0.0).sqrt()
    };
    wide.iter().copied().filter(on).collect()
}

/// The border penalties of point `i` among `near`, seen along `normal`.
fn row(
    points: &[[f64; 3]],
    i: usize,
    near: &[u32],
    normal: [f64; 3],
    scale: Resolution,
    params: &PenaltyParams,
    angles: &mut Vec<f64>,
) -> Option<Row> {
    let opening = open_angle(points, i, near, normal, angles);
    let least = params.opening_deg.to_radians();
    if opening.angle < chance_opening(angles.len(), params.opening_chance).max(least) {
        return None;
    }
    let along = cross(normal, opening.middle);
    let outward = outermost(points, i, near, along, opening.middle, scale);
    Some(Row {
        scalar: (1.0 - opening.angle / TAU) as f32, // equation 8
        vector: along.map(|x| x as f32),
        corner: if opening.angle > TURNING_OPENING { 0.5 } else { 1.0 },
        foot: add_scaled(points[i], opening.middle, outward),
        evidence: None,
    })
}

/// Distance of the border outward of point `i`: a little beyond the outermost point of a strip across the border.
///
/// In a strip two spacings wide with one point for each square spacing, the outermost point lies .35 spacings inside the border
/// in the median; noise moves it outward by about .35 of its standard deviation.
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
