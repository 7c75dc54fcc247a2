//! The filter of long edges: "we first computed the average edge length at each data point. Then we removed all triangles which
//! contained an edge that was three times longer than the average edge length of the two incident vertices."
//!
//! One departure: the usual length at a point is the median of its edges, not the average. The umbrellas close holes and join
//! sheets by edges at the rims, and there these very edges make the average so long that they would stay.

use super::triangle::{Triangle, edges_of};
use crate::math::vec3::distance;
use crate::neighbors::Neighbors;

/// Multiple of the usual length above which an edge is too long.
const LONG: f64 = 3.0;

/// The triangles whose edges are all of usual length where they lie.
pub(super) fn without_long(points: &[[f64; 3]], triangles: &[Triangle]) -> Vec<Triangle> {
    let usual = usual_lengths(points, triangles);
    let long = |&[a, b]: &[u32; 2]| {
        let usual = 0.5 * (usual[a as usize] + usual[b as usize]);
        distance(points[a as usize], points[b as usize]) > LONG * usual
    };
    triangles.iter().copied().filter(|t| !edges_of(t).iter().any(long)).collect()
}

/// `(N)` median length of the edges at each point; where there are none, the median of all points with some.
pub(crate) fn usual_lengths(points: &[[f64; 3]], triangles: &[Triangle]) -> Vec<f64> {
    let mut at: Vec<Vec<f64>> = vec![Vec::new(); points.len()];
    for &[a, b, c] in triangles {
        // An edge of two triangles counts twice at both of its ends.
        for [i, j] in [[a, b], [a, c], [b, c]].map(|edge| edge.map(|end| end as usize)) {
            let length = distance(points[i], points[j]);
            at[i].push(length);
            at[j].push(length);
        }
    }
    let mut known: Vec<f64> = at.into_iter().map(|lengths| median(lengths).unwrap_or(f64::NAN)).collect();
    let usual = median(known.iter().copied().filter(|length| !length.is_nan()).collect()).unwrap_or(0.0);
    known.iter_mut().filter(|length| length.is_nan()).for_each(|length| *length = usual);
    known
}

/// The middle one of some values.
fn median(mut values: Vec<f64>) -> Option<f64> {
    let middle = values.len() / 2;
    (!values.is_empty()).then(|| *values.select_nth_unstable_by(middle, f64::total_cmp).1)
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
