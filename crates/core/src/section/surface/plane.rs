//! The tangent plane at one point: a least-squares plane through its nearest neighbours, then a robust one anchored
//! at the point itself, so that two sheets of a thin plate keep apart.

use super::spread::{self, Spread};
use crate::math::vec3;

/// Neighbours a plane is fitted to at first, the point itself included.
pub(crate) const FIRST_NEIGHBORS: usize = 12;
/// Most points of a plane under noise, the point itself included.
pub(crate) const MOST_NEIGHBORS: usize = 24;

/// A tangent plane with the residual of its fit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TangentPlane {
    /// Weighted mean of the neighbours.
    pub centre: [f64; 3],
    /// Unit normal of either sign; zero where the neighbours lie on a line and show no plane.
    pub normal: [f64; 3],
    /// Root mean square distance of the neighbours from the plane.
    pub residual: f64,
    /// Mean distance to the six nearest points.
    pub spacing: f64,
}

impl TangentPlane {
    /// No plane: it is never adopted.
    pub(crate) const NONE: TangentPlane =
        TangentPlane { centre: [0.0; 3], normal: [0.0; 3], residual: f64::INFINITY, spacing: 0.0 };
}

/// A point and its neighbours, nearest first, as vectors from the point.
pub(crate) struct Around {
    own: [f64; 3],
    /// `[0]` is the point itself; those from `count` on are zero and have no weight.
    offsets: [[f64; 3]; MOST_NEIGHBORS],
    weights: [f64; MOST_NEIGHBORS],
    count: usize,
}

impl Around {
    /// The point `i` and at most `MOST_NEIGHBORS - 1` of its neighbours `ids`, nearest first.
    pub(crate) fn gather(points: &[[f64; 3]], i: u32, ids: &[u32]) -> Self {
        let own = points[i as usize];
        let mut offsets = [[0.0; 3]; MOST_NEIGHBORS];
        for (slot, &j) in offsets[1..].iter_mut().zip(ids) {
            *slot = vec3::sub(points[j as usize], own);
        }
        Self { own, offsets, weights: [1.0; MOST_NEIGHBORS], count: 1 + ids.len().min(MOST_NEIGHBORS - 1) }
    }

    /// The least-squares plane of the nearest.
    pub(crate) fn plain(&self) -> TangentPlane {
        let six = &self.offsets[1..self.count.min(7)];
        let sum: f64 = six.iter().map(|d| vec3::dot(*d, *d).sqrt()).sum();
        self.plane(self.count.min(FIRST_NEIGHBORS), sum / six.len().max(1) as f64).0
    }

    /// Two rounds of a fit in which a neighbour counts the less, the farther it is from the plane through the point.
    pub(crate) fn anchored(&mut self, first: &TangentPlane, noise: f64) -> TangentPlane {
        let reach = (3.0 * noise + 0.3) * first.spacing;
        if reach <= 0.0 {
            return *first;
        }
        let mut best = *first;
        for round in 0..2 {
            let all_used = round > 0 || self.count <= FIRST_NEIGHBORS;
            if all_used && best.residual <= (0.8 * noise + 0.02) * first.spacing {
                // No neighbour lies off the plane: weights change nothing but the time it takes.
                break;
            }
            self.weigh(best.normal, 1.0 / reach);
            let (plane, weight) = self.plane(self.count, first.spacing);
            if weight < 5.0 {
                break;
            }
            best = plane;
        }
        best
    }

    /// Weights like a Gaussian's by distance from the plane through the point, zero beyond two reaches.
    fn weigh(&mut self, normal: [f64; 3], per_reach: f64) {
        for (weight, d) in self.weights.iter_mut().zip(&self.offsets).take(self.count) {
            let off = vec3::dot(*d, normal) * per_reach;
            let near = (1.0 - 0.25 * off * off).max(0.0);
            *weight = (near * near) * (near * near);
        }
    }

    /// The weighted plane of the first `count` points, and the sum of their weights.
    fn plane(&self, count: usize, spacing: f64) -> (TangentPlane, f64) {
        let weighted = self.offsets[..count].iter().copied().zip(self.weights[..count].iter().copied());
        let Spread { weight, centre, tensor } = Spread::of(weighted, [0.0; 3]);
        let (least, normal) = spread::normal(&tensor);
        // Three parameters of a plane are taken from the points.
        let freedom = (weight - 3.0).max(1.0) / weight.max(1.0);
        let residual = (least.max(0.0) / freedom).sqrt();
        (TangentPlane { centre: vec3::add(self.own, centre), normal, residual, spacing }, weight)
    }
}
