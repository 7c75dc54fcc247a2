//! Colours of lines and nodes, and the tolerance for visible lines.

use super::picture::Colour;
use crate::evaluate::Verdict;
use crate::network::{NodeKind, StripKind};

/// Greatest depth of a visible line behind the surface, spacings.
pub(super) const LINE_BIAS: f64 = 2.5;

/// The colour of a kind of line; colour-blind people can tell them apart too.
pub(super) fn strip_colour(kind: StripKind) -> Colour {
    match kind {
        StripKind::Crease => [0.80, 0.20, 0.02],
        StripKind::Border => [0.00, 0.36, 0.72],
    }
}

/// The colour of the outlines of sections.
pub(super) const SLICE_COLOUR: Colour = [0.10, 0.50, 0.29];

/// The colour of a kind of node.
pub(super) fn node_colour(kind: NodeKind) -> Colour {
    match kind {
        NodeKind::Junction => [0.08, 0.08, 0.10],
        NodeKind::Corner => [0.00, 0.56, 0.42],
        NodeKind::End => [0.82, 0.32, 0.62],
        NodeKind::Apex => [0.90, 0.62, 0.00],
    }
}

/// The colour of a verdict on a line.
pub(super) fn verdict_colour(verdict: Verdict) -> Colour {
    match verdict {
        Verdict::Right => [0.30, 0.32, 0.35],
        Verdict::Missed => [0.84, 0.30, 0.00],
        Verdict::False => [0.00, 0.40, 0.80],
    }
}
