//! The graph of clusters that the steps work on.

use crate::link::spanning::Candidate;
use crate::pattern::LineGraph;

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

impl Clusters {
    /// The number of edges of which an end is a large cluster.
    pub(super) fn edges_with_large(&self) -> usize {
        self.large.iter().map(Vec::len).sum::<usize>() + self.large_pairs
    }
}
