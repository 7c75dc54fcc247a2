//! The neighbours of the points of some leaves, leaf by leaf, and an even sample of a cloud.

use crate::neighbors::{Index, WIDTH, nearest_leaves};

/// Points of an even sample.
const SAMPLE: usize = 8_000;

/// The points of some leaves with their lists of `width` neighbours, leaf by leaf as [`nearest_leaves`] gives them.
pub(crate) fn with_neighbors<'a>(
    index: &'a Index,
    leaves: &'a [u32],
    lists: &'a [u32],
    width: usize,
) -> impl Iterator<Item = impl Iterator<Item = (u32, &'a [u32])>> {
    lists
        .chunks(WIDTH * width)
        .zip(leaves)
        .map(move |(lists, &leaf)| index.leaves[leaf as usize].ids().zip(lists.chunks(width)))
}

/// Visits about [`SAMPLE`] points, in evenly spread leaves, each with `neighbors` others, nearest first.
pub(crate) fn sampled<T: Send>(
    points: &[[f64; 3]],
    index: &Index,
    neighbors: usize,
    visit: impl Fn(u32, &[u32]) -> Option<T> + Sync,
) -> Vec<T> {
    let step = index.leaves.len().div_ceil(SAMPLE / WIDTH).max(1);
    let leaves: Vec<u32> = (0..index.leaves.len() as u32).step_by(step).collect();
    let width = neighbors.min(points.len().saturating_sub(1));
    let found = nearest_leaves(index, points, neighbors, &leaves, |first, lists| {
        let all = with_neighbors(index, &leaves[first..], lists, width).flatten();
        all.filter_map(|(i, near)| visit(i, near)).collect::<Vec<T>>()
    });
    found.into_iter().flatten().collect()
}
