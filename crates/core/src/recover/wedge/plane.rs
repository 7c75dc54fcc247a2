//! Two planes a crease point and their intersection (Gumhold 2001, section 4.1), with how well it is known.

use crate::math::eigen3::{Eigen3, eigen3};
use crate::math::tensor::{add_product, centred};
use crate::math::vec3::{add_scaled, dot, scale, sub};

/// Fewest points of a plane.
const FEWEST: usize = 5;

/// The least-squares plane of a group of points.
#[derive(Clone, Copy, Debug)]
pub(in crate::recover) struct Plane {
    /// The centroid of the group.
    pub centre: [f64; 3],
    /// Unit normal.
    pub normal: [f64; 3],
    axes: Eigen3,
    count: f64,
    /// Variance of a point off the plane.
    pub variance: f64,
}

impl Plane {
    /// Through the centroid, by the correlation matrix of the group relative to it; `None` for too few points. `floor` is the least
    /// standard deviation of a point.
    pub(in crate::recover) fn fit(group: impl Iterator<Item = [f64; 3]>, floor: f64) -> Option<Self> {
        let (mut origin, mut sum, mut products) = (None, [0.0; 3], [0.0; 6]);
        let mut count = 0.0;
        for p in group {
            let d = sub(p, *origin.get_or_insert(p));
            sum = add_scaled(sum, d, 1.0);
            add_product(&mut products, d, 1.0);
            count += 1.0;
        }
        if count < FEWEST as f64 {
            return None;
        }
        let (centre, tensor) = centred(sum, products, count);
        let axes = eigen3(&tensor);
        let variance = (axes.values[0].max(0.0) * count / (count - 3.0)).max(floor * floor);
        let flat = axes.values[1] > 0.0;
        flat.then(|| Plane {
            centre: add_scaled(origin.unwrap_or([0.0; 3]), centre, 1.0),
            normal: axes.vectors[0],
            axes,
            count,
            variance,
        })
    }

    /// Distance of a point from the plane, along the normal.
    pub(in crate::recover) fn offset(&self, p: [f64; 3]) -> f64 {
        dot(self.normal, sub(p, self.centre))
    }

    /// Variance of the plane's place at a point: that of the mean, and of the slopes by which it is led to there.
    pub(in crate::recover) fn variance_at(&self, p: [f64; 3]) -> f64 {
        let d = sub(p, self.centre);
        let led = |k: usize| dot(d, self.axes.vectors[k]).powi(2) / self.axes.values[k];
        self.variance / self.count * (1.0 + led(1) + led(2))
    }
}

/// A recovered crease point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::recover) struct Recovered {
    /// Local frame.
    pub at: [f64; 3],
    /// Covariance of the place.
    pub covariance: [[f64; 3]; 3],
    /// Angle by which the faces fold, radians.
    pub fold: f64,
    /// Mean height of the points nearest the edge over the two faces, outwards of the fold: well below zero where the edge is a round
    /// or a chamfer.
    pub filled: f64,
}

/// The point of two planes' intersection nearest to `p`, given as unit normals, the offsets of `p` from the planes and the variances of
/// these, and its covariance; `None` for planes that are parallel to within `least_sine`.
pub(in crate::recover) fn project(
    p: [f64; 3],
    normals: [[f64; 3]; 2],
    offsets: [f64; 2],
    variances: [f64; 2],
    least_sine: f64,
) -> Option<([f64; 3], [[f64; 3]; 3])> {
    let cosine = dot(normals[0], normals[1]);
    let determinant = 1.0 - cosine * cosine;
    if determinant < least_sine * least_sine {
        return None;
    }
    // A shift of a plane by one moves the intersection by these vectors.
    let moves = [0, 1].map(|k| scale(add_scaled(normals[k], normals[1 - k], -cosine), 1.0 / determinant));
    let at = add_scaled(add_scaled(p, moves[0], -offsets[0]), moves[1], -offsets[1]);
    let entry = |i: usize, j: usize| (0..2).map(|k| variances[k] * moves[k][i] * moves[k][j]).sum();
    Some((at, std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))))
}

/// The angle by which two faces fold that lead away from the edge in these unit directions.
pub(in crate::recover) fn fold(away: [[f64; 3]; 2]) -> f64 {
    (-dot(away[0], away[1])).clamp(-1.0, 1.0).acos()
}
