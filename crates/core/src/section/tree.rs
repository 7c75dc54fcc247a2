//! A static k-d tree for the few thousand samples of one slab, in which densities may differ a hundredfold.

/// Points in `D` dimensions under a balanced tree; queries report indices into the slice it was built from.
pub(crate) struct Tree<'a, const D: usize> {
    points: &'a [[f64; D]],
    order: Vec<u32>,
    splits: Vec<(u8, f64)>,
}

const LEAF: usize = 8;

impl<'a, const D: usize> Tree<'a, D> {
    /// The tree of finite points. Ties fall to the lower index, so that the same points give the same tree.
    pub(crate) fn new(points: &'a [[f64; D]]) -> Self {
        let mut order: Vec<u32> = (0..points.len() as u32).collect();
        let mut splits = vec![(0u8, 0.0); points.len()];
        build(points, &mut order, &mut splits);
        Self { points, order, splits }
    }

    /// Appends to `found` every point within `radius` of `centre`, the border included, in tree order.
    pub(crate) fn within(&self, centre: [f64; D], radius: f64, found: &mut Vec<u32>) {
        found.clear();
        if !self.points.is_empty() {
            self.descend(0, self.order.len(), centre, radius, found);
        }
    }

    fn descend(&self, low: usize, high: usize, centre: [f64; D], radius: f64, found: &mut Vec<u32>) {
        if high - low <= LEAF {
            let near = |&i: &u32| distance2(self.points[i as usize], centre) <= radius * radius;
            found.extend(self.order[low..high].iter().copied().filter(near));
            return;
        }
        let middle = (low + high) / 2;
        let (axis, split) = self.splits[middle];
        let gap = centre[axis as usize] - split;
        if gap <= radius {
            self.descend(low, middle, centre, radius, found);
        }
        if gap >= -radius {
            self.descend(middle, high, centre, radius, found);
        }
    }

    /// Fills `best` with the `k` points nearest to `centre` as (squared distance, index), nearest first.
    pub(crate) fn nearest(&self, centre: [f64; D], k: usize, best: &mut Vec<(f64, u32)>) {
        best.clear();
        if k > 0 && !self.points.is_empty() {
            self.approach(0, self.order.len(), centre, k, best);
        }
    }

    fn approach(&self, low: usize, high: usize, centre: [f64; D], k: usize, best: &mut Vec<(f64, u32)>) {
        if high - low <= LEAF {
            for &i in &self.order[low..high] {
                let key = (distance2(self.points[i as usize], centre), i);
                if best.len() == k && key >= best[k - 1] {
                    continue;
                }
                best.truncate(k - 1);
                let at = best.partition_point(|b| *b < key);
                best.insert(at, key);
            }
            return;
        }
        let middle = (low + high) / 2;
        let (axis, split) = self.splits[middle];
        let gap = centre[axis as usize] - split;
        let halves = [(low, middle), (middle, high)];
        let (first, second) = if gap < 0.0 { (halves[0], halves[1]) } else { (halves[1], halves[0]) };
        self.approach(first.0, first.1, centre, k, best);
        if best.len() < k || gap * gap <= best[best.len() - 1].0 {
            self.approach(second.0, second.1, centre, k, best);
        }
    }
}

fn build<const D: usize>(points: &[[f64; D]], order: &mut [u32], splits: &mut [(u8, f64)]) {
    if order.len() <= LEAF {
        return;
    }
    let axis = widest(points, order);
    let middle = order.len() / 2;
    order.select_nth_unstable_by(middle, |&a, &b| {
        points[a as usize][axis].total_cmp(&points[b as usize][axis]).then(a.cmp(&b))
    });
    splits[middle] = (axis as u8, points[order[middle] as usize][axis]);
    let (left, right) = order.split_at_mut(middle);
    let (left_splits, right_splits) = splits.split_at_mut(middle);
    build(points, left, left_splits);
    // The slot of a split is the first of its right half, where no later split falls.
    build(points, right, right_splits);
}

fn widest<const D: usize>(points: &[[f64; D]], order: &[u32]) -> usize {
    let extent = |axis: usize| {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for &i in order {
            low = low.min(points[i as usize][axis]);
            high = high.max(points[i as usize][axis]);
        }
        high - low
    };
    let mut best = 0;
    for axis in 1..D {
        if extent(axis) > extent(best) {
            best = axis;
        }
    }
    best
}

fn distance2<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    let mut sum = 0.0;
    for axis in 0..D {
        sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearest_and_within_agree_with_a_plain_search() {
        let points: Vec<[f64; 2]> =
            (0..500u64).map(|i| [(i * 7919 % 101) as f64, (i * 104_729 % 97) as f64]).collect();
        let tree = Tree::new(&points);
        let (mut best, mut found) = (Vec::new(), Vec::new());
        for &centre in points.iter().step_by(17) {
            let mut all: Vec<(f64, u32)> =
                points.iter().enumerate().map(|(i, &p)| (distance2(p, centre), i as u32)).collect();
            all.sort_by(|a, b| a.partial_cmp(b).unwrap());
            tree.nearest(centre, 9, &mut best);
            assert_eq!(best, all[..9]);
            tree.within(centre, 11.0, &mut found);
            found.sort_unstable();
            let mut near: Vec<u32> = all.iter().filter(|a| a.0 <= 121.0).map(|a| a.1).collect();
            near.sort_unstable();
            assert_eq!(found, near);
        }
    }
}
