//! The robust border penalties.
//!
//! The open angle (Gumhold 2001, equation 8) counts only if it is wider than chance would leave it in as many directions.
//! The direction of the border is at right angles to the middle of the opening, which holds at short borders where the
//! ellipsoid (equation 7) shows none.

use crate::detect::open_angle::{chance_opening, open_angle};
use crate::detect::tensor::ellipsoid;
use crate::math::vec3::{add_scaled, cross, norm, sub};
use crate::measure::Row;
use std::f64::consts::{PI, TAU};

/// Chance that a point within the surface shows its open angle by accident.
const CHANCE: f64 = 1e-3;
/// Least distance of the neighbourhood's centre in the tangent plane, in mean distances of its points: half a disc has its
/// centre at two thirds, a whole one at its own point. What lies below cannot be a border, and most points do.
const LEAST_LEAN: f64 = 0.2;
/// Openings wider than this leave less than half of a plane: the border turns.
const TURN: f64 = 1.2 * PI;

/// The border penalties of point `i` with neighbourhood `wide`; `None` if it cannot lie on a border.
pub fn border(points: &[[f64; 3]], i: usize, wide: &[u32], angles: &mut Vec<f64>) -> Option<Row> {
    let (sum, distances) = wide.iter().fold(([0.0; 3], 0.0), |(sum, total), &j| {
        let d = sub(points[j as usize], points[i]);
        (add_scaled(sum, d, 1.0), total + norm(d))
    });
    if norm(sum) < LEAST_LEAN * distances {
        return None;
    }
    let normal = ellipsoid(points, i, wide).axes.vectors[0];
    let opening = open_angle(points, i, wide, normal, angles);
    if opening.angle < chance_opening(angles.len(), CHANCE).max(0.4 * PI) {
        return None;
    }
    Some(Row {
        scalar: (1.0 - opening.angle / TAU) as f32,
        vector: cross(normal, opening.middle).map(|x| x as f32),
        corner: if opening.angle > TURN { 0.5 } else { 1.0 },
        foot: points[i],
        evidence: 0.0,
        expected: 0.0,
        fold: 0.0,
    })
}
