//! Projected distance and normal of every point at several scales, the seven of the paper (Tran 2013, sections 2.1, 2.2).
//!
//! At the scale `k` (the paper's sigma) the neighbourhood is the point and its `k` nearest neighbours. The lists are sorted by
//! distance, so that the sums of a scale are those of the scale before and of four more points: all seven scales cost one
//! search, and no list is stored.

use crate::math::least_axis::least_axis;
use crate::math::tensor::{add_product, centred};
use crate::math::vec3::{dot, norm, sub};
use crate::neighbors::nearest_blocks;

/// The neighbourhood sizes of the paper.
pub const SCALES: [usize; 7] = [8, 12, 16, 20, 24, 28, 32];

/// One point at one scale, local frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AtScale {
    /// Projected distance `|(p - centroid) . n|` (equation 1).
    pub distance: f64,
    /// Distance of the farthest neighbour.
    pub radius: f64,
    /// Surface variation: the least eigenvalue over the sum of all (Pauly 2003, section 2), 0 to 1/3.
    pub variation: f64,
    /// The normal of Hoppe 1992: the axis of least variance, without orientation.
    pub normal: [f64; 3],
}

/// Calls `visit(i, nearest, scales)` for every point, in parallel; the results are in the order of the points.
///
/// `nearest` are the up to 32 nearest neighbours by distance. In a cloud of fewer points the greater scales take all points.
/// `points` are `(N, 3)`; with fewer than two nothing is visited.
pub fn at_every_scale<R: Send>(
    points: &[[f64; 3]],
    visit: impl Fn(usize, &[u32], &[AtScale; 7]) -> R + Sync,
) -> Vec<R> {
    let most = SCALES[SCALES.len() - 1].min(points.len().saturating_sub(1));
    let block = |first: usize, lists: &[u32]| -> Vec<R> {
        let own = lists.chunks_exact(most).enumerate();
        own.map(|(j, nearest)| visit(first + j, nearest, &scales(points, first + j, nearest))).collect()
    };
    nearest_blocks(points, most, block).into_iter().flatten().collect()
}

/// All scales of point `own` from its neighbours by distance.
fn scales(points: &[[f64; 3]], own: usize, nearest: &[u32]) -> [AtScale; 7] {
    let (mut sum, mut products, mut taken, mut radius) = ([0.0; 3], [0.0; 6], 0, 0.0);
    SCALES.map(|scale| {
        let upto = scale.min(nearest.len());
        for &j in &nearest[taken..upto] {
            let d = sub(points[j as usize], points[own]);
            (0..3).for_each(|c| sum[c] += d[c]);
            add_product(&mut products, d, 1.0);
            radius = norm(d);
        }
        taken = upto;
        let (centre, tensor) = centred(sum, products, (upto + 1) as f64);
        let trace = tensor[0] + tensor[3] + tensor[5];
        let (least, normal) = least_axis(&tensor);
        let variation = if trace > 0.0 { least / trace } else { 0.0 };
        let distance = dot(centre, normal).abs(); // equation 1
        AtScale { distance, radius, variation, normal }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::tensor::ellipsoid;
    use crate::neighbors::all_nearest;
    use crate::{Frame, shapes};

    #[test]
    fn every_scale_is_what_its_neighbourhood_alone_gives() {
        let points = Frame::localise(&shapes::cube_386().cloud).unwrap().positions;
        let nearest = all_nearest(&points, 32);
        let seen = at_every_scale(&points, |i, list, scales| (i, list.to_vec(), *scales));
        for (i, (own, list, scales)) in seen.iter().enumerate() {
            assert_eq!((*own, list.as_slice()), (i, nearest.of(i)));
            for (k, at) in SCALES.iter().zip(scales) {
                let whole = ellipsoid(&points, i, &list[..*k]);
                let values = whole.axes.values;
                assert!((at.variation - values[0].max(0.0) / values.iter().sum::<f64>()).abs() < 1e-12);
                if values[1] - values[0] > 1e-6 {
                    let distance = dot(whole.centre, whole.axes.vectors[0]).abs();
                    assert!((at.distance - distance).abs() < 1e-9, "{i} {k} {at:?} {distance}");
                }
            }
        }
    }

    #[test]
    fn four_points_have_the_same_neighbourhood_at_every_scale() {
        let points = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let seen = at_every_scale(&points, |_, list, scales| (list.len(), *scales));
        assert_eq!(seen.len(), 4);
        for (count, scales) in seen {
            assert_eq!(count, 3);
            assert!(scales.iter().all(|s| s.distance == scales[0].distance && s.distance.is_finite()));
        }
    }
}
