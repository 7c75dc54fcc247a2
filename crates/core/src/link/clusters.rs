//! Closed sharp feature lines from a graph of clusters (Demarsin et al. 2007, sections 2.3 to 2.8).
//!
//! Each vertex is a small cluster; the large clusters that it touches are kept beside it. Edges with a large cluster need no
//! place in the graph: they outweigh all others in the spanning tree and are removed from it, so the tree without them is
//! the minimum spanning forest of the small clusters.

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
