//! Sorting points into canonical order: Morton order as deep as their coordinates differ, equal points by index.
//!
//! A first pass deals the points of each chunk of the input into buckets by the upper bits of their codes, a second
//! gathers each bucket and sorts it in cache. Both run in parallel, and nothing depends on how.

use rayon::prelude::*;

use super::morton::{BITS, DEPTHS, Entry, Grid, LEVELS, Levels, finite, index};

/// Bits of a code that choose its bucket: four levels of cells.
const BUCKET_BITS: u32 = 12;
const BUCKETS: usize = 1 << BUCKET_BITS;
/// Below this many entries a sort by all threads does not pay.
const LARGE: usize = 1 << 15;

/// Entries of the finite points in canonical order, and at which levels neighbours in it part.
pub(super) fn canonical(grid: &Grid, points: &[[f64; 3]]) -> (Vec<Entry>, Levels) {
    let dealt = deal(grid, points);
    let mut sizes = [0; BUCKETS];
    for chunk in &dealt {
        (0..BUCKETS).for_each(|b| sizes[b] += chunk.bucket(b).len());
    }
    let mut entries = vec![0; sizes.iter().sum()];
    let mut buckets = Vec::with_capacity(BUCKETS);
    let mut rest = entries.as_mut_slice();
    for (b, &size) in sizes.iter().enumerate().filter(|(_, size)| **size > 0) {
        let (bucket, after) = rest.split_at_mut(size);
        buckets.push((b, bucket));
        rest = after;
    }
    let mut levels = [0; LEVELS + 1];
    for pair in buckets.windows(2) {
        let shared = (pair[0].0 ^ pair[1].0).leading_zeros() - (usize::BITS - BUCKET_BITS);
        levels[shared as usize / 3] += 1;
    }
    let sort = |levels: Levels, (b, bucket): (usize, &mut [Entry])| {
        let mut place = 0;
        for chunk in &dealt {
            let part = chunk.bucket(b);
            bucket[place..place + part.len()].copy_from_slice(part);
            place += part.len();
        }
        sort(bucket);
        refine(grid, bucket, points, 0, levels)
    };
    let add = |a: Levels, b: Levels| std::array::from_fn(|l| a[l] + b[l]);
    let none = || [0; LEVELS + 1];
    let within = buckets.into_par_iter().with_min_len(16).fold(none, sort).reduce(none, add);
    (entries, add(levels, within))
}

/// The entries of a chunk of the input, bucket by bucket.
struct Dealt {
    entries: Vec<Entry>,
    /// `(BUCKETS + 1)` where buckets begin.
    starts: Vec<u32>,
}

impl Dealt {
    fn bucket(&self, b: usize) -> &[Entry] {
        &self.entries[self.starts[b] as usize..self.starts[b + 1] as usize]
    }
}

/// Deals the finite points of each chunk into buckets. Chunks fit into a near cache, but for huge clouds, where
/// their number is limited.
fn deal(grid: &Grid, points: &[[f64; 3]]) -> Vec<Dealt> {
    let size = (points.len() / 1024).max(1 << 14);
    let chunk = |c: usize| {
        let range = c * size..points.len().min((c + 1) * size);
        let kept = range.filter(|&i| finite(&points[i]));
        let entries: Vec<Entry> = kept.map(|i| grid.entry(points, i as u32, 0)).collect();
        Dealt::new(&entries)
    };
    (0..points.len().div_ceil(size)).into_par_iter().map(chunk).collect()
}

impl Dealt {
    fn new(entries: &[Entry]) -> Dealt {
        let bucket = |e: Entry| (e >> (32 + 3 * BITS - BUCKET_BITS)) as usize;
        let mut starts = vec![0; BUCKETS + 1];
        entries.iter().for_each(|&e| starts[bucket(e) + 1] += 1);
        (0..BUCKETS).for_each(|b| starts[b + 1] += starts[b]);
        let mut next = starts.clone();
        let mut dealt = vec![0; entries.len()];
        for &e in entries {
            let slot = &mut next[bucket(e)];
            dealt[*slot as usize] = e;
            *slot += 1;
        }
        Dealt { entries: dealt, starts }
    }
}

fn sort(entries: &mut [Entry]) {
    if entries.len() < LARGE {
        entries.sort_unstable();
    } else {
        entries.par_sort_unstable();
    }
}

/// Orders the runs of equal codes in `entries`, sorted at `depth`, by what lies deeper; adds to the levels at which
/// neighbours part.
fn refine(grid: &Grid, entries: &mut [Entry], points: &[[f64; 3]], depth: u32, mut levels: Levels) -> Levels {
    let mut start = 0;
    while start < entries.len() {
        let code = entries[start] >> 32;
        let run = entries[start..].iter().take_while(|&&e| e >> 32 == code).count();
        if run > 1 {
            levels = order_run(grid, &mut entries[start..start + run], points, depth, levels);
        }
        start += run;
        if let Some(next) = entries.get(start) {
            let shared = ((code ^ next >> 32) as u64).leading_zeros() - 1;
            levels[(BITS * depth + shared / 3) as usize] += 1;
        }
    }
    levels
}

/// Orders entries of one cell.
fn order_run(grid: &Grid, run: &mut [Entry], points: &[[f64; 3]], depth: u32, mut levels: Levels) -> Levels {
    let place = |&e: &Entry| grid.relative(points[index(e) as usize]);
    let first = place(&run[0]);
    if run.iter().all(|e| place(e) == first) {
        levels[LEVELS] += run.len() - 1; // duplicates, by index already
        levels
    } else if depth + 1 < DEPTHS {
        run.par_iter_mut().with_min_len(LARGE).for_each(|e| *e = grid.entry(points, index(*e), depth + 1));
        sort(run);
        refine(grid, run, points, depth + 1, levels)
    } else {
        let order = |p: [f64; 3], q: [f64; 3]| (0..3).map(|a| p[a].total_cmp(&q[a])).find(|o| o.is_ne());
        run.sort_unstable_by(|a, b| order(place(a), place(b)).unwrap_or_else(|| index(*a).cmp(&index(*b))));
        levels[LEVELS] += run.len() - 1;
        levels
    }
}
