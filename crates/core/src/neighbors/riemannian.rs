//! The Riemannian graph (Gumhold, Wang and MacLeod 2001, section 2.1) and neighbourhoods by graph distance.
//!
//! An edge joins two points if either is among the `k` nearest of the other. One departure: a distant point, such as a
//! scanner's stray return, lists points of a surface on which it does not lie, and is not listed in return.

use std::ops::Range;

use super::rows::Neighbors;
use crate::math::vec3;
use crate::parallel;

/// Number of parts of the cloud that are processed in parallel: fixed, and small enough to separate edges by pairs of parts.
const PARTS: usize = 64;
/// Multiple of a list's greatest distance above which a point that lists its owner does not enter it.
pub(crate) const STRAY: f64 = 8.0;

/// The Riemannian graph over `nearest`, the result of [`all_nearest`](super::all_nearest) for the same `(N, 3)` `positions`:
/// each list joined with the points that list its owner, sorted by (distance, index). The paper takes `k` from 10 to 16.
///
/// A point that lists `i` but is not listed by `i` is farther from `i` than all points in the list of `i`. So each list of the
/// graph is the given one, followed by those other points by distance. A point more than 8 times as far is left out; this is the
/// only case in which an edge is in one of its two lists alone.
pub fn graph(positions: &[[f64; 3]], nearest: &Neighbors) -> Neighbors {
    let size = nearest.len().div_ceil(PARTS).max(1);
    let parts = nearest.len().div_ceil(size);
    let points = |p: usize| p * size..nearest.len().min((p + 1) * size);
    let sent = parallel::map(parts, parallel::TASK, |p| one_sided(positions, nearest, points(p), size));
    let row = |p: usize| Rows::received(positions, sent.iter().map(|to| to[p].as_slice()), points(p));
    let rows = parallel::map(parts, parallel::TASK, row);
    join(nearest, &rows, size)
}

/// `from` lists `to`, but `to` does not list `from`.
struct Edge {
    to: u32,
    from: u32,
}

/// The one-sided edges from the points of a range, separated by the part of `size` points to which they lead.
fn one_sided(positions: &[[f64; 3]], nearest: &Neighbors, from: Range<usize>, size: usize) -> Vec<Vec<Edge>> {
    let parts = nearest.len().div_ceil(size);
    let mut edges: Vec<Vec<Edge>> = (0..parts).map(|_| Vec::new()).collect();
    let distance2 = |i: u32, j: u32| vec3::distance2(positions[i as usize], positions[j as usize]);
    for i in from {
        for &j in nearest.of(i) {
            let list = nearest.of(j as usize);
            let stray = || distance2(i as u32, j) > STRAY * STRAY * distance2(list[list.len() - 1], j);
            if !contains(list, i as u32) && !stray() {
                edges[j as usize / size].push(Edge { to: j, from: i as u32 });
            }
        }
    }
    edges
}

/// Whether a short list holds a value. The whole list is compared, without a branch for each entry.
#[inline]
fn contains(list: &[u32], value: u32) -> bool {
    let (eights, rest) = list.as_chunks::<8>();
    let mut equal = [0u32; 8];
    for eight in eights {
        equal.iter_mut().zip(eight).for_each(|(e, &x)| *e |= u32::from(x == value));
    }
    equal.iter().fold(0, |a, e| a | e) | rest.iter().fold(0, |a, &x| a | u32::from(x == value)) != 0
}

/// For each point of a part, the points that list it one-sidedly.
struct Rows {
    /// `(P + 1)` beginning of each row.
    starts: Vec<u32>,
    indices: Vec<u32>,
}

impl Rows {
    /// Gathers the edges that lead into a part by a counting sort, and orders each row by (distance, index).
    fn received<'a>(
        positions: &[[f64; 3]],
        edges: impl Iterator<Item = &'a [Edge]> + Clone,
        to: Range<usize>,
    ) -> Rows {
        let mut starts = vec![0; to.len() + 1];
        edges.clone().flatten().for_each(|e| starts[e.to as usize - to.start + 1] += 1);
        (0..to.len()).for_each(|i| starts[i + 1] += starts[i]);
        let mut next = starts.clone();
        let mut indices = vec![0; starts[to.len()] as usize];
        for e in edges.flatten() {
            let place = &mut next[e.to as usize - to.start];
            indices[*place as usize] = e.from;
            *place += 1;
        }
        for (i, row) in to.zip(starts.windows(2)) {
            let distance2 = |j: u32| vec3::distance2(positions[i], positions[j as usize]);
            let order = |&a: &u32, &b: &u32| distance2(a).total_cmp(&distance2(b)).then(a.cmp(&b));
            indices[row[0] as usize..row[1] as usize].sort_unstable_by(order);
        }
        Rows { starts, indices }
    }
}

/// Each list of `nearest` followed by its row.
fn join(nearest: &Neighbors, rows: &[Rows], size: usize) -> Neighbors {
    let mut offsets = Vec::with_capacity(nearest.len() + 1);
    offsets.push(0);
    for (p, rows) in rows.iter().enumerate() {
        for (i, row) in rows.starts.windows(2).enumerate() {
            let before = offsets[offsets.len() - 1];
            offsets.push(before + nearest.of(p * size + i).len() as u64 + u64::from(row[1] - row[0]));
        }
    }
    let mut indices = vec![0; offsets[offsets.len() - 1] as usize];
    let mut slices = Vec::with_capacity(rows.len());
    let mut rest = indices.as_mut_slice();
    for p in 0..rows.len() {
        let points = p * size..nearest.len().min((p + 1) * size);
        let (slice, after) = rest.split_at_mut((offsets[points.end] - offsets[points.start]) as usize);
        slices.push((points, slice));
        rest = after;
    }
    parallel::each(slices.into_iter().zip(rows), |_, ((points, mut slice), rows)| {
        for (i, row) in points.zip(rows.starts.windows(2)) {
            for list in [nearest.of(i), &rows.indices[row[0] as usize..row[1] as usize]] {
                let (head, tail) = slice.split_at_mut(list.len());
                head.copy_from_slice(list);
                slice = tail;
            }
        }
    });
    Neighbors { offsets, indices }
}

/// Memory of a breadth-first search, used repeatedly without clearing: each point is stamped with the number of the last search
/// that visited it.
///
/// It takes 4 bytes for each point in each thread, which is acceptable up to about 10^8 points. Beyond, a hash set of the size
/// of a neighbourhood would be better.
#[derive(Clone, Debug, Default)]
pub struct Scratch {
    visited: Vec<u32>,
    search: u32,
    found: Vec<u32>,
}

impl Neighbors {
    /// The points at graph distance 1 to `depth` from point `i`, nearer ones first, in the order of the lists.
    pub fn hops<'s>(&self, i: usize, depth: usize, scratch: &'s mut Scratch) -> &'s [u32] {
        scratch.begin(self.len());
        scratch.add(i as u32);
        let mut ring = 0..1;
        for _ in 0..depth {
            let end = scratch.found.len();
            for f in ring {
                let from = scratch.found[f] as usize;
                self.of(from).iter().for_each(|&j| scratch.add(j));
            }
            ring = end..scratch.found.len();
        }
        &scratch.found[1..]
    }
}

impl Scratch {
    /// Starts a search in a graph of `count` points.
    fn begin(&mut self, count: usize) {
        if self.visited.len() != count || self.search == u32::MAX {
            self.visited = vec![0; count];
            self.search = 0;
        }
        self.search += 1;
        self.found.clear();
    }

    /// Adds a point that has not been found in this search.
    #[inline]
    fn add(&mut self, j: u32) {
        let seen = &mut self.visited[j as usize];
        if *seen != self.search {
            *seen = self.search;
            self.found.push(j);
        }
    }
}
