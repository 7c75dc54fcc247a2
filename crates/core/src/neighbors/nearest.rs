//! The nearest neighbours of all points of a cloud, stored or handed on block by block.

use rayon::prelude::*;

use super::engine::{Engine, Instructions};
use super::index::Index;
use super::leaf::{BLOCK, WIDTH};
use super::rows::Neighbors;

/// For each point its `min(k, N - 1)` nearest other points, sorted by (distance, index): exact in f64 squared
/// distance, whatever the number of threads.
///
/// `positions` are `(N, 3)` f64, finite. Any order gives the same neighbours; canonical order (see
/// [`Frame::localise`](crate::frame::Frame::localise)) gives them fast.
pub fn all_nearest(positions: &[[f64; 3]], k: usize) -> Neighbors {
    all_nearest_with(positions, k, Instructions::Detected)
}

/// [`all_nearest`] by chosen instructions.
pub fn all_nearest_with(positions: &[[f64; 3]], k: usize, instructions: Instructions) -> Neighbors {
    let k = at_most(k, positions);
    let mut indices = vec![0; positions.len() * k];
    if k > 0 {
        let index = Index::build(positions);
        let engine = Engine::new(&index, positions, k, instructions);
        let blocks = indices.par_chunks_mut(BLOCK * k).enumerate();
        blocks.for_each(|(b, lists)| engine.block(b, lists));
    }
    let offsets = (0..=positions.len() as u64).into_par_iter().map(|i| i * k as u64).collect();
    Neighbors { offsets, indices }
}

/// The lists of [`all_nearest`] block by block, in parallel, without storing them all: `visit(first, lists)` gets
/// the index of a block's first point and `min(k, N - 1)` neighbours for each of its points, one list after the
/// other. What it returns comes back in the order of the blocks. With `k` or `N - 1` zero there is nothing to
/// visit.
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

/// The lists of the points of some leaves of an index, as [`nearest_blocks`] gives those of blocks: `visit(first, lists)`
/// gets where in `leaves` a batch of them begins, and for each of its leaves [`WIDTH`] lists of `min(k, N - 1)` neighbours,
/// those of empty places filled with anything.
pub(crate) fn nearest_leaves<R: Send>(
    index: &Index,
    positions: &[[f64; 3]],
    k: usize,
    leaves: &[u32],
    visit: impl Fn(usize, &[u32]) -> R + Sync,
) -> Vec<R> {
    let Some((engine, k)) = engine(index, positions, k) else { return Vec::new() };
    let batch = |lists: &mut Vec<u32>, (b, leaves): (usize, &[u32])| {
        lists.resize(leaves.len() * WIDTH * k, 0);
        engine.leaves(leaves, lists);
        visit(b * BATCH, lists)
    };
    leaves.par_chunks(BATCH).enumerate().map_init(Vec::new, batch).collect()
}

/// Leaves that are searched one after the other.
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

/// [`nearest_blocks`] with an index of the same positions that is there already.
fn nearest_blocks_in<R: Send>(
    index: &Index,
    positions: &[[f64; 3]],
    k: usize,
    visit: impl Fn(usize, &[u32]) -> R + Sync,
) -> Vec<R> {
    let Some((engine, k)) = engine(index, positions, k) else { return Vec::new() };
    let block = |lists: &mut Vec<u32>, b: usize| {
        let first = b * BLOCK;
        lists.resize(BLOCK.min(positions.len() - first) * k, 0);
        engine.block(b, lists);
        visit(first, lists)
    };
    (0..positions.len().div_ceil(BLOCK)).into_par_iter().map_init(Vec::new, block).collect()
}
