//! Colours of lines and nodes, and the tolerance for visible lines.

use super::picture::Colour;
use crate::evaluate::Verdict;
use crate::network::{NodeKind, StripKind};

/// Greatest depth of a visible line behind the surface, spacings.
pub(super) const LINE_BIAS: f64 = 2.5;

/// Lines that are not coloured.
pub(super) const BLACK: Colour = [0.08, 0.08, 0.10];

/// Colours from 0 to 1, dark violet over green to yellow, of even steps in lightness: five of the stops of viridis by van der Walt and
/// Smith, and straight lines between them.
pub(super) fn ramp(value: f32) -> Colour {
    const STOPS: [Colour; 5] = [
        [0.267, 0.005, 0.329],
        [0.229, 0.322, 0.546],
        [0.128, 0.567, 0.551],
        [0.369, 0.789, 0.383],
        [0.993, 0.906, 0.144],
    ];
    let at = value.clamp(0.0, 1.0) * (STOPS.len() - 1) as f32;
    let below = (at as usize).min(STOPS.len() - 2);
    let t = at - below as f32;
    std::array::from_fn(|c| STOPS[below][c] + (STOPS[below + 1][c] - STOPS[below][c]) * t)
}

/// Words, outlines and scale bars.
pub(super) const INK: Colour = [0.25, 0.27, 0.30];

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
