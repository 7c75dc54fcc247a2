//! Evaluation of a network against a known truth: its geometry (`score`) and its graph (`isomorphism`).

mod isomorphism;
mod score;

pub use isomorphism::isomorphic;
pub use score::{Distances, Hits, Score, against};

#[cfg(test)]
mod tests;
