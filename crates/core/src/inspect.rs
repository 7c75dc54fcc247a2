//! What a network shows, as a list for people: holes and bosses with their tolerances, other circles and arcs, straight edges.
//!
//! A hole is told by its rims (`rims`): one where it is blind and its floor was not found, two where a wall leads from one to the
//! other (`round`). Figures of two rims are combined by their variances.

mod edges;
mod rims;
mod ring;
mod round;

pub use edges::StraightEdge;
pub use rims::{Rim, RimSide, rims};
pub use ring::RoundSigma;
pub use round::{RoundFeature, RoundKind};

use crate::network::Network;

/// The list of a network.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inspection {
    /// Holes, bosses, circles and arcs: by their kind, then by their diameter, greatest first; arcs that are open come after the others.
    pub rounds: Vec<RoundFeature>,
    /// Straight edges, the longest first.
    pub edges: Vec<StraightEdge>,
}

/// The list of a network. `points` are those on surfaces, `(N, 3)` f64, world frame, finite, which tell a hole from a boss; `spacing` is
/// theirs. Without points circles have no name.
pub fn inspect(network: &Network, points: &[[f64; 3]], spacing: f64) -> Inspection {
    let network = &network.on_surface();
    let sides = rims(&network.strips, points, spacing);
    Inspection { rounds: round::rounds(network, &sides, spacing), edges: edges::edges(network) }
}

#[cfg(test)]
mod tests;
