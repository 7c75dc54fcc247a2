//! The Riemannian graph (Gumhold, Wang and MacLeod 2001, section 2.1) and neighbourhoods by graph distance.
//!
//! An edge joins two points if either is among the `k` nearest of the other.

use rayon::prelude::*;

use super::Neighbors;

/// The Riemannian graph over lists of nearest neighbours: the union of each list with the points that list its
/// owner, every list sorted by (distance, index). The paper takes `k` from 10 to 16.
///
/// `positions` are the `(N, 3)` points that `nearest` was made from.
pub fn graph(positions: &[[f64; 3]], nearest: &Neighbors) -> Neighbors {
    let reverse = transpose(nearest);
    let distance2 = |i: usize, j: u32| crate::math::vec3::distance2(positions[i], positions[j as usize]);
    let union = |i: usize| {
        let own = nearest.of(i);
        let others = reverse.of(i).iter().filter(|j| !own.contains(j));
        let mut list: Vec<(f64, u32)> = own.iter().chain(others).map(|&j| (distance2(i, j), j)).collect();
        list.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        list.into_iter().map(|(_, j)| j).collect::<Vec<u32>>()
    };
    let lists: Vec<Vec<u32>> = (0..nearest.len()).into_par_iter().map(union).collect();
    let mut offsets = vec![0; nearest.len() + 1];
    for (i, list) in lists.iter().enumerate() {
        offsets[i + 1] = offsets[i] + list.len() as u64;
    }
    Neighbors { offsets, indices: lists.concat() }
}

/// For each point the points that list it, in ascending order.
fn transpose(lists: &Neighbors) -> Neighbors {
    let mut offsets = vec![0u64; lists.len() + 1];
    for &j in &lists.indices {
        offsets[j as usize + 1] += 1;
    }
    for i in 0..lists.len() {
        offsets[i + 1] += offsets[i];
    }
    let mut next = offsets.clone();
    let mut indices = vec![0; lists.indices.len()];
    for i in 0..lists.len() {
        for &j in lists.of(i) {
            indices[next[j as usize] as usize] = i as u32;
            next[j as usize] += 1;
        }
    }
    Neighbors { offsets, indices }
}

/// Memory of a breadth-first search, used again and again without clearing: a point is known as visited by the
/// number of the search that last came by.
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
        scratch.visit(i as u32);
        let mut ring = 0..0;
        for hop in 0..depth {
            let end = scratch.found.len();
            let range = ring.clone();
            if hop == 0 {
                self.of(i).iter().for_each(|&j| scratch.add(j));
            }
            for f in range {
                let from = scratch.found[f] as usize;
                self.of(from).iter().for_each(|&j| scratch.add(j));
            }
            ring = end..scratch.found.len();
        }
        &scratch.found
    }
}

impl Scratch {
    fn begin(&mut self, count: usize) {
        if self.visited.len() != count || self.search == u32::MAX {
            self.visited = vec![0; count];
            self.search = 0;
        }
        self.search += 1;
        self.found.clear();
    }

    fn visit(&mut self, j: u32) -> bool {
        let seen = &mut self.visited[j as usize];
        let new = *seen != self.search;
        *seen = self.search;
        new
    }

    fn add(&mut self, j: u32) {
        if self.visit(j) {
            self.found.push(j);
        }
    }
}
