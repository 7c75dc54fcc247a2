//! A small kd-tree for truth distances, scores and the spacing of a sampled cloud.
//!
//! The pipeline has its own search. This one is short, exact and independent of the pipeline, so that a check never rests on
//! the code that it checks.

use crate::math::vec3::distance2;

/// An implicit balanced kd-tree: the median of each range is its root.
#[derive(Clone, Debug)]
pub(crate) struct Tree {
    points: Vec<[f64; 3]>,
    /// Index into the points as they were given.
    ids: Vec<u32>,
    axes: Vec<u8>,
}

impl Tree {
    /// A tree over finite `(N, 3)` points.
    pub(crate) fn new(given: &[[f64; 3]]) -> Self {
        let mut ids: Vec<u32> = (0..given.len() as u32).collect();
        let mut axes = vec![0; given.len()];
        split(given, &mut ids, &mut axes);
        Self { points: ids.iter().map(|&i| given[i as usize]).collect(), ids, axes }
    }

    /// Index and squared distance of the nearest point; `None` for a tree without points.
    pub(crate) fn nearest(&self, p: [f64; 3]) -> Option<(u32, f64)> {
        self.k_nearest(p, 1).first().map(|&(d, i)| (i, d))
    }

    /// The `k` nearest points as (squared distance, index), nearest first; a point at `p` itself counts.
    pub(crate) fn k_nearest(&self, p: [f64; 3], k: usize) -> Vec<(f64, u32)> {
        let mut best = Vec::with_capacity(k + 1);
        if k > 0 {
            self.visit(p, 0, self.points.len(), k, &mut best);
        }
        best
    }

    fn visit(&self, p: [f64; 3], low: usize, high: usize, k: usize, best: &mut Vec<(f64, u32)>) {
        if low >= high {
            return;
        }
        let mid = (low + high) / 2;
        let (at, axis) = (self.points[mid], usize::from(self.axes[mid]));
        let item = (distance2(p, at), self.ids[mid]);
        let place = best.partition_point(|b| *b < item);
        if place < k {
            best.insert(place, item);
            best.truncate(k);
        }
        let offset = p[axis] - at[axis];
        let (near, far) =
            if offset < 0.0 { ((low, mid), (mid + 1, high)) } else { ((mid + 1, high), (low, mid)) };
        self.visit(p, near.0, near.1, k, best);
        if best.len() < k || best.last().is_none_or(|b| offset * offset <= b.0) {
            self.visit(p, far.0, far.1, k, best);
        }
    }
}

fn split(points: &[[f64; 3]], ids: &mut [u32], axes: &mut [u8]) {
    if ids.len() < 2 {
        return;
    }
    let axis = widest(points, ids);
    let mid = ids.len() / 2;
    let key = |i: u32| points[i as usize][axis];
    ids.select_nth_unstable_by(mid, |&a, &b| key(a).total_cmp(&key(b)).then(a.cmp(&b)));
    axes[mid] = axis as u8;
    let (left, right) = ids.split_at_mut(mid);
    let (left_axes, right_axes) = axes.split_at_mut(mid);
    split(points, left, left_axes);
    split(points, &mut right[1..], &mut right_axes[1..]);
}

fn widest(points: &[[f64; 3]], ids: &[u32]) -> usize {
    let mut bounds = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    for &i in ids {
        for (axis, &x) in points[i as usize].iter().enumerate() {
            bounds[0][axis] = bounds[0][axis].min(x);
            bounds[1][axis] = bounds[1][axis].max(x);
        }
    }
    let extent = |a: usize| bounds[1][a] - bounds[0][a];
    (0..3).fold(0, |best, a| if extent(a) > extent(best) { a } else { best })
}

/// Mean over the points of the mean distance to the 6 nearest others; 0 for fewer than two points.
pub(crate) fn mean_spacing(points: &[[f64; 3]]) -> f64 {
    let k = 6.min(points.len().saturating_sub(1));
    if k == 0 {
        return 0.0;
    }
    let tree = Tree::new(points);
    let total: f64 = points
        .iter()
        .map(|&p| tree.k_nearest(p, k + 1).iter().map(|&(d, _)| d.sqrt()).sum::<f64>() / k as f64)
        .sum();
    total / points.len() as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::Rng;

    fn cloud(n: usize) -> Vec<[f64; 3]> {
        let mut rng = Rng::new(3);
        (0..n).map(|_| [rng.uniform(), rng.uniform(), (rng.uniform() * 4.0).floor()]).collect()
    }

    #[test]
    fn k_nearest_are_those_of_a_full_search() {
        let points = cloud(700);
        let tree = Tree::new(&points);
        for &p in points.iter().step_by(7).chain(&[[3.0, -1.0, 9.0]]) {
            let mut all: Vec<(f64, u32)> = (0..).zip(&points).map(|(i, &q)| (distance2(p, q), i)).collect();
            all.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            assert_eq!(tree.k_nearest(p, 9), all[..9]);
        }
    }

    #[test]
    fn spacing_of_a_line_is_the_mean_of_its_six_distances() {
        let line: Vec<_> = (0..1000).map(|i| [f64::from(i), 0.0, 0.0]).collect();
        assert!((mean_spacing(&line) - 2.0).abs() < 0.02);
        assert_eq!(mean_spacing(&line[..1]), 0.0);
        assert!(Tree::new(&[]).nearest([0.0; 3]).is_none());
    }
}
