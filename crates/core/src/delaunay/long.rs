//! The filter of long edges: "we first computed the average edge length at each data point. Then we removed all triangles which
//! contained an edge that was three times longer than the average edge length of the two incident vertices."

use super::triangle::{Triangle, edges, edges_of};
use crate::math::vec3::distance;
use crate::neighbors::Neighbors;

/// Multiple of the average length above which an edge is too long.
const LONG: f64 = 3.0;

/// The triangles whose edges are all of usual length where they lie.
pub(super) fn without_long(points: &[[f64; 3]], triangles: &[Triangle]) -> Vec<Triangle> {
    let average = averages(points, triangles);
    let long = |&[a, b]: &[u32; 2]| {
        let usual = 0.5 * (average[a as usize] + average[b as usize]);
        distance(points[a as usize], points[b as usize]) > LONG * usual
    };
    triangles.iter().copied().filter(|t| !edges_of(t).iter().any(long)).collect()
}

/// `(N)` average length of the edges at each point; zero without any.
fn averages(points: &[[f64; 3]], triangles: &[Triangle]) -> Vec<f64> {
    let mut sums = vec![(0.0, 0.0); points.len()];
    for [a, b] in edges(triangles) {
        let length = distance(points[a as usize], points[b as usize]);
        for end in [a, b] {
            let (sum, count) = &mut sums[end as usize];
            (*sum, *count) = (*sum + length, *count + 1.0);
        }
    }
    sums.into_iter().map(|(sum, count)| if count > 0.0 { sum / count } else { 0.0 }).collect()
}

/// The triangles at each point, as indices in their order.
pub(super) fn at_points(points: usize, triangles: &[Triangle]) -> Neighbors {
    let mut offsets = vec![0u64; points + 1];
    triangles.iter().flatten().for_each(|&corner| offsets[corner as usize + 1] += 1);
    (0..points).for_each(|i| offsets[i + 1] += offsets[i]);
    let mut next = offsets.clone();
    let mut indices = vec![0; 3 * triangles.len()];
    for (t, triangle) in triangles.iter().enumerate() {
        for &corner in triangle {
            indices[next[corner as usize] as usize] = t as u32;
            next[corner as usize] += 1;
        }
    }
    Neighbors { offsets, indices }
}
