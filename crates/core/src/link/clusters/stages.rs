//! The graph after each step, with its counts and time (Demarsin et al. 2007, table 2).

use super::graph::Clusters;
use crate::pattern::{LineGraph, Pattern};
use std::time::Instant;

/// One graph of the paper's table 2.
#[derive(Clone, Debug, PartialEq)]
pub struct GraphStage {
    /// The paper's name: `G_all`, `G_extended`, `G_pruned_mst`, `G_pruned_branches`, `G_closed` or `G_smooth`.
    pub name: &'static str,
    /// Number of vertices, in the first two graphs with the large clusters.
    pub vertices: usize,
    /// Number of edges, in the first two graphs with those to large clusters.
    pub edges: usize,
    /// Seconds that the step took.
    pub seconds: f64,
    /// The graph after the step, local frame.
    pub lines: LineGraph,
}

/// The result of linking clusters.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Linked {
    /// Closed lines.
    pub pattern: Pattern,
    /// The crease graph after each step.
    pub stages: Vec<GraphStage>,
}

/// Records the graph after each step.
pub(super) struct Recorder {
    pub(super) stages: Vec<GraphStage>,
    start: Instant,
}

impl Recorder {
    pub(super) fn new() -> Self {
        Self { stages: Vec::new(), start: Instant::now() }
    }

    /// Records a graph that still has its large clusters.
    pub(super) fn whole(&mut self, name: &'static str, clusters: &Clusters) {
        let vertices = clusters.lines.edges.len() + clusters.large_count;
        self.push(name, vertices, clusters.lines.edge_count() + clusters.edges_with_large(), &clusters.lines);
    }

    /// Records a graph of lines; vertices without an edge do not count.
    pub(super) fn lines(&mut self, name: &'static str, lines: &LineGraph) {
        let vertices = lines.edges.iter().filter(|e| !e.is_empty()).count();
        self.push(name, vertices, lines.edge_count(), lines);
    }

    fn push(&mut self, name: &'static str, vertices: usize, edges: usize, lines: &LineGraph) {
        let seconds = self.start.elapsed().as_secs_f64();
        self.stages.push(GraphStage { name, vertices, edges, seconds, lines: lines.clone() });
        self.start = Instant::now();
    }
}
