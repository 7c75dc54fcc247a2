//! The graph of clusters, on which the steps from `G_all` to `G_extended` work.

use crate::link::spanning::Candidate;
use crate::pattern::LineGraph;

/// Small clusters, the edges between them, and the large clusters that they touch.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Clusters {
    /// One vertex for each small cluster, with the edges of the present stage.
    pub lines: LineGraph,
    /// Edges in ascending order of weight, where weights are more than lengths; a pair may occur several times.
    pub weights: Vec<Candidate>,
    /// `(V)` large clusters that each vertex touches, ascending.
    pub large: Vec<Vec<u32>>,
    /// Number of large clusters.
    pub large_count: usize,
    /// Pairs of large clusters that touch each other.
    pub large_pairs: usize,
}

impl Clusters {
    /// The number of edges with a large cluster at one end or both.
    pub(super) fn edges_with_large(&self) -> usize {
        self.large.iter().map(Vec::len).sum::<usize>() + self.large_pairs
    }
}
