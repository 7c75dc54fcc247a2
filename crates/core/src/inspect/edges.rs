//! The straight edges of a network.

use crate::curve::pieces::{Shape, Sigma};
use crate::math::vec3::{distance, sub, unit};
use crate::network::{Network, StripKind};

/// A straight edge.
#[derive(Clone, Debug, PartialEq)]
pub struct StraightEdge {
    /// The strip that it is, or is part of.
    pub strip: usize,
    /// Crease or border.
    pub kind: StripKind,
    /// Its ends, world frame.
    pub ends: [[f64; 3]; 2],
    /// From the first end to the second.
    pub direction: [f64; 3],
    /// Its length.
    pub length: f64,
    /// Angle between the faces along the strip, degrees; `None` for borders, and where it is not known.
    pub fold_deg: Option<f64>,
    /// Standard deviation across the edge, and of its direction in degrees, in either direction; `None` where they are not known.
    pub sigma: Option<[f64; 2]>,
}

/// The straight edges, the longest first.
pub(super) fn edges(network: &Network) -> Vec<StraightEdge> {
    let mut all = Vec::new();
    for (strip, of) in network.strips.iter().enumerate() {
        for piece in of.curves.iter().filter(|p| p.shape == Shape::Line) {
            let sigma = match piece.sigma {
                Some(Sigma::Line { offset, direction }) => Some([offset, direction.to_degrees()]),
                _ => None,
            };
            all.push(StraightEdge {
                strip,
                kind: of.kind,
                ends: [piece.from, piece.to],
                direction: unit(sub(piece.to, piece.from)),
                length: distance(piece.from, piece.to),
                fold_deg: of.fold_deg,
                sigma,
            });
        }
    }
    all.sort_by(|a, b| b.length.total_cmp(&a.length).then(a.strip.cmp(&b.strip)));
    all
}
