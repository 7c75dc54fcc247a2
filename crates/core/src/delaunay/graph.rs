//! The neighbour graph of the filtered triangles: it "helps to disconnect data points that lay on different surface parts", and has
//! fewer edges than the Riemannian graph.

use super::filter::filter;
use super::triangle::{Triangle, edges};
use crate::error::Error;
use crate::math::vec3::distance2;
use crate::neighbors::Neighbors;

/// The edges of the filtered Delaunay triangles of distinct points in both of their lists, each sorted by (distance, index).
///
/// # Errors
/// As [`filter`].
pub(crate) fn graph(points: &[[f64; 3]]) -> Result<Neighbors, Error> {
    Ok(joined(points, &filter(points)?.triangles))
}

fn joined(points: &[[f64; 3]], triangles: &[Triangle]) -> Neighbors {
    let mut both: Vec<(u32, f64, u32)> = Vec::new();
    for [a, b] in edges(triangles) {
        let square = distance2(points[a as usize], points[b as usize]);
        both.extend([(a, square, b), (b, square, a)]);
    }
    both.sort_unstable_by(|x, y| x.0.cmp(&y.0).then(x.1.total_cmp(&y.1)).then(x.2.cmp(&y.2)));
    let mut offsets = vec![0u64; points.len() + 1];
    both.iter().for_each(|edge| offsets[edge.0 as usize + 1] += 1);
    (0..points.len()).for_each(|i| offsets[i + 1] += offsets[i]);
    Neighbors { offsets, indices: both.into_iter().map(|edge| edge.2).collect() }
}
