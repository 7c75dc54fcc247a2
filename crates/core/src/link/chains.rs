//! Chains of edgelets beside the strips: ours.
//!
//! `join` links edgelets to chains. A strip beside a chain is moved onto it (`snap`), as cross-sections that pool many points place
//! a crease better than single points do; stretches that no strip follows become strips of their own (`add`): the sides of narrow
//! faces above all, which points by themselves cannot tell.

mod add;
mod join;
mod samples;
mod snap;

use crate::measure::Edgelet;
use crate::pattern::LineGraph;
use crate::surface::Scales;

/// Edgelets that follow each other along a crease; the last is joined to the first if `closed`.
#[derive(Clone, Debug)]
struct Chain<'a> {
    members: Vec<&'a Edgelet>,
    closed: bool,
}

/// Has the lines follow chains of edgelets that are at least `length` spacings long.
pub(super) fn follow(lines: &mut LineGraph, edgelets: &[Edgelet], length: f64, scales: Scales) {
    if edgelets.is_empty() {
        return;
    }
    let chains = join::join(edgelets, length);
    snap::snap(lines, &chains, scales);
    add::add(lines, &chains);
}
