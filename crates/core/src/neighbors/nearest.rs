//! The nearest neighbours of all points of a cloud, stored or passed on block by block.

use super::engine::{Engine, Instructions};
use super::index::Index;
use super::leaf::{BLOCK, WIDTH};
use super::rows::Neighbors;
use crate::parallel;

/// For each point its `min(k, N - 1)` nearest other points, sorted by (distance, index): exact in f64 squared
/// distance, whatever the number of threads.
///
/// `positions` are `(N, 3)` f64, finite. Any order gives the same neighbours; canonical order (see
/// [`Frame::localise`](crate::frame::Frame::localise)) gives them fast.
pub fn all_nearest(positions: &[[f64; 3]], k: usize) -> Neighbors {
    all_nearest_with(positions, k, Instructions::Detected)
}

/// As [`all_nearest`], by chosen instructions.
pub fn all_nearest_with(positions: &[[f64; 3]], k: usize, instructions: Instructions) -> Neighbors {
    let k = at_most(k, positions);
    let mut indices = vec![0; positions.len() * k];
    if k > 0 {
        let index = Index::build(positions);
        let engine = Engine::new(&index, positions, k, instructions);
        parallel::each(indices.chunks_mut(BLOCK * k), |b, lists| engine.block(b, lists));
    }
    let offsets = parallel::map(positions.len() + 1, parallel::QUICK, |i| (i * k) as u64);
    Neighbors { offsets, indices }
}

/// Visits the lists of [`all_nearest`] block by block, in parallel, without storing them all: `visit(first, lists)` gets the
/// index of a block's first point and `min(k, N - 1)` neighbours for each of its points, one list after the other. Its results
/// are returned in the order of the blocks. If `k` or `N - 1` is zero, nothing is visited.
pub fn nearest_blocks<R: Send>(
    positions: &[[f64; 3]],
    k: usize,
    visit: impl Fn(usize, &[u32]) -> R + Sync,
) -> Vec<R> {
    if at_most(k, positions) == 0 {
        return Vec::new();
    }
    nearest_blocks_in(&Index::build(positions), positions, k, visit)
}

/// Visits the lists of the points of some leaves of an index, as [`nearest_blocks`] does for blocks: `visit(first, lists)` gets
/// the position in `leaves` of the first leaf of a batch, and for each leaf [`WIDTH`] lists of `min(k, N - 1)` neighbours, of
/// which those of empty places are arbitrary.
pub(crate) fn nearest_leaves<R: Send>(
    index: &Index,
    positions: &[[f64; 3]],
    k: usize,
    leaves: &[u32],
    visit: impl Fn(usize, &[u32]) -> R + Sync,
) -> Vec<R> {
    let Some((engine, k)) = engine(index, positions, k) else { return Vec::new() };
    parallel::map_with(leaves.len().div_ceil(BATCH), parallel::TASK, |lists: &mut Vec<u32>, b| {
        let leaves = &leaves[b * BATCH..leaves.len().min((b + 1) * BATCH)];
        lists.resize(leaves.len() * WIDTH * k, 0);
        engine.leaves(leaves, lists);
        visit(b * BATCH, lists)
    })
}

/// Number of leaves that are searched one after the other.
const BATCH: usize = 16;

/// A search for `min(k, N - 1)` neighbours, and that number; `None` if it is zero.
fn engine<'a>(index: &'a Index, positions: &'a [[f64; 3]], k: usize) -> Option<(Engine<'a>, usize)> {
    let k = at_most(k, positions);
    (k > 0).then(|| (Engine::new(index, positions, k, Instructions::Detected), k))
}

/// `min(k, N - 1)`: no point has more neighbours than there are other points.
fn at_most(k: usize, positions: &[[f64; 3]]) -> usize {
    k.min(positions.len().saturating_sub(1))
}

/// As [`nearest_blocks`], with an existing index of the same positions.
fn nearest_blocks_in<R: Send>(
    index: &Index,
    positions: &[[f64; 3]],
    k: usize,
    visit: impl Fn(usize, &[u32]) -> R + Sync,
) -> Vec<R> {
    let Some((engine, k)) = engine(index, positions, k) else { return Vec::new() };
    parallel::map_with(positions.len().div_ceil(BLOCK), parallel::TASK, |lists: &mut Vec<u32>, b| {
        let first = b * BLOCK;
        lists.resize(BLOCK.min(positions.len() - first) * k, 0);
        engine.block(b, lists);
        visit(first, lists)
    })
}
