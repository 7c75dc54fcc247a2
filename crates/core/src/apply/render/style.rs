//! Colours of lines and nodes, and when they count as seen.

use super::picture::Colour;
use crate::network::{NodeKind, StripKind};

/// Spacings that a line may lie behind the surface and still be seen.
pub(super) const LINE_BIAS: f64 = 2.5;

/// The colour of a kind of line; told apart by the colour-blind too.
pub(super) fn strip_colour(kind: StripKind) -> Colour {
    match kind {
        StripKind::Crease => [0.80, 0.20, 0.02],
        StripKind::Border => [0.00, 0.36, 0.72],
    }
}

/// The colour of a kind of node.
pub(super) fn node_colour(kind: NodeKind) -> Colour {
    match kind {
        NodeKind::Junction => [0.08, 0.08, 0.10],
        NodeKind::Corner => [0.00, 0.56, 0.42],
        NodeKind::End => [0.82, 0.32, 0.62],
        NodeKind::Apex => [0.90, 0.62, 0.00],
    }
}
