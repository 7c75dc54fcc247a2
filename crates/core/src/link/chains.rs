//! Chains of edgelets beside the strips: ours.
//!
//! `join` links edgelets to chains, and `close` joins chains that continue each other. A strip beside a chain is moved onto it
//! (`snap`), as cross-sections that pool many points place a crease better than single points do; stretches that no strip follows
//! become strips of their own (`add`): the sides of narrow faces above all, which points by themselves cannot tell.

mod add;
mod close;
mod join;
mod samples;
mod snap;

use crate::measure::Edgelet;
use crate::pattern::LineGraph;
use crate::surface::Scales;

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

/// Has the lines follow chains of edgelets that are at least `length` spacings long and show the `evidence`.
pub(super) fn follow(
    lines: &mut LineGraph,
    edgelets: &[Edgelet],
    length: f64,
    evidence: f64,
    scales: Scales,
) {
    if edgelets.is_empty() {
        return;
    }
    let mut chains = join::join(edgelets);
    chains.retain(|c| c.longest >= SHORT);
    let mut chains = close::close(chains);
    // Chains that were too short by themselves take more, all together, as there are many to choose from.
    chains.retain(|c| c.longest >= length || join::extent(&c.members) >= 2.0 * length * c.members[0].spacing);
    chains.retain(|c| shown(c) >= evidence);
    snap::snap(lines, &chains, scales);
    add::add(lines, &chains, scales);
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
