//! Bounded walks on a line graph, for pruning and for the repair and connection of lines.

use super::rule::Metric;
use crate::pattern::LineGraph;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Shortest-path search that stamps visited vertices with a counter instead of clearing flags (Gumhold 2001, section 3.2).
pub(crate) struct Walker<'a> {
    stamp: Vec<u32>,
    now: u32,
    /// The vertex from which each was reached, valid for the present stamp.
    from: Vec<u32>,
    reached: Vec<f64>,
    heap: BinaryHeap<(Reverse<Length>, Reverse<u32>)>,
    metric: Metric<'a>,
}

/// A length with a total order.
#[derive(Clone, Copy, PartialEq)]
struct Length(f64);

impl Eq for Length {}

impl PartialOrd for Length {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Length {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

impl<'a> Walker<'a> {
    /// A walker for graphs of `vertices` vertices.
    pub fn new(vertices: usize, metric: Metric<'a>) -> Self {
        Self {
            stamp: vec![0; vertices],
            now: 0,
            from: vec![0; vertices],
            reached: vec![0.0; vertices],
            heap: BinaryHeap::new(),
            metric,
        }
    }

    /// The shortest path from `a` to `b`, as vertices from `b` back to `a`; `None` if it is longer than `limit`.
    pub fn path(&mut self, lines: &LineGraph, a: u32, b: u32, limit: f64) -> Option<Vec<u32>> {
        self.begin(a);
        while let Some((Reverse(Length(length)), Reverse(v))) = self.heap.pop() {
            if length > self.reached[v as usize] {
                continue;
            }
            if v == b {
                return Some(self.trace(a, b));
            }
            self.expand(lines, v, None, length, limit);
        }
        None
    }

    /// The depth of the branch that leaves `root` through its neighbour `first`: infinite if it leads back to `root` or is at
    /// least `limit` deep.
    pub fn depth(&mut self, lines: &LineGraph, root: u32, first: u32, limit: f64) -> f64 {
        self.begin(root);
        self.heap.clear();
        self.reach(first, root, self.metric.length(lines, root, first));
        let mut deepest = 0.0_f64;
        while let Some((Reverse(Length(length)), Reverse(v))) = self.heap.pop() {
            deepest = deepest.max(length);
            let returns = v != first && lines.edges[v as usize].contains(&root);
            if length >= limit || returns {
                return f64::INFINITY;
            }
            self.expand(lines, v, Some(root), length, f64::INFINITY);
        }
        deepest
    }

    fn begin(&mut self, a: u32) {
        self.now += 1;
        self.heap.clear();
        self.reach(a, a, 0.0);
    }

    fn reach(&mut self, v: u32, from: u32, length: f64) {
        self.stamp[v as usize] = self.now;
        self.from[v as usize] = from;
        self.reached[v as usize] = length;
        self.heap.push((Reverse(Length(length)), Reverse(v)));
    }

    fn expand(&mut self, lines: &LineGraph, v: u32, except: Option<u32>, length: f64, limit: f64) {
        for &next in &lines.edges[v as usize] {
            let total = length + self.metric.length(lines, v, next);
            let known = self.stamp[next as usize] == self.now && self.reached[next as usize] <= total;
            if !known && total <= limit && Some(next) != except {
                self.reach(next, v, total);
            }
        }
    }

    fn trace(&self, a: u32, b: u32) -> Vec<u32> {
        let mut path = vec![b];
        let mut v = b;
        while v != a {
            v = self.from[v as usize];
            path.push(v);
        }
        path
    }
}
