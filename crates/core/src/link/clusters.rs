//! Closed sharp feature lines from a graph of clusters (Demarsin et al. 2007, sections 2.3 to 2.8).
//!
//! Algorithm 1 is `as_printed`; `robust` is ours. Algorithm 2 is `branches`, the connect algorithm is `connect`.
//!
//! Each vertex is a small cluster; the large clusters that it touches are listed beside it. The graph needs no edges to large
//! clusters: the paper gives them the greatest weights and removes them from the minimum spanning tree, which leaves the
//! minimum spanning forest of the small clusters.

mod all;
mod as_printed;
mod borders;
mod branches;
mod connect;
mod extend;
mod forest;
mod graph;
mod ground;
mod group;
mod include;
mod open;
mod robust;
mod smooth;
mod stages;

pub(crate) use as_printed::link_as_printed;
pub(crate) use borders::borders;
pub(crate) use robust::{Segments, link_robust};
pub use stages::GraphStage;

#[cfg(test)]
mod tests;
