//! Normal difference: the mean angle between the normal of a point and those around it (a measure to which Tran 2013, figure 6,
//! compares his own).

use super::SCALE;
use crate::detect::projection::scales::at_every_scale;
use crate::math::vec3::dot;

/// `(N)` mean angle between the unoriented normal of a point and those of its 16 nearest neighbours: radians, 0 to pi/2. The
/// normals are those of Hoppe 1992 at the same scale.
pub(super) fn mean_angle(points: &[[f64; 3]]) -> Vec<f32> {
    let normals = at_every_scale(points, |_, _, scales| scales[SCALE.1].normal);
    at_every_scale(points, |i, nearest, _| {
        let near = &nearest[..SCALE.0.min(nearest.len())];
        let angle = |&j: &u32| dot(normals[i], normals[j as usize]).abs().min(1.0).acos();
        (near.iter().map(angle).sum::<f64>() / near.len() as f64) as f32
    })
}
