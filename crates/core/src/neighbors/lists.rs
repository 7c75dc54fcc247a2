//! The nearest candidates of sixteen queries while a search runs.
//!
//! A candidate is one number: the upper 32 bits of its squared distance as f64, then its index. Such keys sort by distance,
//! truncated to 21 bits of mantissa, and then by index; ties due to the truncation are settled in full precision at the end of
//! the search.

use super::leaf::WIDTH;

/// The key of an empty place: greater than every finite distance, but itself a finite f64.
pub(super) const NONE: u64 = f64::MAX.to_bits();

/// Sorted keys of the `K` nearest candidates of each of sixteen queries.
#[repr(C, align(64))]
pub(super) struct Lists<const K: usize> {
    pub(super) keys: [[u64; K]; WIDTH],
    /// The greatest squared distance at which a candidate can be among the `k` nearest of each query.
    pub(super) bounds: [f64; WIDTH],
    /// The number of neighbours wanted, less than `K`; the remaining places hold ties with the last.
    pub(super) k: usize,
}

impl<const K: usize> Lists<K> {
    /// Lists for `k < K` neighbours.
    pub(super) fn new(k: usize) -> Self {
        Lists { keys: [[NONE; K]; WIDTH], bounds: [-1.0; WIDTH], k }
    }

    /// Empties the lists for `queries` queries and candidates no farther than `bound`; the lists after them take none.
    pub(super) fn clear(&mut self, queries: usize, bound: f64) {
        self.keys.as_flattened_mut().fill(NONE);
        self.bounds = std::array::from_fn(|q| if q < queries { bound } else { -1.0 });
    }

    /// Restarts the lists that have found fewer than `k` candidates, without a bound; the others take no more. Returns whether
    /// there are any.
    pub(super) fn retry(&mut self) -> bool {
        let mut any = false;
        for (list, bound) in self.keys.iter_mut().zip(&mut self.bounds) {
            let short = *bound >= 0.0 && list[self.k - 1] == NONE;
            *bound = if short { f64::MAX } else { -1.0 };
            if short {
                list.fill(NONE);
            }
            any |= short;
        }
        any
    }

    /// The greatest squared distance of a `k`-th neighbour.
    pub(super) fn reach(&self) -> f64 {
        let last = self.keys.iter().map(|list| list[self.k - 1]).filter(|&key| key != NONE);
        greatest(last.max().unwrap_or(NONE))
    }

    /// Lowers the bound of a query to its `k`-th candidate.
    #[inline(always)]
    pub(super) fn tighten(&mut self, q: usize) {
        let last = greatest(self.keys[q][self.k - 1]);
        self.bounds[q] = if last < self.bounds[q] { last } else { self.bounds[q] };
    }

    /// The greatest bound of all queries.
    pub(super) fn bound(&self) -> f64 {
        self.bounds.iter().fold(-1.0, |a, &b| if b > a { b } else { a })
    }
}

/// The key of a candidate.
#[inline(always)]
pub(super) fn key(distance2: f64, id: u32) -> u64 {
    distance2.to_bits() & 0xffff_ffff_0000_0000 | u64::from(id)
}

/// The greatest squared distance with this key.
#[inline(always)]
pub(super) fn greatest(key: u64) -> f64 {
    f64::from_bits(key | 0xffff_ffff)
}

/// Whether the truncated distances of two keys are equal.
#[inline(always)]
pub(super) fn tied(a: u64, b: u64) -> bool {
    a >> 32 == b >> 32
}
