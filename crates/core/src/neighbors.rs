//! Nearest neighbours of every point, as flat lists.

pub mod delaunay_ring;
mod engine;
mod index;
mod kernel;
mod lists;
pub mod riemannian;
#[cfg(target_arch = "x86_64")]
mod simd;
mod split;

use rayon::prelude::*;

use engine::Engine;
pub use index::Index;
pub(crate) use index::{Leaf, WIDTH};

/// One list of point indices for each point, in compressed rows.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Neighbors {
    /// `(N + 1)` where each list begins in `indices`; the last is the length of all.
    pub offsets: Vec<u64>,
    /// All lists, one after the other.
    pub indices: Vec<u32>,
}

impl Neighbors {
    /// The list of point `i`.
    ///
    /// # Panics
    /// If there is no such point.
    #[inline]
    pub fn of(&self, i: usize) -> &[u32] {
        &self.indices[self.offsets[i] as usize..self.offsets[i + 1] as usize]
    }

    /// The number of points.
    pub fn len(&self) -> usize {
        self.offsets.len().saturating_sub(1)
    }

    /// Whether there is no point.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// Which vector instructions a search may use. The results have the same bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Instructions {
    /// The widest that this machine has.
    #[default]
    Detected,
    /// At most 256-bit vectors (AVX2), where the machine has them.
    Narrow,
    /// Those that the program was compiled for.
    Baseline,
}

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
    let k = k.min(positions.len().saturating_sub(1));
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

/// Points in a block of [`nearest_blocks`]; the last block of a cloud may have fewer.
pub const BLOCK: usize = 1024;

/// The lists of [`all_nearest`] block by block, in parallel, without storing them all: `visit(first, lists)` gets
/// the index of a block's first point and `min(k, N - 1)` neighbours for each of its points, one list after the
/// other. What it returns comes back in the order of the blocks. With `k` or `N - 1` zero there is nothing to
/// visit.
pub fn nearest_blocks<R: Send>(
    positions: &[[f64; 3]],
    k: usize,
    visit: impl Fn(usize, &[u32]) -> R + Sync,
) -> Vec<R> {
    if k.min(positions.len().saturating_sub(1)) == 0 {
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
    let k = k.min(positions.len().saturating_sub(1));
    if k == 0 {
        return Vec::new();
    }
    let engine = Engine::new(index, positions, k, Instructions::Detected);
    let batch = |lists: &mut Vec<u32>, (b, leaves): (usize, &[u32])| {
        lists.resize(leaves.len() * WIDTH * k, 0);
        engine.leaves(leaves, lists);
        visit(b * BATCH, lists)
    };
    leaves.par_chunks(BATCH).enumerate().map_init(Vec::new, batch).collect()
}

/// Leaves that are searched one after the other.
const BATCH: usize = 16;

/// [`nearest_blocks`] with an index of the same positions that is there already.
pub(crate) fn nearest_blocks_in<R: Send>(
    index: &Index,
    positions: &[[f64; 3]],
    k: usize,
    visit: impl Fn(usize, &[u32]) -> R + Sync,
) -> Vec<R> {
    let k = k.min(positions.len().saturating_sub(1));
    if k == 0 {
        return Vec::new();
    }
    let engine = Engine::new(index, positions, k, Instructions::Detected);
    let block = |lists: &mut Vec<u32>, b: usize| {
        let first = b * BLOCK;
        lists.resize(BLOCK.min(positions.len() - first) * k, 0);
        engine.block(b, lists);
        visit(first, lists)
    };
    (0..positions.len().div_ceil(BLOCK)).into_par_iter().map_init(Vec::new, block).collect()
}

/// A point found by a search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// Squared distance from the query.
    pub distance2: f64,
    /// Index of the point.
    pub index: u32,
}

impl Found {
    /// By distance, then by index.
    #[inline]
    pub(crate) fn order(&self, other: &Found) -> std::cmp::Ordering {
        self.distance2.total_cmp(&other.distance2).then(self.index.cmp(&other.index))
    }
}

#[cfg(test)]
mod tests;
