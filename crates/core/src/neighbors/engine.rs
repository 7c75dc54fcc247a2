//! The search for the neighbours of all points: one walk through the hierarchy serves the sixteen points of a leaf.
//!
//! The walk goes from the leaf up to the root and, beside that path, down into the near boxes, nearest first. Boxes are
//! compared with the box of the leaf. The box of a leaf that is reached is compared with each of the sixteen points, and its
//! points only with those of them for which it is near enough. All distances are f64: this halves the vector width, but
//! distances take a small part of the time (insertion into the lists takes the greatest), and no search has to be repeated
//! because of rounding.

use super::found::Found;
use super::index::Index;
use super::kernel::{Kernel, Portable};
use super::leaf::{Aabb, BLOCK, Leaf, Node, WIDTH};
use super::lists::{Lists, NONE, tied};
#[cfg(target_arch = "x86_64")]
use super::simd::{Avx2, Avx512};

/// Bound at which a search starts, as a multiple of the greatest squared distance that the previous search, next to it, found.
/// It halves the number of candidates that enter a list only to leave it again; the few queries that find too few neighbours
/// within it start again.
const GUESS: f64 = 1.3;

/// Which vector instructions a search may use. The results have the same bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Instructions {
    /// The widest vectors of this machine.
    #[default]
    Detected,
    /// At most 256-bit vectors (AVX2), if the machine has them.
    Narrow,
    /// The vectors for which the program was compiled.
    Baseline,
}

/// Finds the `k` nearest neighbours of every point of an index.
pub(super) struct Engine<'a> {
    index: &'a Index,
    positions: &'a [[f64; 3]],
    k: usize,
    loops: Loops,
}

/// The chosen inner loops.
#[derive(Clone, Copy)]
enum Loops {
    #[cfg(target_arch = "x86_64")]
    Avx512(Avx512),
    #[cfg(target_arch = "x86_64")]
    Avx2(Avx2),
    Portable,
}

impl Loops {
    fn choose(instructions: Instructions) -> Loops {
        #[cfg(target_arch = "x86_64")]
        {
            let wide = Avx512::detect().filter(|_| instructions == Instructions::Detected);
            let narrow = Avx2::detect().filter(|_| instructions != Instructions::Baseline);
            if let Some(loops) = wide.map(Loops::Avx512).or(narrow.map(Loops::Avx2)) {
                return loops;
            }
        }
        let _ = instructions;
        Loops::Portable
    }
}

impl<'a> Engine<'a> {
    /// For `0 < k < N` neighbours of the `N` `positions` that `index` was built from.
    pub(super) fn new(
        index: &'a Index,
        positions: &'a [[f64; 3]],
        k: usize,
        instructions: Instructions,
    ) -> Self {
        Engine { index, positions, k, loops: Loops::choose(instructions) }
    }

    /// The lists of the points of block `b`, `k` entries each, in the order of the points.
    pub(super) fn block(&self, b: usize, lists: &mut [u32]) {
        let leaves = b * BLOCK / WIDTH..(b * BLOCK + lists.len() / self.k).div_ceil(WIDTH);
        self.search(leaves, lists, |_, _, id| id as usize - b * BLOCK);
    }

    /// The lists of the points of some leaves, `k` entries each, leaf by leaf and place by place; those of empty places
    /// are left as they are.
    pub(super) fn leaves(&self, leaves: &[u32], lists: &mut [u32]) {
        self.search(leaves.iter().map(|&l| l as usize), lists, |slot, place, _| slot * WIDTH + place);
    }

    /// Searches leaf by leaf; `row` gives the place of a list from the number of the leaf in the search, the place in the leaf
    /// and the point.
    fn search(
        &self,
        leaves: impl Iterator<Item = usize>,
        lists: &mut [u32],
        row: impl Fn(usize, usize, u32) -> usize,
    ) {
        match self.loops {
            #[cfg(target_arch = "x86_64")]
            Loops::Avx512(kernel) => self.search_by(kernel, leaves, lists, row),
            #[cfg(target_arch = "x86_64")]
            Loops::Avx2(kernel) => self.search_by(kernel, leaves, lists, row),
            Loops::Portable => self.search_by(Portable, leaves, lists, row),
        }
    }

    /// Searches with lists that have at least one place beyond `k`.
    fn search_by<K: Kernel>(
        &self,
        kernel: K,
        leaves: impl Iterator<Item = usize>,
        lists: &mut [u32],
        row: impl Fn(usize, usize, u32) -> usize,
    ) {
        match self.k {
            0..8 => self.search_held::<K, 8>(kernel, leaves, lists, row),
            8..16 => self.search_held::<K, 16>(kernel, leaves, lists, row),
            16..24 => self.search_held::<K, 24>(kernel, leaves, lists, row),
            24..32 => self.search_held::<K, 32>(kernel, leaves, lists, row),
            _ => self.search_alone(leaves, lists, row),
        }
    }

    fn search_held<K: Kernel, const N: usize>(
        &self,
        kernel: K,
        leaves: impl Iterator<Item = usize>,
        lists: &mut [u32],
        row: impl Fn(usize, usize, u32) -> usize,
    ) {
        let mut held = Lists::new(self.k);
        let mut guess = f64::MAX;
        for (slot, leaf) in leaves.enumerate() {
            let mut search = Search::<K, N>::new(self, kernel, leaf, &mut held, guess);
            search.run(leaf);
            if search.lists.retry() {
                search.run(leaf);
            }
            guess = f64::MAX.min(GUESS * search.lists.reach());
            for (q, id) in search.queries.ids().enumerate() {
                let start = row(slot, q, id) * self.k;
                search.settle(q, &mut lists[start..start + self.k]);
            }
        }
    }

    /// Searches point by point, for more neighbours than the inner loops hold.
    fn search_alone(
        &self,
        leaves: impl Iterator<Item = usize>,
        lists: &mut [u32],
        row: impl Fn(usize, usize, u32) -> usize,
    ) {
        for (slot, leaf) in leaves.enumerate() {
            for (q, id) in self.index.leaves[leaf].ids().enumerate() {
                let start = row(slot, q, id) * self.k;
                self.alone(id, &mut lists[start..start + self.k]);
            }
        }
    }

    /// The neighbours of one point by a search of its own.
    fn alone(&self, i: u32, list: &mut [u32]) {
        let mut found = Vec::new();
        self.index.nearest(self.positions[i as usize], list.len() + 1, &mut found);
        let others = found.iter().filter(|n| n.index != i);
        list.iter_mut().zip(others).for_each(|(slot, n)| *slot = n.index);
    }
}

/// The search of one leaf's neighbours.
struct Search<'a, K: Kernel, const N: usize> {
    engine: &'a Engine<'a>,
    index: &'a Index,
    kernel: K,
    queries: &'a Leaf,
    around: Aabb,
    lists: &'a mut Lists<N>,
    /// Squared distance beyond which no query needs a candidate.
    bound: f64,
}

impl<'a, K: Kernel, const N: usize> Search<'a, K, N> {
    fn new(engine: &'a Engine<'a>, kernel: K, leaf: usize, lists: &'a mut Lists<N>, guess: f64) -> Self {
        let index = engine.index;
        let queries = &index.leaves[leaf];
        let points = queries.id.iter().take_while(|&&id| id != u32::MAX).count();
        let around = index.levels[0][leaf / WIDTH].child(leaf % WIDTH);
        lists.clear(points, guess);
        Search { engine, index, kernel, queries, around, lists, bound: guess }
    }

    /// Walks from the leaf up to the root, and into everything near beside the path.
    fn run(&mut self, leaf: usize) {
        self.bound = self.lists.bound();
        self.scan(leaf, &self.around.clone());
        let mut child = leaf;
        for level in 0..self.index.levels.len() {
            self.descend(level, child / WIDTH, child % WIDTH);
            child /= WIDTH;
        }
    }

    /// Descends into the children of a node, near ones first, except the one at `skip`.
    fn descend(&mut self, level: usize, node: usize, skip: usize) {
        let Some(boxes) = self.index.levels[level].get(node) else { return };
        let distances = self.kernel.boxes(&self.around, boxes);
        let mut near = [0u64; WIDTH];
        let mut count = 0;
        for (c, d) in distances.iter().enumerate() {
            near[count] = d.to_bits() & !0xf | c as u64;
            count += usize::from(*d <= self.bound && c != skip);
        }
        let near = &mut near[..count];
        near.sort_unstable();
        for &mut entry in near {
            if f64::from_bits(entry & !0xf) > self.bound {
                break;
            }
            let c = (entry & 0xf) as usize;
            if level == 0 {
                self.scan(node * WIDTH + c, &boxes.child(c));
            } else {
                self.descend(level - 1, node * WIDTH + c, WIDTH);
            }
        }
    }

    fn scan(&mut self, leaf: usize, around: &Aabb) {
        let Some(points) = self.index.leaves.get(leaf) else { return };
        self.kernel.scan(self.queries, points, around, self.lists);
        self.bound = self.lists.bound();
    }

    /// Writes the neighbours of query `q` in their final order. Where truncated keys are equal, the full distances decide; if
    /// such a run continues beyond the keys held, the query is searched again by itself.
    fn settle(&self, q: usize, out: &mut [u32]) {
        let keys = &self.lists.keys[q];
        let k = out.len();
        let last = keys[k - 1];
        if tied(last, keys[N - 1]) || last == NONE {
            return self.engine.alone(self.queries.id[q], out);
        }
        out.iter_mut().zip(keys).for_each(|(slot, &key)| *slot = key as u32);
        if (0..k).any(|i| tied(keys[i], keys[i + 1])) {
            let held = keys.iter().take_while(|&&key| key >> 32 <= last >> 32);
            let mut found: Vec<Found> = held.map(|&key| self.found(q, key as u32)).collect();
            found.sort_unstable_by(Found::order);
            out.iter_mut().zip(&found).for_each(|(slot, f)| *slot = f.index);
        }
    }

    fn found(&self, q: usize, index: u32) -> Found {
        let at = self.queries.point(q);
        Found { distance2: crate::math::vec3::distance2(self.engine.positions[index as usize], at), index }
    }
}

impl Node {
    fn child(&self, c: usize) -> Aabb {
        Aabb { min: self.min.map(|m| m[c]), max: self.max.map(|m| m[c]) }
    }
}
