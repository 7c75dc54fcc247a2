//! Sorting points into canonical order: Morton order as deep as their coordinates differ, equal points by index.
//!
//! A first pass deals the points of each chunk of the input into buckets by the upper bits of their codes, a second
//! gathers each bucket and sorts it in cache. Points travel with their codes, so that nothing is fetched from all
//! over the memory. Both passes run in parallel, and nothing depends on how.

use rayon::prelude::*;

use super::morton::{BITS, DEPTHS, Grid, LEVELS, Levels, finite};

/// A Morton code (64 bits), the index of its point in the input (32) and its place in the bucket (32), in one
/// number that sorts by them.
type Entry = u128;

/// Bits of a code that choose its bucket: four levels of cells.
const BUCKET_BITS: u32 = 12;
const BUCKETS: usize = 1 << BUCKET_BITS;
/// Bits in which the codes of one bucket differ.
const CODE_BITS: u32 = 3 * BITS - BUCKET_BITS;
/// Most entries whose places fit into a word beside those bits.
const SMALL: usize = 1 << (64 - CODE_BITS);
/// Below this many entries a sort by all threads does not pay.
const LARGE: usize = 1 << 15;

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
    let sort = |mut bucket: Bucket, (b, relative, source): (usize, &mut [[f64; 3]], &mut [u32])| {
        bucket.gather(&dealt, b);
        bucket.sort(grid);
        bucket.emit(relative, source);
        bucket
    };
    let add = |a: Levels, b: Levels| std::array::from_fn(|l| a[l] + b[l]);
    let parts = buckets.into_par_iter().with_min_len(16).fold(Bucket::default, sort).map(|b| b.levels);
    let within = parts.reduce(|| [0; LEVELS + 1], add);
    Ordered { relative, source, levels: add(levels, within) }
}

/// A chunk of the input, bucket by bucket.
struct Dealt {
    entries: Vec<Entry>,
    relative: Vec<[f64; 3]>,
    /// `(BUCKETS + 1)` where buckets begin.
    starts: Vec<u32>,
}

/// Deals the finite points of each chunk into buckets. Chunks fit into a near cache, but for huge clouds, where
/// their number is limited.
fn deal(grid: &Grid, points: &[[f64; 3]]) -> Vec<Dealt> {
    let size = (points.len() / 1024).max(1 << 14);
    let chunk = |(c, points): (usize, &[[f64; 3]])| Dealt::new(grid, points, (c * size) as u32);
    points.par_chunks(size).enumerate().map(chunk).collect()
}

impl Dealt {
    fn new(grid: &Grid, points: &[[f64; 3]], first: u32) -> Dealt {
        let bucket = |e: Entry| (e >> (64 + 3 * BITS - BUCKET_BITS)) as usize;
        let kept = points.iter().zip(first..).filter(|(p, _)| finite(p));
        let coded: Vec<Entry> = kept.map(|(&p, i)| entry(grid.code(grid.relative(p), 0), i, 0)).collect();
        let mut starts = vec![0; BUCKETS + 1];
        coded.iter().for_each(|&e| starts[bucket(e) + 1] += 1);
        (0..BUCKETS).for_each(|b| starts[b + 1] += starts[b]);
        let mut next = starts.clone();
        let (mut entries, mut relative) = (vec![0; coded.len()], vec![[0.0; 3]; coded.len()]);
        for e in coded {
            let place = &mut next[bucket(e)];
            entries[*place as usize] = e;
            relative[*place as usize] = grid.relative(points[(index(e) - first) as usize]);
            *place += 1;
        }
        Dealt { entries, relative, starts }
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
    entries: Vec<Entry>,
    words: Vec<u64>,
    unsorted: Vec<Entry>,
    relative: Vec<[f64; 3]>,
    levels: Levels,
}

impl Default for Bucket {
    fn default() -> Self {
        let [entries, unsorted] = [Vec::new(), Vec::new()];
        Bucket { entries, words: Vec::new(), unsorted, relative: Vec::new(), levels: [0; LEVELS + 1] }
    }
}

impl Bucket {
    fn gather(&mut self, dealt: &[Dealt], b: usize) {
        self.entries.clear();
        self.relative.clear();
        for chunk in dealt {
            let places = self.relative.len() as Entry..;
            self.entries.extend(chunk.entries[chunk.range(b)].iter().zip(places).map(|(e, place)| e | place));
            self.relative.extend_from_slice(&chunk.relative[chunk.range(b)]);
        }
    }

    fn sort(&mut self, grid: &Grid) {
        if self.entries.len() <= SMALL {
            self.sort_small();
        } else {
            sort(&mut self.entries);
        }
        refine(grid, &mut self.entries, &self.relative, 0, &mut self.levels);
    }

    /// Sorts by what the codes of one bucket differ in, and by place, which for equal codes is the order of the indices:
    /// both go into one word.
    fn sort_small(&mut self) {
        let word = |e: &Entry| code(*e) << (64 - CODE_BITS) | u64::from(*e as u32);
        self.words.clear();
        self.words.extend(self.entries.iter().map(word));
        self.words.sort_unstable();
        self.unsorted.clone_from(&self.entries);
        let places = self.words.iter().map(|w| *w as usize & (SMALL - 1));
        self.entries.iter_mut().zip(places).for_each(|(entry, place)| *entry = self.unsorted[place]);
    }

    fn emit(&self, relative: &mut [[f64; 3]], source: &mut [u32]) {
        for ((&e, relative), source) in self.entries.iter().zip(relative).zip(source) {
            *relative = self.relative[e as u32 as usize];
            *source = index(e);
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
        run.par_iter_mut().with_min_len(LARGE).for_each(deeper);
        sort(run);
        refine(grid, run, relative, depth + 1, levels);
    } else {
        let order = |p: [f64; 3], q: [f64; 3]| (0..3).map(|a| p[a].total_cmp(&q[a])).find(|o| o.is_ne());
        run.sort_unstable_by(|a, b| order(at(a), at(b)).unwrap_or_else(|| index(*a).cmp(&index(*b))));
        levels[LEVELS] += run.len() - 1;
    }
}
