//! A static k-d tree for the few thousand samples of one slab, in which densities may differ a hundredfold.

use crate::math::points::distance2;

/// Points in `D` dimensions under a balanced tree; queries report indices into the slice it was built from.
#[derive(Clone, Debug)]
pub(crate) struct Tree<const D: usize> {
    /// Points with their indices, each half of the tree side by side.
    places: Vec<([f64; D], u32)>,
    splits: Vec<(u8, f64)>,
}

const LEAF: usize = 8;

impl<const D: usize> Tree<D> {
    /// The tree of finite points. Ties fall to the lower index, so that the same points give the same tree.
    pub(crate) fn new(points: &[[f64; D]]) -> Self {
        let mut places: Vec<([f64; D], u32)> = points.iter().copied().zip(0..).collect();
        let mut splits = vec![(0u8, 0.0); points.len()];
        build(&mut places, &mut splits);
        Self { places, splits }
    }

    /// Fills `found` with every point within `radius` of `centre`, the border included, in tree order.
    pub(crate) fn within(&self, centre: [f64; D], radius: f64, found: &mut Vec<u32>) {
        found.clear();
        self.descend(0, self.places.len(), centre, radius, found);
    }

    fn descend(&self, low: usize, high: usize, centre: [f64; D], radius: f64, found: &mut Vec<u32>) {
        if high - low <= LEAF {
            // Without a branch for each point, which no processor would guess.
            let (mut near, mut count) = ([0; LEAF], found.len());
            for &(point, i) in &self.places[low..high] {
                near[count - found.len()] = i;
                count += usize::from(distance2(point, centre) <= radius * radius);
            }
            // All of them, as to copy a number that is known takes no loop.
            found.extend_from_slice(&near);
            found.truncate(count);
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

    /// The `K` points within `radius` nearest to `centre` as (squared distance, index), nearest first; the index is `u32::MAX`
    /// where there are fewer.
    pub(crate) fn nearest<const K: usize>(&self, centre: [f64; D], radius: f64) -> [(f64, u32); K] {
        let mut best = [(radius * radius, u32::MAX); K];
        self.approach(0, self.places.len(), centre, &mut best);
        best
    }

    fn approach<const K: usize>(
        &self,
        low: usize,
        high: usize,
        centre: [f64; D],
        best: &mut [(f64, u32); K],
    ) {
        if high - low <= LEAF {
            for &(point, i) in &self.places[low..high] {
                let mut key = (distance2(point, centre), i);
                if key < best[K - 1] {
                    for slot in best.iter_mut() {
                        if key < *slot {
                            std::mem::swap(slot, &mut key);
                        }
                    }
                }
            }
            return;
        }
        let middle = (low + high) / 2;
        let (axis, split) = self.splits[middle];
        let gap = centre[axis as usize] - split;
        let halves = [(low, middle), (middle, high)];
        let (first, second) = if gap < 0.0 { (halves[0], halves[1]) } else { (halves[1], halves[0]) };
        self.approach(first.0, first.1, centre, best);
        if gap * gap <= best[K - 1].0 {
            self.approach(second.0, second.1, centre, best);
        }
    }
}

fn build<const D: usize>(places: &mut [([f64; D], u32)], splits: &mut [(u8, f64)]) {
    if places.len() <= LEAF {
        return;
    }
    let axis = widest(places);
    let middle = places.len() / 2;
    places.select_nth_unstable_by(middle, |a, b| a.0[axis].total_cmp(&b.0[axis]).then(a.1.cmp(&b.1)));
    splits[middle] = (axis as u8, places[middle].0[axis]);
    let (left, right) = places.split_at_mut(middle);
    let (left_splits, right_splits) = splits.split_at_mut(middle);
    build(left, left_splits);
    // The slot of a split is the first of its right half, where no later split falls.
    build(right, right_splits);
}

fn widest<const D: usize>(places: &[([f64; D], u32)]) -> usize {
    let (mut low, mut high) = ([f64::INFINITY; D], [f64::NEG_INFINITY; D]);
    for (point, _) in places {
        for axis in 0..D {
            low[axis] = low[axis].min(point[axis]);
            high[axis] = high[axis].max(point[axis]);
        }
    }
    let extent = |axis: usize| high[axis] - low[axis];
    (1..D).fold(0, |best, axis| if extent(axis) > extent(best) { axis } else { best })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearest_and_within_agree_with_a_plain_search() {
        let points: Vec<[f64; 2]> =
            (0..500u64).map(|i| [(i * 7919 % 101) as f64, (i * 104_729 % 97) as f64]).collect();
        let tree = Tree::new(&points);
        let mut found = Vec::new();
        for &centre in points.iter().step_by(17) {
            let mut all: Vec<(f64, u32)> =
                points.iter().enumerate().map(|(i, &p)| (distance2(p, centre), i as u32)).collect();
            all.sort_by(|a, b| a.partial_cmp(b).unwrap());
            assert_eq!(tree.nearest::<9>(centre, f64::INFINITY), all[..9]);
            tree.within(centre, 11.0, &mut found);
            found.sort_unstable();
            let mut near: Vec<u32> = all.iter().filter(|a| a.0 <= 121.0).map(|a| a.1).collect();
            near.sort_unstable();
            assert_eq!(found, near);
        }
        assert_eq!(Tree::<2>::new(&[]).nearest::<2>([0.0; 2], 3.0), [(9.0, u32::MAX); 2]);
    }
}
