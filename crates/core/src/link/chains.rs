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
}

/// Has the lines follow chains of edgelets that are at least `length` spacings long.
pub(super) fn follow(lines: &mut LineGraph, edgelets: &[Edgelet], length: f64, scales: Scales) {
    if edgelets.is_empty() {
        return;
    }
    let at_least = |chains: Vec<Chain>, length: f64| -> Vec<Chain> {
        chains.into_iter().filter(|c| join::extent(&c.members) >= length * c.members[0].spacing).collect()
    };
    let chains = at_least(close::close(at_least(join::join(edgelets), SHORT)), length);
    snap::snap(lines, &chains, scales);
    add::add(lines, &chains);
}

#[cfg(test)]
mod tests;
