//! The two inner loops of the search, in plain Rust that compilers vectorise.
#![allow(clippy::needless_range_loop)] // counted loops over several arrays: the form that is vectorised

use super::leaf::{Aabb, Leaf, Node, WIDTH};
use super::lists::{Lists, key};

/// The inner loops of the search of one leaf. All implementations give identical bits.
pub(super) trait Kernel: Copy + Send + Sync {
    /// Squared distances between a box and the children of a node, by [`Aabb::distances2`].
    fn boxes(self, query: &Aabb, node: &Node) -> [f64; WIDTH];

    /// Offers the points of `leaf`, which lie in `around`, to the queries; a point is no neighbour of itself.
    fn scan<const K: usize>(self, queries: &Leaf, leaf: &Leaf, around: &Aabb, lists: &mut Lists<K>);
}

/// Plain Rust for any machine.
#[derive(Clone, Copy)]
pub(super) struct Portable;

impl Kernel for Portable {
    fn boxes(self, query: &Aabb, node: &Node) -> [f64; WIDTH] {
        boxes(query, node)
    }

    fn scan<const K: usize>(self, queries: &Leaf, leaf: &Leaf, around: &Aabb, lists: &mut Lists<K>) {
        scan(queries, leaf, around, lists);
    }
}

#[inline(always)]
pub(super) fn boxes(query: &Aabb, node: &Node) -> [f64; WIDTH] {
    let gap = |a: usize, i: usize| positive(node.min[a][i] - query.max[a], query.min[a] - node.max[a][i]);
    let mut out = [0.0; WIDTH];
    for i in 0..WIDTH {
        let (dx, dy, dz) = (gap(0, i), gap(1, i), gap(2, i));
        out[i] = dx * dx + dy * dy + dz * dz;
    }
    out
}

/// The greater of two differences of which at most one is positive, or zero.
#[inline(always)]
fn positive(below: f64, above: f64) -> f64 {
    let gap = if below > above { below } else { above };
    if gap > 0.0 { gap } else { 0.0 }
}

#[inline(always)]
pub(super) fn scan<const K: usize>(queries: &Leaf, leaf: &Leaf, around: &Aabb, lists: &mut Lists<K>) {
    let gap =
        |a: usize, q: usize| positive(around.min[a] - queries.at[a][q], queries.at[a][q] - around.max[a]);
    let mut gaps = [0.0; WIDTH];
    for q in 0..WIDTH {
        let (dx, dy, dz) = (gap(0, q), gap(1, q), gap(2, q));
        gaps[q] = dx * dx + dy * dy + dz * dz;
    }
    for q in 0..WIDTH {
        if gaps[q] <= lists.bounds[q] {
            scan_one([0, 1, 2].map(|a| queries.at[a][q]), queries.id[q], q, leaf, lists);
        }
    }
}

#[inline(always)]
fn scan_one<const K: usize>(at: [f64; 3], id: u32, q: usize, leaf: &Leaf, lists: &mut Lists<K>) {
    let near = leaf.distances2(at);
    let bound = lists.bounds[q];
    let mut mask = 0u32;
    for i in 0..WIDTH {
        mask |= u32::from(near[i] <= bound && leaf.id[i] != id) << i;
    }
    if mask == 0 {
        return;
    }
    let list = &mut lists.keys[q];
    while mask != 0 {
        let i = mask.trailing_zeros() as usize % WIDTH;
        insert(list, key(near[i], leaf.id[i]));
        mask &= mask - 1;
    }
    lists.tighten(q);
}

/// Inserts into a sorted list and drops its last entry. Keys are compared as f64, for which every machine has a vector minimum
/// and maximum.
#[inline(always)]
fn insert<const K: usize>(list: &mut [u64; K], key: u64) {
    let key = f64::from_bits(key);
    let less = |a: f64, b: f64| if a < b { a } else { b };
    let more = |a: f64, b: f64| if a > b { a } else { b };
    let old = list.map(f64::from_bits);
    list[0] = less(old[0], key).to_bits();
    for i in 1..K {
        list[i] = less(old[i], more(old[i - 1], key)).to_bits();
    }
}
