//! A graph of lines that grows edge by edge, asked for the shortest path between two of its vertices.
//!
//! Most vertices hang on the rest as trees, through which there is one path: it is climbed. A search is needed in the 2-core
//! alone, what is left of a graph once its loose ends are taken away again and again (S. B. Seidman, "Network structure and
//! minimum degree", Social Networks 5, 1983, section 3). As edges are only added, a vertex enters the core once, and a tree is
//! hung up anew only when it joins a larger one: the whole takes n log n steps beside the searches.

use super::two_sided::{ROUNDING, TwoSided};
use crate::math::union_find::UnionFind;

/// Stands for the vertex above the top of a piece without a cycle.
const NONE: u32 = u32::MAX;

/// The graph.
pub(crate) struct Web {
    /// Connected pieces.
    pieces: UnionFind,
    /// `(V)` whether the piece has a cycle, and so a core; by its representative.
    cyclic: Vec<bool>,
    /// `(V)` whether the vertex lies in the core of its piece.
    core: Vec<bool>,
    /// `(V)` for the others the next vertex on the way to the core, or to the top of the piece, and how far it is.
    up: Vec<(u32, f64)>,
    /// The edges of the cores.
    search: TwoSided,
}

/// Where two climbs come to.
enum Climbed {
    /// One vertex on the way of both.
    Met(u32),
    /// A core, each at a vertex of its own.
    Core([u32; 2]),
    /// Neither within the length allowed.
    Apart,
}

impl Web {
    /// A graph without edges.
    pub(crate) fn new(vertices: usize) -> Self {
        Self {
            pieces: UnionFind::new(vertices),
            cyclic: vec![false; vertices],
            core: vec![false; vertices],
            up: vec![(NONE, 0.0); vertices],
            search: TwoSided::new(vertices),
        }
    }

    /// Adds an edge if it joins two pieces; false if they were one already.
    pub(crate) fn join(&mut self, a: u32, b: u32, length: f64) -> bool {
        let [p, q] = [a, b].map(|v| self.pieces.find(v));
        if p == q {
            return false;
        }
        let cyclic = [p, q].map(|piece| self.cyclic[piece as usize]);
        match cyclic {
            [true, true] => self.add_to_core(a, b, length),
            [true, false] => self.hang(b, (a, length)),
            [false, true] => self.hang(a, (b, length)),
            [false, false] if self.pieces.size(p) >= self.pieces.size(q) => self.hang(b, (a, length)),
            [false, false] => self.hang(a, (b, length)),
        }
        self.pieces.union(a, b);
        let piece = self.pieces.find(a);
        self.cyclic[piece as usize] = cyclic != [false; 2];
        true
    }

    /// Adds an edge within a piece.
    pub(crate) fn close(&mut self, a: u32, b: u32, length: f64) {
        let piece = self.pieces.find(a) as usize;
        if !std::mem::replace(&mut self.cyclic[piece], true) {
            self.search.begin([a, b]);
            // The core begins where the ways of both to the top meet.
            if let Climbed::Met(v) = self.climb([a, b], f64::INFINITY) {
                self.hang(v, (NONE, 0.0));
                self.core[v as usize] = true;
            }
        }
        self.add_to_core(a, b, length);
    }

    /// The shortest path from `a` to `b` if there is one no longer than `limit`: its length, and its vertices from `b` back to
    /// `a`.
    pub(crate) fn shortest(&mut self, a: u32, b: u32, limit: f64) -> Option<(f64, Vec<u32>)> {
        let longest = limit * (1.0 + ROUNDING);
        self.search.begin([a, b]);
        let turn = match self.climb([a, b], longest) {
            Climbed::Met(v) => v,
            Climbed::Core(tops) if self.search.meet(tops, longest) => tops[1],
            _ => return None,
        };
        let mut length = self.search.length(0, turn)?;
        let mut path = Vec::new();
        let mut v = turn;
        while v != b {
            v = self.search.from(1, v);
            length += self.up[v as usize].1;
            path.push(v);
        }
        path.reverse();
        path.push(turn);
        v = turn;
        while v != a {
            v = self.search.from(0, v);
            path.push(v);
        }
        (length <= limit).then_some((length, path))
    }

    /// Climbs from both ends by turns.
    fn climb(&mut self, ends: [u32; 2], longest: f64) -> Climbed {
        let mut tops = ends;
        let mut climbing = [true; 2];
        while climbing != [false; 2] {
            for side in 0..2 {
                if !std::mem::take(&mut climbing[side]) {
                    continue;
                }
                let v = tops[side];
                let (next, step) = self.up[v as usize];
                let length = self.search.length(side, v).unwrap_or(0.0) + step;
                if self.core[v as usize] || next == NONE || length > longest {
                    continue;
                }
                self.search.note(side, next, v, length);
                if self.search.length(1 - side, next).is_some() {
                    return Climbed::Met(next);
                }
                (tops[side], climbing[side]) = (next, true);
            }
        }
        if tops.iter().all(|&v| self.core[v as usize]) { Climbed::Core(tops) } else { Climbed::Apart }
    }

    /// Turns the ways up of a piece without a cycle, so that they lead to `v` and from there to `above`.
    fn hang(&mut self, mut v: u32, mut above: (u32, f64)) {
        loop {
            let (next, step) = std::mem::replace(&mut self.up[v as usize], above);
            if next == NONE {
                break;
            }
            (v, above) = (next, (v, step));
        }
    }

    /// Adds an edge to the core, with the ways from both its ends up to there.
    fn add_to_core(&mut self, a: u32, b: u32, length: f64) {
        for mut v in [a, b] {
            while !std::mem::replace(&mut self.core[v as usize], true) {
                let (next, step) = self.up[v as usize];
                self.search.add_edge(v, next, step);
                v = next;
            }
        }
        self.search.add_edge(a, b, length);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The shortest path by Dijkstra's search over plain lists, ties by index.
    fn plain(edges: &[Vec<(u32, f64)>], a: u32, b: u32) -> (f64, Vec<u32>) {
        let mut known = vec![(f64::INFINITY, 0); edges.len()];
        let mut open = std::collections::BTreeSet::from([(0, a)]);
        known[a as usize].0 = 0.0;
        while let Some((bits, v)) = open.pop_first() {
            let length = f64::from_bits(bits);
            let stale = length > known[v as usize].0;
            for &(next, step) in edges[v as usize].iter().filter(|_| !stale) {
                if length + step < known[next as usize].0 {
                    known[next as usize] = (length + step, v);
                    open.insert(((length + step).to_bits(), next));
                }
            }
        }
        let mut path = vec![b];
        while path[path.len() - 1] != a {
            path.push(known[path[path.len() - 1] as usize].1);
        }
        (known[b as usize].0, path)
    }

    #[test]
    fn a_tree_answers_as_many_questions_as_it_has_vertices() {
        // A search from an end would see most of the 200,000 vertices each time.
        let mut rng = crate::shapes::Rng::new(4);
        let count = 200_000u32;
        let mut web = Web::new(count as usize);
        for v in 1..count {
            assert!(web.join(v, rng.below(u64::from(v)) as u32, 1.0));
        }
        for v in 0..count - 1 {
            let (length, path) = web.shortest(v, v + 1, 1e3).unwrap();
            assert_eq!((length, path[0], path[path.len() - 1]), ((path.len() - 1) as f64, v + 1, v));
        }
    }

    #[test]
    fn paths_of_a_growing_graph_are_those_of_a_plain_search() {
        for (seed, steps) in [(1, 1.0), (2, 4.0), (3, 1e9)] {
            let mut rng = crate::shapes::Rng::new(seed);
            let count = 120u32;
            let (mut web, mut edges) = (Web::new(count as usize), vec![Vec::new(); count as usize]);
            let (mut sets, mut compared) = (UnionFind::new(count as usize), 0);
            for _ in 0..1500 {
                let a = (rng.uniform() * f64::from(count)) as u32;
                let b = (a + 1 + (rng.uniform() * 30.0) as u32) % count;
                // With few lengths many paths are as short as each other.
                let length = (rng.uniform() * steps).ceil() / steps.min(7.0);
                let joins = sets.union(a, b);
                assert_eq!(web.join(a, b, length), joins);
                if !joins {
                    let (shortest, path) = plain(&edges, a, b);
                    assert_eq!(web.shortest(a, b, shortest), Some((shortest, path)));
                    assert_eq!(web.shortest(a, b, shortest * 0.999), None);
                    compared += 1;
                    // The others would close small cycles.
                    if shortest < 3.0 * length || edges[a as usize].iter().any(|e: &(u32, f64)| e.0 == b) {
                        continue;
                    }
                    web.close(a, b, length);
                }
                edges[a as usize].push((b, length));
                edges[b as usize].push((a, length));
            }
            assert!(compared > 1000, "{compared}");
        }
    }
}
