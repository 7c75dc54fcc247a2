//! Chains of edgelets, and the strips of the spanning graph where no chain is: ours.
//!
//! Cross-sections that pool many points place a crease better than single points do, and tell the sides of narrow faces, which
//! points by themselves cannot. So chains come first. `join` links edgelets to chains, `close` joins chains that continue each other,
//! and `double` leaves the longest of those along one crease. `rings` keeps strips whole that are closed, `meet` leads the ends
//! of chains on to corners, and `overlay` takes over the pieces of strips that lie beside no chain.

mod chain;
mod close;
mod crossing;
mod double;
mod folds;
mod graph;
mod join;
mod meet;
mod onward;
mod overlay;
mod rings;
mod samples;

pub(crate) use folds::Known;
pub(super) use folds::lay;

use crate::measure::Edgelet;
use crate::neighbors::Index;
use crate::pattern::LineGraph;
use crate::surface::Scales;

/// Least length of a chain that may be continued by others, in spacings.
const SHORT: f64 = 2.0;

/// The chains of edgelets that are at least `length` spacings long and show the `evidence`, and where there is none the `strips`.
pub(super) fn chains(
    mut strips: LineGraph,
    edgelets: &[Edgelet],
    length: f64,
    evidence: f64,
    scales: Scales,
) -> LineGraph {
    let mut chains = join::join(edgelets);
    chains.retain(|c| c.longest >= SHORT);
    let mut chains = close::close(chains);
    // Chains that were too short by themselves take more, all together, as there are many to choose from.
    chains.retain(|c| c.longest >= length || c.extent() >= 2.0 * length * c.members[0].spacing);
    chains.retain(|c| c.evidence() >= evidence);
    let mut chains = double::remove(&chains);
    if chains.is_empty() {
        return strips;
    }
    let closed = rings::take(&mut strips, &mut chains, scales);
    let mut graph = graph::Graph::new(&chains);
    meet::meet(&mut graph);
    overlay::overlay(graph, &strips, &closed, scales)
}

/// The design edges of blends that are at least `length` spacings long and show the `evidence`, and their edgelets.
pub(super) fn rounded(
    blends: &[Edgelet],
    length: f64,
    evidence: f64,
    points: &[[f64; 3]],
    scales: Scales,
) -> (LineGraph, Vec<Edgelet>) {
    let mut chains = join::join(blends);
    chains.retain(|c| c.longest >= SHORT);
    let mut chains = close::close(chains);
    chains.retain(|c| c.extent() >= length * c.members[0].spacing && c.evidence() >= evidence);
    let mut chains = double::remove(&chains);
    onward::lead(&mut chains, points, &Index::build(points), scales);
    let mut graph = graph::Graph::new(&chains);
    let edgelets = chains.into_iter().flat_map(|c| c.members).collect();
    meet::meet(&mut graph);
    (graph.lines, edgelets)
}

#[cfg(test)]
mod tests;
