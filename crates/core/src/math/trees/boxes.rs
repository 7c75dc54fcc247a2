//! A tree over boxes, for what is longer than a point: which of some lines or outlines come near a place.

/// Boxes under a balanced tree; queries report indices into the boxes it was built from.
#[derive(Clone, Debug)]
pub(crate) struct Boxes<const D: usize> {
    /// Boxes with their indices, each half of the tree side by side.
    items: Vec<(Extent<D>, u32)>,
    /// What holds all items of a half, at the middle of its range.
    halves: Vec<Extent<D>>,
}

/// Least and greatest coordinates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent<const D: usize> {
    min: [f64; D],
    max: [f64; D],
}

const LEAF: usize = 4;

impl<const D: usize> Extent<D> {
    /// Of finite points.
    pub(crate) fn of(points: impl IntoIterator<Item = [f64; D]>) -> Self {
        let none = Self { min: [f64::INFINITY; D], max: [f64::NEG_INFINITY; D] };
        points.into_iter().fold(none, |all, p| all.with(&Self { min: p, max: p }))
    }

    fn with(mut self, other: &Self) -> Self {
        for axis in 0..D {
            self.min[axis] = self.min[axis].min(other.min[axis]);
            self.max[axis] = self.max[axis].max(other.max[axis]);
        }
        self
    }

    /// Squared distance of a point, zero within.
    fn distance2(&self, p: [f64; D]) -> f64 {
        let outside = |axis: usize| (self.min[axis] - p[axis]).max(p[axis] - self.max[axis]).max(0.0);
        (0..D).map(|axis| outside(axis).powi(2)).sum()
    }

    fn centre(&self, axis: usize) -> f64 {
        0.5 * self.min[axis] + 0.5 * self.max[axis]
    }
}

impl<const D: usize> Boxes<D> {
    /// The tree of these boxes.
    pub(crate) fn new(extents: impl IntoIterator<Item = Extent<D>>) -> Self {
        let mut items: Vec<(Extent<D>, u32)> = extents.into_iter().zip(0..).collect();
        let mut halves: Vec<Extent<D>> = items.iter().map(|item| item.0).collect();
        build(&mut items, &mut halves);
        Self { items, halves }
    }

    /// Hands every box within the squared distance `bound` of `p` to `take`, near halves first; `take` returns the bound
    /// from then on. Let it be a little more than what is looked for: boxes are no more exact than their numbers.
    pub(crate) fn near(&self, p: [f64; D], mut bound: f64, mut take: impl FnMut(u32) -> f64) {
        self.descend((0, self.items.len()), p, &mut bound, &mut take);
    }

    fn descend(
        &self,
        (low, high): (usize, usize),
        p: [f64; D],
        bound: &mut f64,
        take: &mut impl FnMut(u32) -> f64,
    ) {
        if high - low <= LEAF {
            for (extent, i) in &self.items[low..high] {
                if extent.distance2(p) <= *bound {
                    *bound = take(*i);
                }
            }
            return;
        }
        let middle = (low + high) / 2;
        let far = |(low, high): (usize, usize)| self.halves[(low + high) / 2].distance2(p);
        let mut halves = [(low, middle), (middle, high)].map(|half| (far(half), half));
        if halves[1].0 < halves[0].0 {
            halves.swap(0, 1);
        }
        for (distance2, half) in halves {
            if distance2 <= *bound {
                self.descend(half, p, bound, take);
            }
        }
    }
}

/// Sorts the items into halves and gives the extent of them all.
fn build<const D: usize>(items: &mut [(Extent<D>, u32)], halves: &mut [Extent<D>]) {
    let Some(all) = items.iter().map(|item| item.0).reduce(|a, b| a.with(&b)) else { return };
    let middle = items.len() / 2;
    if items.len() > LEAF {
        let wide = |axis: usize| all.max[axis] - all.min[axis];
        let axis = (1..D).fold(0, |best, axis| if wide(axis) > wide(best) { axis } else { best });
        items.select_nth_unstable_by(middle, |a, b| {
            a.0.centre(axis).total_cmp(&b.0.centre(axis)).then(a.1.cmp(&b.1))
        });
        let (left, right) = items.split_at_mut(middle);
        let (left_halves, right_halves) = halves.split_at_mut(middle);
        build(left, left_halves);
        build(right, right_halves);
    }
    // Of two and more items the middle is the first of no half below.
    halves[middle] = all;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_boxes_within_reach_are_found_and_the_nearest_with_few_looked_at() {
        let corner = |i: u64| [(i * 7919 % 997) as f64, (i * 104_729 % 991) as f64];
        let size = |i: u64| [(i % 5) as f64, (i % 7) as f64];
        let extents: Vec<Extent<2>> = (0..2000)
            .map(|i| Extent::of([corner(i), [corner(i)[0] + size(i)[0], corner(i)[1] + size(i)[1]]]))
            .collect();
        for count in [0, 1, 2, 4, 5, 6, 9, 17, 2000] {
            let tree = Boxes::new(extents[..count].iter().copied());
            for p in (0..40).map(|k| corner(k * 31 + 5)) {
                let mut found = Vec::new();
                tree.near(p, 900.0, |i| {
                    found.push(i);
                    900.0
                });
                found.sort_unstable();
                let plain = (0..count as u32).filter(|&i| extents[i as usize].distance2(p) <= 900.0);
                assert_eq!(found, plain.collect::<Vec<_>>());
                let (mut best, mut looked_at) = (f64::INFINITY, 0);
                tree.near(p, best, |i| {
                    looked_at += 1;
                    best = best.min(extents[i as usize].distance2(p));
                    best
                });
                let least = extents[..count].iter().map(|e| e.distance2(p)).fold(f64::INFINITY, f64::min);
                assert_eq!(best, least);
                assert!(looked_at <= 60, "{looked_at} of {count}");
            }
        }
    }
}
