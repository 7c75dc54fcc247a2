//! A neighbour graph as the writers take it.

use crate::write::network::NetworkContext;
use lineament::Cloud;
use lineament::apply::CutGraph;

/// A neighbour graph over the points of a cloud.
#[derive(Clone, Copy, Debug)]
pub struct GraphTable<'a> {
    /// The points as they were read.
    pub cloud: &'a Cloud,
    /// The edges, by rows of the cloud.
    pub graph: &'a CutGraph,
    /// Whether the edges that cross a line are written too, with a column that tells them.
    pub all: bool,
    /// Provenance.
    pub context: &'a NetworkContext,
}

impl GraphTable<'_> {
    /// The edges that are written, and whether each crosses a line.
    pub(super) fn edges(&self) -> impl Iterator<Item = ([u32; 2], bool)> + '_ {
        let cut = if self.all { self.graph.cut.as_slice() } else { &[] };
        let kept = self.graph.edges.iter().map(|&edge| (edge, false));
        kept.chain(cut.iter().map(|&edge| (edge, true)))
    }

    /// The number of edges that are written.
    pub(super) fn count(&self) -> usize {
        self.graph.edges.len() + if self.all { self.graph.cut.len() } else { 0 }
    }

    /// The distance between the ends of an edge, in the unit of the input.
    pub(super) fn length(&self, [i, j]: [u32; 2]) -> f64 {
        let (p, q) = (self.cloud.positions[i as usize], self.cloud.positions[j as usize]);
        (0..3).map(|axis| (p[axis] - q[axis]).powi(2)).sum::<f64>().sqrt()
    }

    /// What an edge names that is not there.
    pub(super) fn check(&self) -> Result<(), String> {
        let count = self.cloud.len();
        let beyond = |edge: &[u32; 2]| edge.iter().any(|&end| end as usize >= count);
        match self.graph.edges.iter().chain(&self.graph.cut).find(|edge| beyond(edge)) {
            Some([i, j]) => Err(format!("an edge joins the points {i} and {j} of {count}")),
            None => Ok(()),
        }
    }
}
