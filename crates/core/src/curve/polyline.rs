//! Distances from points to a polyline.

use crate::math::trees::kd::Tree;
use crate::math::vec2::{along, distance, onto, sub};

/// Greatest number of pieces of one segment.
const MOST_PIECES: f64 = 10_000.0;

/// A polyline with a search tree over its vertices.
#[derive(Clone, Debug)]
pub(crate) struct Polyline {
    points: Vec<[f64; 2]>,
    closed: bool,
    tree: Tree<2>,
}

impl Polyline {
    /// The polyline through these points. Segments much longer than `step` are cut, so that the segments nearest to a point
    /// are those at its nearest vertices.
    pub(crate) fn new(points: &[[f64; 2]], closed: bool, step: f64) -> Self {
        let mut all = Vec::with_capacity(points.len());
        for (k, &from) in points.iter().enumerate() {
            let last = k + 1 == points.len();
            let to = if last && !closed { from } else { points[(k + 1) % points.len()] };
            let pieces = (distance(from, to) / (2.0 * step)).ceil().clamp(1.0, MOST_PIECES) as usize;
            all.extend((0..pieces).map(|j| along(from, sub(to, from), j as f64 / pieces as f64)));
        }
        let tree = Tree::new(&all);
        Self { points: all, closed, tree }
    }

    /// Its vertices, including those that cut long segments.
    pub(crate) fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// The nearest point on the segments at the two nearest vertices, and its distance; `p` itself, infinitely far,
    /// if there is no vertex.
    pub(crate) fn nearest(&self, p: [f64; 2]) -> ([f64; 2], f64) {
        self.among(p, f64::INFINITY)
    }

    /// Distance of a point that has a vertex within `reach`.
    pub(crate) fn off_within(&self, p: [f64; 2], reach: f64) -> Option<f64> {
        self.nearest_within(p, reach).map(|near| near.1)
    }

    /// The nearest point and its distance, for a point that has a vertex within `reach`.
    pub(crate) fn nearest_within(&self, p: [f64; 2], reach: f64) -> Option<([f64; 2], f64)> {
        Some(self.among(p, reach)).filter(|near| near.1.is_finite())
    }

    fn among(&self, p: [f64; 2], reach: f64) -> ([f64; 2], f64) {
        let n = self.points.len();
        let mut best = (p, f64::INFINITY);
        for (_, i) in self.tree.nearest::<2>(p, reach).into_iter().filter(|b| b.1 != u32::MAX) {
            let i = i as usize;
            let before = (i > 0 || self.closed).then_some((i + n - 1) % n);
            let after = (i + 1 < n || self.closed).then_some((i + 1) % n);
            // A single vertex is its own segment.
            for j in [before, after].into_iter().flatten().chain((n == 1).then_some(i)) {
                let (a, b) = (self.points[i], self.points[j]);
                let (share, off) = onto(a, b, p);
                if off < best.1 {
                    best = (along(a, sub(b, a), share), off);
                }
            }
        }
        best
    }

    /// Distance of a point.
    pub(crate) fn off(&self, p: [f64; 2]) -> f64 {
        self.nearest(p).1
    }

    /// Mean distance of points; 0 for none.
    pub(crate) fn mean_off(&self, points: impl Iterator<Item = [f64; 2]>) -> f64 {
        let (mut sum, mut count) = (0.0, 0.0);
        for p in points {
            sum += self.off(p);
            count += 1.0;
        }
        if count > 0.0 { sum / count } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_reach_the_closing_segment_only_of_closed_lines() {
        let corners = vec![[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
        let at = [-0.5, 1.0];
        assert_eq!(Polyline::new(&corners, true, 9.0).off(at), 0.5);
        assert!(Polyline::new(&corners, false, 9.0).off(at) > 1.0);
        assert_eq!(Polyline::new(&[[1.0, 1.0]], false, 1.0).off([1.0, 3.0]), 2.0);
        assert_eq!(Polyline::new(&[], true, 1.0).off(at), f64::INFINITY);
    }

    #[test]
    fn the_middle_of_a_long_segment_is_found_past_near_vertices_of_others() {
        let line = [[0.0, 0.0], [100.0, 0.0], [60.0, 5.0], [50.0, 5.0], [40.0, 5.0]];
        let near = Polyline::new(&line, false, 1.0);
        assert_eq!(near.off([50.0, 1.0]), 1.0);
        assert_eq!(
            (near.off_within([50.0, 2.0], 3.0), near.off_within([50.0, 40.0], 3.0)),
            (Some(2.0), None)
        );
    }
}
