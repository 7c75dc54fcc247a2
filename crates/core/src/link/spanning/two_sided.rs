//! The shortest path between two vertices of a graph that grows, sought from both ends (I. Pohl, "Bi-directional search", Machine
//! Intelligence 6, 1971): two balls of half the radius hold far fewer vertices than one.
//!
//! Of several paths of one length it is the one that Dijkstra's search from the first end finds, ties by index: that search is
//! led to its end over all that can lie on a shortest path.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Sums of one path from both ends differ by no more than this share.
pub(super) const ROUNDING: f64 = 1e-9;

/// A graph with lengths, and the two searches.
pub(super) struct TwoSided {
    /// `(V)` neighbours of each vertex with the lengths of the edges.
    edges: Vec<Vec<(u32, f64)>>,
    sides: [Side; 2],
    /// Stamp of the present search.
    now: u32,
}

/// One search: what it has reached, and what it goes on from.
struct Side {
    marks: Vec<Mark>,
    /// Bits of a length, which is not negative, and the vertex reached over it.
    heap: BinaryHeap<Reverse<(u64, u32)>>,
}

/// How a vertex was reached, valid for the search of its stamp.
#[derive(Clone, Copy, Default)]
struct Mark {
    stamp: u32,
    from: u32,
    length: f64,
}

impl TwoSided {
    /// A graph without edges.
    pub(super) fn new(vertices: usize) -> Self {
        let side = || Side { marks: vec![Mark::default(); vertices], heap: BinaryHeap::new() };
        Self { edges: vec![Vec::new(); vertices], sides: [side(), side()], now: 0 }
    }

    pub(super) fn add_edge(&mut self, a: u32, b: u32, length: f64) {
        self.edges[a as usize].push((b, length));
        self.edges[b as usize].push((a, length));
    }

    /// Begins at both ends.
    pub(super) fn begin(&mut self, ends: [u32; 2]) {
        self.now += 1;
        for (side, v) in ends.into_iter().enumerate() {
            self.sides[side].heap.clear();
            self.note(side, v, v, 0.0);
        }
    }

    /// Notes that one search has come to `v`, by a way of its own.
    pub(super) fn note(&mut self, side: usize, v: u32, from: u32, length: f64) {
        self.sides[side].marks[v as usize] = Mark { stamp: self.now, from, length };
    }

    /// How far `v` is from an end, as far as that is known.
    pub(super) fn length(&self, side: usize, v: u32) -> Option<f64> {
        let mark = self.sides[side].marks[v as usize];
        (mark.stamp == self.now).then_some(mark.length)
    }

    /// The vertex that `v` was reached from.
    pub(super) fn from(&self, side: usize, v: u32) -> u32 {
        self.sides[side].marks[v as usize].from
    }

    /// Leads the searches on from two vertices that have been noted; true if the first comes to the start of the second over
    /// no more than `longest`.
    pub(super) fn meet(&mut self, starts: [u32; 2], longest: f64) -> bool {
        for (side, v) in starts.into_iter().enumerate() {
            let length = self.length(side, v).unwrap_or(0.0);
            self.sides[side].heap.push(Reverse((length.to_bits(), v)));
        }
        let mut best = f64::INFINITY;
        loop {
            let [ahead, behind] = [0, 1].map(|side| self.sides[side].least());
            if ahead + behind >= best || ahead + behind > longest {
                break;
            }
            best = best.min(self.step(usize::from(behind < ahead), longest));
        }
        best <= longest && self.finish(starts[1], best * (1.0 + ROUNDING))
    }

    /// Goes on from the nearest vertex of one search; the length of the shortest path over both that this shows.
    fn step(&mut self, side: usize, longest: f64) -> f64 {
        let Some((length, v)) = self.sides[side].pop() else { return f64::INFINITY };
        let mut best = f64::INFINITY;
        for k in 0..self.edges[v as usize].len() {
            let (next, step) = self.edges[v as usize][k];
            let total = length + step;
            if total <= longest && self.reach(side, next, v, total) {
                best = best.min(self.length(1 - side, next).map_or(f64::INFINITY, |rest| total + rest));
            }
        }
        best
    }

    /// Leads the first search to `end` over the vertices that can lie on a path no longer than `longest`.
    fn finish(&mut self, end: u32, longest: f64) -> bool {
        let behind = self.sides[1].least();
        while let Some((length, v)) = self.sides[0].pop() {
            if v == end {
                return true;
            }
            // What the second search has not settled is no nearer to the end than the last that it has.
            let rest = self.length(1, v).map_or(behind, |known| known.min(behind));
            if length + rest <= longest {
                for k in 0..self.edges[v as usize].len() {
                    let (next, step) = self.edges[v as usize][k];
                    self.reach(0, next, v, length + step);
                }
            }
        }
        false
    }

    /// Queues a vertex; false if a way as short was known.
    fn reach(&mut self, side: usize, v: u32, from: u32, length: f64) -> bool {
        if self.length(side, v).is_some_and(|known| known <= length) {
            return false;
        }
        self.note(side, v, from, length);
        self.sides[side].heap.push(Reverse((length.to_bits(), v)));
        true
    }
}

impl Side {
    /// How far the nearest vertex is that is queued; entries of vertices that were reached by a shorter way since are dropped.
    fn least(&mut self) -> f64 {
        while let Some(&Reverse((bits, v))) = self.heap.peek() {
            let length = f64::from_bits(bits);
            if length <= self.marks[v as usize].length {
                return length;
            }
            self.heap.pop();
        }
        f64::INFINITY
    }

    /// The nearest vertex that is queued, with its length.
    fn pop(&mut self) -> Option<(f64, u32)> {
        while let Some(Reverse((bits, v))) = self.heap.pop() {
            let length = f64::from_bits(bits);
            if length <= self.marks[v as usize].length {
                return Some((length, v));
            }
        }
        None
    }
}
