//! Absorbs small clusters into the large ones beside them (robust form; not in Demarsin et al. 2007).

use super::segmentation::Segmentation;
use crate::math::vec3::{dot, sub};
use crate::neighbors::Neighbors;
use crate::parallel;

/// Rounds of absorbing neighbours: the depth, in edges, of the band between two faces.
const ROUNDS: usize = 6;

/// Gives each point of a small cluster to the large cluster whose tangent plane is nearest, from the outside inwards.
///
/// Points that are not reached in a few rounds stay a small cluster: a region that is curved too sharply to be a face.
pub fn absorb(
    mut segments: Segmentation,
    points: &[[f64; 3]],
    normals: &[[f32; 3]],
    graph: &Neighbors,
) -> Segmentation {
    for _ in 0..ROUNDS {
        let taken = parallel::flat_map(points.len(), parallel::QUICK, |i, taken| {
            if !segments.large[segments.label[i] as usize] {
                taken.extend(best(&segments, points, normals, graph.of(i), i).map(|label| (i, label)));
            }
        });
        if taken.is_empty() {
            break;
        }
        for (i, label) in taken {
            segments.size[segments.label[i] as usize] -= 1;
            segments.size[label as usize] += 1;
            segments.label[i] = label;
        }
    }
    segments
}

/// The large cluster of the neighbour whose tangent plane is nearest to the point; the first among equals.
fn best(
    segments: &Segmentation,
    points: &[[f64; 3]],
    normals: &[[f32; 3]],
    near: &[u32],
    i: usize,
) -> Option<u32> {
    near.iter()
        .filter(|&&j| segments.large[segments.label[j as usize] as usize])
        .map(|&j| {
            let offset = dot(normals[j as usize].map(f64::from), sub(points[i], points[j as usize]));
            (offset.abs(), segments.label[j as usize])
        })
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, label)| label)
}
