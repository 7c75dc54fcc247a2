//! Smooths clouds too noisy for the segmentation (Demarsin et al. 2007, section 3: "a smoothing method should be applied first
//! and a larger neighborhood for normal estimation can be used"; the paper gives no rule).
//!
//! The rule here: a face has more points than a neighbourhood. If less than half of all points lie in clusters of more than
//! `k` points, every point moves to the least-squares plane of its neighbours, normals are taken from rings of one more edge,
//! and the segmentation is repeated, up to three times.

use super::segmentation::Segmentation;
use crate::math::tensor::ellipsoid;
use crate::math::vec3::{add_scaled, dot, sub};
use crate::neighbors::{Neighbors, riemannian::Scratch};
use crate::parallel;

/// Greatest number of rounds of smoothing.
pub const ROUNDS: usize = 3;
/// Share of the points that must lie in faces.
const IN_FACES: f64 = 0.5;

/// Whether the cloud is too noisy for the angle of these clusters.
pub fn too_noisy(segments: &Segmentation, k: usize) -> bool {
    let faces: u32 = segments.size.iter().filter(|&&size| size as usize > k).sum();
    f64::from(faces) < IN_FACES * segments.label.len() as f64
}

/// The points, each moved to the least-squares plane of its neighbours.
pub fn smoothed(points: &[[f64; 3]], nearest: &Neighbors) -> Vec<[f64; 3]> {
    parallel::map(points.len(), parallel::QUICK, |i| {
        let plane = ellipsoid(points, i, nearest.of(i));
        let normal = plane.axes.vectors[0];
        add_scaled(points[i], normal, dot(normal, sub(plane.centre, points[i])))
    })
}

/// `(N, 3)` normals of the least-squares planes through all points within `depth` edges of the rings.
pub fn wide_normals(points: &[[f64; 3]], rings: &Neighbors, depth: usize) -> Vec<[f32; 3]> {
    parallel::map_with(points.len(), parallel::QUICK, |scratch: &mut Scratch, i| {
        ellipsoid(points, i, rings.hops(i, depth, scratch)).axes.vectors[0].map(|x| x as f32)
    })
}
