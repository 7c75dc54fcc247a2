//! How near a network comes to a known truth: as geometry (`score`) and as a graph (`isomorphism`).

mod isomorphism;
mod score;

pub use isomorphism::isomorphic;
pub use score::{Distances, Hits, Score, against};

#[cfg(test)]
mod tests;
