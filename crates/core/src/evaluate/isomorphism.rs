//! Isomorphism: whether a network and a truth are the same graph, whatever their geometry.

use std::collections::BTreeMap;

use crate::network::{Network, StripKind};
use crate::shapes::Truth;

/// Curves between nodes, and loops without nodes, by kind.
#[derive(Debug, Default)]
struct Graph {
    edges: Vec<(u32, u32, StripKind)>,
    /// Closed curves, creases and borders.
    loops: [usize; 2],
}

/// Whether a network and a truth are isomorphic multigraphs: a bijection of the nodes carries creases to creases and
/// borders to borders, and each has as many closed curves of either kind.
///
/// Nodes with exactly two curve ends of one kind are dissolved in both graphs first, as it is a matter of degree whether the
/// turn of a line is a node; nodes without curves do not count. The search is exponential in the worst case. It takes the nodes
/// in an order in which each is connected to earlier ones, which keeps it short for networks of parts.
pub fn isomorphic(network: &Network, truth: &Truth) -> bool {
    let found = network.strips.iter().map(|s| (s.start.zip(s.end), s.kind));
    let known = truth.curves.iter().map(|c| (c.start.zip(c.end), c.kind));
    let [a, b] = [Graph::new(found), Graph::new(known)];
    a.loops == b.loops && a.edges.len() == b.edges.len() && Search::new(&a, &b).extend(0)
}

impl Graph {
    fn new(curves: impl Iterator<Item = (Option<(u32, u32)>, StripKind)>) -> Self {
        let mut graph = Self::default();
        for (ends, kind) in curves {
            match ends {
                Some((a, b)) => graph.edges.push((a, b, kind)),
                None => graph.loops[kind as usize] += 1,
            }
        }
        while graph.dissolve() {}
        graph
    }

    /// Removes one node between two ends of one kind; false if there is none.
    fn dissolve(&mut self) -> bool {
        let mut ends: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
        for (i, &(a, b, _)) in self.edges.iter().enumerate() {
            ends.entry(a).or_default().push(i);
            ends.entry(b).or_default().push(i);
        }
        let straight = |at: &[usize]| at.len() == 2 && self.edges[at[0]].2 == self.edges[at[1]].2;
        let Some((&node, at)) = ends.iter().find(|(_, at)| straight(at)) else { return false };
        let (i, j) = (at[0].min(at[1]), at[0].max(at[1]));
        let (a, b, kind) = self.edges[i];
        if i == j {
            self.loops[kind as usize] += 1;
        } else {
            let (c, d, _) = self.edges.swap_remove(j);
            self.edges.push((if a == node { b } else { a }, if c == node { d } else { c }, kind));
        }
        self.edges.swap_remove(i);
        true
    }

    /// The number of curves of either kind from each node to each other.
    fn neighbours(&self) -> BTreeMap<u32, BTreeMap<u32, [usize; 2]>> {
        let mut all: BTreeMap<u32, BTreeMap<u32, [usize; 2]>> = BTreeMap::new();
        for &(a, b, kind) in &self.edges {
            all.entry(a).or_default().entry(b).or_default()[kind as usize] += 1;
            all.entry(b).or_default().entry(a).or_default()[kind as usize] += 1;
        }
        all
    }
}

/// Backtracking over the nodes of `a`, each paired with a node of `b`.
struct Search {
    a: BTreeMap<u32, BTreeMap<u32, [usize; 2]>>,
    b: BTreeMap<u32, BTreeMap<u32, [usize; 2]>>,
    order: Vec<u32>,
    image: BTreeMap<u32, u32>,
    taken: BTreeMap<u32, u32>,
}

impl Search {
    fn new(a: &Graph, b: &Graph) -> Self {
        let (a, b) = (a.neighbours(), b.neighbours());
        let mut order: Vec<u32> = Vec::new();
        let mut seen = std::collections::BTreeSet::new();
        for &root in a.keys() {
            let mut next = order.len();
            if seen.insert(root) {
                order.push(root);
            }
            while next < order.len() {
                let beside = a[&order[next]].keys().filter(|&&n| seen.insert(n));
                order.extend(beside.copied().collect::<Vec<_>>());
                next += 1;
            }
        }
        Self { a, b, order, image: BTreeMap::new(), taken: BTreeMap::new() }
    }

    fn extend(&mut self, depth: usize) -> bool {
        if self.a.len() != self.b.len() {
            return false;
        }
        let Some(&node) = self.order.get(depth) else { return true };
        // If a neighbour has an image, only the image's neighbours come into question.
        let placed = self.a[&node].keys().find_map(|n| self.image.get(n));
        let candidates: Vec<u32> = match placed {
            Some(image) => self.b[image].keys().copied().collect(),
            None => self.b.keys().copied().collect(),
        };
        for other in candidates {
            if self.fits(node, other) {
                self.image.insert(node, other);
                self.taken.insert(other, node);
                if self.extend(depth + 1) {
                    return true;
                }
                self.image.remove(&node);
                self.taken.remove(&other);
            }
        }
        false
    }

    /// Whether `other` is free and joined to the images exactly as `node` is to the nodes placed before it.
    fn fits(&self, node: u32, other: u32) -> bool {
        let (here, there) = (&self.a[&node], &self.b[&other]);
        let itself = |beside: &BTreeMap<u32, [usize; 2]>, n: u32| beside.get(&n).copied();
        let forth =
            here.iter().all(|(n, count)| self.image.get(n).is_none_or(|m| there.get(m) == Some(count)));
        let back =
            there.iter().all(|(m, count)| self.taken.get(m).is_none_or(|n| here.get(n) == Some(count)));
        let free = !self.taken.contains_key(&other) && here.len() == there.len();
        free && forth && back && itself(here, node) == itself(there, other)
    }
}
