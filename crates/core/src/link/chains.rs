//! Chains of edgelets, and the strips of the spanning graph where no chain is: ours.
//!
//! Cross-sections that pool many points place a crease better than single points do, and tell the sides of narrow faces, which
//! points by themselves cannot. So chains come first. `join` links edgelets to chains, `close` joins chains that continue each other,
//! `meet` leads their ends on to corners, and `overlay` takes over the pieces of strips that lie beside no chain.

mod close;
mod crossing;
mod graph;
mod join;
mod meet;
mod overlay;
mod samples;

use crate::measure::Edgelet;
use crate::pattern::LineGraph;
use crate::surface::Scales;
use graph::Graph;

/// Least length of a chain that may be continued by others, in spacings.
const SHORT: f64 = 2.0;

/// Edgelets that follow each other along a crease; the last is joined to the first if `closed`.
#[derive(Clone, Debug)]
struct Chain {
    members: Vec<Edgelet>,
    closed: bool,
    /// Length in spacings of the longest of the chains that it was made of.
    longest: f64,
}

/// The chains of edgelets that are at least `length` spacings long and show the `evidence`, and where there is none the `strips`.
pub(super) fn chains(
    strips: LineGraph,
    edgelets: &[Edgelet],
    length: f64,
    evidence: f64,
    scales: Scales,
) -> LineGraph {
    let mut chains = join::join(edgelets);
    chains.retain(|c| c.longest >= SHORT);
    let mut chains = close::close(chains);
    // Chains that were too short by themselves take more, all together, as there are many to choose from.
    chains.retain(|c| c.longest >= length || join::extent(&c.members) >= 2.0 * length * c.members[0].spacing);
    chains.retain(|c| shown(c) >= evidence);
    if chains.is_empty() {
        return strips;
    }
    let mut graph = Graph::new(&chains);
    meet::meet(&mut graph);
    overlay::overlay(graph, &strips, scales)
}

/// The evidence of a chain: that of an edgelet, as many times as edgelets along it rest on points of their own.
fn shown(chain: &Chain) -> f64 {
    let seen = || chain.members.iter().filter(|e| e.evidence > 0.0);
    let count = seen().count() as f64;
    let mean = |of: fn(&Edgelet) -> f64| seen().map(of).sum::<f64>() / count;
    mean(|e| e.evidence) * (join::extent(&chain.members) / mean(|e| e.reach)).max(1.0)
}

#[cfg(test)]
mod tests;
