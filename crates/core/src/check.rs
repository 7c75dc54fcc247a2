//! Checks of the invariants of results, with which every test and fuzz target ends.

mod curve;
mod network;
mod nodes;
mod patches;
mod strips;
mod verdict;

pub use network::{network, sources};
pub use patches::patches;

#[cfg(test)]
pub(crate) mod perfect;
#[cfg(test)]
mod tests;
