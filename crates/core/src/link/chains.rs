//! Chains: edgelets joined to lines, and strips moved onto them. Ours.

mod apply;
mod chain;

pub(super) use apply::apply;
pub(super) use chain::chains;
