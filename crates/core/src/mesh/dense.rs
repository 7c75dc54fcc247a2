//! Whether the vertices of a mesh lie densely enough to stand for its surface.

use super::canonical::Surface;
use crate::math::vec3::distance;

/// Vertices below which no mesh is dense.
const FEWEST: usize = 500;
/// Length of an edge, in mean distances of vertices, beyond which a triangle leaves a hole between them.
const LONG: f64 = 3.0;
/// Share of the area that triangles with such edges may have.
const HOLES: f64 = 0.1;
/// Mean distances of vertices that the smallest features must have.
const RESOLVED: f64 = 5.0;

/// Whether the vertices lie evenly, and closely enough for features of a size.
pub(super) fn is_dense(surface: &Surface, feature: Option<f64>) -> bool {
    let spacing = (surface.area / surface.vertices.len() as f64).sqrt();
    if surface.vertices.len() < FEWEST || feature.is_some_and(|size| size < RESOLVED * spacing) {
        return false;
    }
    let longest = |t: &[u32; 3]| {
        let [a, b, c] = surface.corners(t);
        distance(a, b).max(distance(b, c)).max(distance(c, a))
    };
    let holes = surface.triangles.iter().zip(&surface.areas).filter(|(t, _)| longest(t) > LONG * spacing);
    holes.map(|(_, area)| area).sum::<f64>() <= HOLES * surface.area
}
