//! Closed sharp feature lines from a graph of clusters (Demarsin et al. 2007, sections 2.3 to 2.8).
//!
//! Each vertex is a small cluster; the large clusters that it touches are kept beside it. Edges with a large cluster need no
//! place in the graph: they outweigh all others in the spanning tree and are removed from it, so the tree without them is
//! the minimum spanning forest of the small clusters.

mod branches;
mod connect;
mod extend;
mod forest;
mod ground;
mod group;
mod include;
mod open;
mod paper;
mod reroute;
mod robust;
mod smooth;

pub use extend::extend;
pub use forest::forest;
pub use paper::link_paper;
pub use robust::{border, link_robust};

use crate::link::Candidate;
use crate::pattern::{LineGraph, Pattern};
use std::time::Instant;

/// Small clusters, what joins them, and the large clusters that they touch.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Clusters {
    /// One vertex a small cluster; its edges are those of the stage.
    pub lines: LineGraph,
    /// Edges with their weights, where these are more than lengths; ascending, and a pair may stand several times.
    pub weights: Vec<Candidate>,
    /// `(V)` the large clusters that each touches, ascending.
    pub large: Vec<Vec<u32>>,
    /// Number of large clusters.
    pub large_count: usize,
    /// Pairs of large clusters that touch each other.
    pub large_pairs: usize,
}

/// One graph of the paper's table 2.
#[derive(Clone, Debug, PartialEq)]
pub struct GraphStage {
    /// The paper's name: `G_all`, `G_extended`, `G_pruned_mst`, `G_pruned_branches`, `G_closed` or `G_smooth`.
    pub name: &'static str,
    /// Vertices, large clusters included in the first two.
    pub vertices: usize,
    /// Edges, those with large clusters included in the first two.
    pub edges: usize,
    /// Seconds that the step took.
    pub seconds: f64,
    /// The graph after the step, local frame.
    pub lines: LineGraph,
}

/// What a linker of clusters leaves.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Linked {
    /// Closed lines.
    pub pattern: Pattern,
    /// The crease graph after each step.
    pub stages: Vec<GraphStage>,
}

impl Clusters {
    fn edges_with_large(&self) -> usize {
        self.large.iter().map(Vec::len).sum::<usize>() + self.large_pairs
    }
}

/// Notes the graph after each step.
struct Recorder {
    stages: Vec<GraphStage>,
    start: Instant,
}

impl Recorder {
    fn new() -> Self {
        Self { stages: Vec::new(), start: Instant::now() }
    }

    /// A graph that still has all clusters.
    fn whole(&mut self, name: &'static str, clusters: &Clusters) {
        let vertices = clusters.lines.edges.len() + clusters.large_count;
        self.push(name, vertices, clusters.lines.edge_count() + clusters.edges_with_large(), &clusters.lines);
    }

    /// A graph of lines: vertices without an edge are no part of it.
    fn lines(&mut self, name: &'static str, lines: &LineGraph) {
        let vertices = lines.edges.iter().filter(|e| !e.is_empty()).count();
        self.push(name, vertices, lines.edge_count(), lines);
    }

    fn push(&mut self, name: &'static str, vertices: usize, edges: usize, lines: &LineGraph) {
        let seconds = self.start.elapsed().as_secs_f64();
        self.stages.push(GraphStage { name, vertices, edges, seconds, lines: lines.clone() });
        self.start = Instant::now();
    }
}

#[cfg(test)]
mod tests;
