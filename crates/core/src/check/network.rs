//! The invariants of a network.

use super::verdict::verdict;
use super::{curve, nodes, strips};
use crate::network::Network;

/// Checks every invariant of a [`Network`].
///
/// Nodes: finite positions, no two the same, degrees that count the strip ends, kinds that follow from the degrees.
/// Strips: node indices in range, none exactly when closed; finite points, at least 2 (3 if closed), no two in a row the
/// same, the first of a loop not repeated, ends on their nodes bit for bit; no strip twice; deviation finite and not
/// negative, confidence from 0 to 1; no source twice in a row. Curves: number and order of the knots as documented at
/// [`BSpline`], finite controls, periodic exactly when the strip is closed, clamped ends on the nodes to 1e-9 of the strip's
/// extent.
///
/// [`BSpline`]: crate::curve::BSpline
///
/// # Errors
/// One sentence for each violation, naming the node or strip.
pub fn network(network: &Network) -> Result<(), Vec<String>> {
    let mut faults = nodes::faults(network);
    for (i, strip) in network.strips.iter().enumerate() {
        let named = strips::faults(network, strip).into_iter().chain(curve::faults(network, strip));
        faults.extend(named.map(|fault| format!("strip {i}: {fault}")));
    }
    faults.extend(strips::twins(network));
    verdict(faults)
}

/// Checks that every source of a network is a point of a cloud of `points` points.
///
/// # Errors
/// One sentence for each violation.
pub fn sources(network: &Network, points: usize) -> Result<(), Vec<String>> {
    let beyond = |source: u32| source as usize >= points;
    let mut faults = Vec::new();
    for (i, node) in network.nodes.iter().enumerate().filter(|(_, n)| beyond(n.source)) {
        faults.push(format!("node {i}: source {} of {points} points", node.source));
    }
    for (i, strip) in network.strips.iter().enumerate() {
        let bad = strip.sources.iter().filter(|&&s| beyond(s));
        faults.extend(bad.map(|s| format!("strip {i}: source {s} of {points} points")));
    }
    verdict(faults)
}
