//! Sorting points into canonical order: Morton order as deep as their coordinates differ, equal points by index.
//!
//! A first pass deals the points of each chunk of the input into buckets by the upper bits of their codes, a second
//! gathers each bucket and sorts it in cache. Points travel between them, so that nothing is fetched from all
//! over the memory, but not their codes: to work them out twice costs less than to write them down. Both passes run in
//! parallel, and nothing depends on how.

use rayon::prelude::*;

use super::morton::{BITS, BUCKET_LEVELS, DEPTHS, Grid, LEVELS, Levels, finite};
use crate::parallel;

/// A Morton code (64 bits), the index of its point in the input (32) and its place in the bucket (32), in one
/// number that sorts by them.
type Entry = u128;

/// Bits of a code that choose its bucket.
const BUCKET_BITS: u32 = 3 * BUCKET_LEVELS;
const BUCKETS: usize = 1 << BUCKET_BITS;
/// The bucket of a point that is not finite.
const NOWHERE: u16 = u16::MAX;
/// Bits in which the codes of one bucket differ.
const CODE_BITS: u32 = 3 * BITS - BUCKET_BITS;
/// Most entries whose places fit into a word beside those bits.
const SMALL: usize = 1 << (64 - CODE_BITS);
/// Below this many entries a sort by all threads does not pay.
const LARGE: usize = 1 << 15;
/// Buckets that are sorted one after the other, in the same memory.
const TOGETHER: usize = 16;

/// The finite points in canonical order.
pub(super) struct Ordered {
    /// `(M, 3)` f64 from the least corner, in world lengths.
    pub(super) relative: Vec<[f64; 3]>,
    /// `(M)` indices in the input.
    pub(super) source: Vec<u32>,
    /// At which levels neighbours in the order part.
    pub(super) levels: Levels,
}

/// Sorts the finite ones of `points`.
pub(super) fn canonical(grid: &Grid, points: &[[f64; 3]]) -> Ordered {
    let dealt = deal(grid, points);
    let mut sizes = [0; BUCKETS];
    for chunk in &dealt {
        (0..BUCKETS).for_each(|b| sizes[b] += chunk.range(b).len());
    }
    let count = sizes.iter().sum();
    let (mut relative, mut source) = (vec![[0.0; 3]; count], vec![0; count]);
    let mut buckets = Vec::new();
    let mut rest = (relative.as_mut_slice(), source.as_mut_slice());
    for (b, &size) in sizes.iter().enumerate().filter(|(_, size)| **size > 0) {
        let (bucket, after) = (rest.0.split_at_mut(size), rest.1.split_at_mut(size));
        buckets.push((b, bucket.0, after.0));
        rest = (bucket.1, after.1);
    }
    let mut levels = [0; LEVELS + 1];
    for pair in buckets.windows(2) {
        let shared = (pair[0].0 ^ pair[1].0).leading_zeros() - (usize::BITS - BUCKET_BITS);
        levels[shared as usize / 3] += 1;
    }
    let within = parallel::each(buckets.chunks_mut(TOGETHER), |_, buckets| {
        let mut own = Bucket::default();
        for (b, relative, source) in buckets {
            own.gather(&dealt, *b);
            own.sort(grid);
            own.emit(relative, source);
        }
        own.levels
    });
    for part in within {
        (0..=LEVELS).for_each(|l| levels[l] += part[l]);
    }
    Ordered { relative, source, levels }
}

/// The finite points of a chunk of the input, bucket by bucket.
struct Dealt {
    /// `(M)` indices in the input, ascending in each bucket.
    source: Vec<u32>,
    /// `(M, 3)` f64 from the least corner.
    relative: Vec<[f64; 3]>,
    /// `(BUCKETS + 1)` where buckets begin.
    starts: Vec<u32>,
}

/// Deals the finite points of each chunk into buckets. Chunks fit into a near cache, but for huge clouds, where
/// their number is limited.
fn deal(grid: &Grid, points: &[[f64; 3]]) -> Vec<Dealt> {
    let size = (points.len() / 1024).max(1 << 14);
    let chunk = |c: usize, points: &[[f64; 3]]| Dealt::new(grid, points, (c * size) as u32);
    parallel::each(points.chunks(size), chunk)
}

impl Dealt {
    fn new(grid: &Grid, points: &[[f64; 3]], first: u32) -> Dealt {
        let bucket = |p: &[f64; 3]| match finite(p) {
            true => grid.bucket(grid.relative(*p)) as u16,
            false => NOWHERE,
        };
        let buckets: Vec<u16> = points.iter().map(bucket).collect();
        let kept = || (0u32..).zip(&buckets).filter(|(_, b)| **b != NOWHERE);
        let mut starts = vec![0; BUCKETS + 1];
        kept().for_each(|(_, &b)| starts[b as usize + 1] += 1);
        (0..BUCKETS).for_each(|b| starts[b + 1] += starts[b]);
        let (mut next, count) = (starts.clone(), starts[BUCKETS] as usize);
        let (mut source, mut relative) = (vec![0; count], vec![[0.0; 3]; count]);
        for (i, &b) in kept() {
            let place: &mut u32 = &mut next[b as usize];
            source[*place as usize] = first + i;
            relative[*place as usize] = grid.relative(points[i as usize]);
            *place += 1;
        }
        Dealt { source, relative, starts }
    }

    fn range(&self, b: usize) -> std::ops::Range<usize> {
        self.starts[b] as usize..self.starts[b + 1] as usize
    }
}

fn entry(code: u64, index: u32, place: u32) -> Entry {
    Entry::from(code) << 64 | Entry::from(index) << 32 | Entry::from(place)
}

fn code(entry: Entry) -> u64 {
    (entry >> 64) as u64
}

fn index(entry: Entry) -> u32 {
    (entry >> 32) as u32
}

/// The points of one bucket. Its memory serves one bucket after the other; the levels add up.
struct Bucket {
    /// `(M, 3)` f64 from the least corner, in the order of the input.
    relative: Vec<[f64; 3]>,
    /// `(M)` indices in the input.
    source: Vec<u32>,
    words: Vec<u64>,
    entries: Vec<Entry>,
    /// Where among the points those of the canonical order are.
    places: Vec<u32>,
    levels: Levels,
}

impl Default for Bucket {
    fn default() -> Self {
        let [source, places] = [Vec::new(), Vec::new()];
        let (relative, words, entries, levels) = (Vec::new(), Vec::new(), Vec::new(), [0; LEVELS + 1]);
        Bucket { relative, source, words, entries, places, levels }
    }
}

impl Bucket {
    fn gather(&mut self, dealt: &[Dealt], b: usize) {
        self.source.clear();
        self.relative.clear();
        for chunk in dealt {
            self.source.extend_from_slice(&chunk.source[chunk.range(b)]);
            self.relative.extend_from_slice(&chunk.relative[chunk.range(b)]);
        }
    }

    fn sort(&mut self, grid: &Grid) {
        self.places.clear();
        if self.relative.len() <= SMALL && self.sort_small(grid) {
            return;
        }
        let entries = self.relative.iter().zip(&self.source).zip(0..);
        self.entries.clear();
        self.entries.extend(entries.map(|((&p, &i), place)| entry(grid.code(p, 0), i, place)));
        sort(&mut self.entries);
        refine(grid, &mut self.entries, &self.relative, 0, &mut self.levels);
        self.places.extend(self.entries.iter().map(|&e| e as u32));
    }

    /// Sorts by what the codes of one bucket differ in, with the places in the same words. Gives whether all codes differ:
    /// else nothing is settled.
    fn sort_small(&mut self, grid: &Grid) -> bool {
        let word = |(&p, place): (&[f64; 3], u64)| grid.code(p, 0) << (64 - CODE_BITS) | place;
        self.words.clear();
        self.words.extend(self.relative.iter().zip(0..).map(word));
        self.words.sort_unstable();
        let shared = |pair: &[u64]| (pair[0] ^ pair[1]).leading_zeros();
        if self.words.windows(2).any(|pair| shared(pair) >= CODE_BITS) {
            return false;
        }
        for pair in self.words.windows(2) {
            self.levels[(BUCKET_BITS + shared(pair)) as usize / 3] += 1;
        }
        self.places.extend(self.words.iter().map(|w| (*w as usize & (SMALL - 1)) as u32));
        true
    }

    fn emit(&self, relative: &mut [[f64; 3]], source: &mut [u32]) {
        for ((&place, relative), source) in self.places.iter().zip(relative).zip(source) {
            *relative = self.relative[place as usize];
            *source = self.source[place as usize];
        }
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
fn refine(grid: &Grid, entries: &mut [Entry], relative: &[[f64; 3]], depth: u32, levels: &mut Levels) {
    let mut start = 0;
    while start < entries.len() {
        let here = code(entries[start]);
        let run = entries[start..].iter().take_while(|&&e| code(e) == here).count();
        if run > 1 {
            order_run(grid, &mut entries[start..start + run], relative, depth, levels);
        }
        start += run;
        if let Some(&next) = entries.get(start) {
            let shared = (here ^ code(next)).leading_zeros() - 1;
            levels[(BITS * depth + shared / 3) as usize] += 1;
        }
    }
}

/// Orders entries of one cell.
fn order_run(grid: &Grid, run: &mut [Entry], relative: &[[f64; 3]], depth: u32, levels: &mut Levels) {
    let at = |&e: &Entry| relative[e as u32 as usize];
    let first = at(&run[0]);
    if run.iter().all(|e| at(e) == first) {
        levels[LEVELS] += run.len() - 1; // duplicates, by index already
    } else if depth + 1 < DEPTHS {
        let deeper = |e: &mut Entry| *e = entry(grid.code(at(e), depth + 1), index(*e), *e as u32);
        parallel::each(run.chunks_mut(LARGE), |_, part| part.iter_mut().for_each(deeper));
        sort(run);
        refine(grid, run, relative, depth + 1, levels);
    } else {
        let order = |p: [f64; 3], q: [f64; 3]| (0..3).map(|a| p[a].total_cmp(&q[a])).find(|o| o.is_ne());
        run.sort_unstable_by(|a, b| order(at(a), at(b)).unwrap_or_else(|| index(*a).cmp(&index(*b))));
        levels[LEVELS] += run.len() - 1;
    }
}
