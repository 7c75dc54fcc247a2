//! Distances from points to a polyline.

use super::tree::Tree;
use super::vec2::{along, onto, sub};

/// A polyline with its vertices under a tree.
#[derive(Clone, Debug)]
pub(crate) struct Polyline {
    points: Vec<[f64; 2]>,
    closed: bool,
    tree: Tree<2>,
}

impl Polyline {
    /// The polyline through these points.
    pub(crate) fn new(points: Vec<[f64; 2]>, closed: bool) -> Self {
        let tree = Tree::new(&points);
        Self { points, closed, tree }
    }

    /// Its vertices.
    pub(crate) fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// The nearest point on the segments at the two nearest vertices, and its distance; `p` itself, infinitely far,
    /// if there is no vertex. Steps along a contour are about even, so that the nearest segment is among them.
    pub(crate) fn nearest(&self, p: [f64; 2]) -> ([f64; 2], f64) {
        let n = self.points.len();
        let mut best = (p, f64::INFINITY);
        for (_, i) in self.tree.nearest::<2>(p).into_iter().filter(|b| b.0.is_finite()) {
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
        assert_eq!(Polyline::new(corners.clone(), true).off(at), 0.5);
        assert!(Polyline::new(corners, false).off(at) > 1.0);
        assert_eq!(Polyline::new(vec![[1.0, 1.0]], false).off([1.0, 3.0]), 2.0);
        assert_eq!(Polyline::new(Vec::new(), true).off(at), f64::INFINITY);
    }
}
