//! Colours of points, lines and nodes, and the tolerance for visible lines.

use super::picture::{Colour, WHITE};
use crate::evaluate::Verdict;
use crate::measure::Class;
use crate::network::{NodeKind, StripKind};
use crate::patch::NO_PATCH;

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
        StripKind::Rounded => [0.55, 0.30, 0.62],
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

/// Turn of the hue from patch to patch: the golden section of the circle, so that neighbours in number differ.
const TURN: f32 = 0.618_034;

/// The tint of a point of a class: white on no line; red, green and blue from 0 to 1.
pub fn class_tint(class: Class) -> [f32; 3] {
    match class {
        Class::Smooth => WHITE,
        Class::Crease => [0.95, 0.35, 0.20],
        Class::Border => [0.25, 0.60, 0.98],
        Class::Corner => [0.10, 0.75, 0.55],
        Class::Clutter => [0.66, 0.45, 0.85],
    }
}

/// The tint of a point of a score: white (0) to red (1); white where there is no score.
pub fn score_tint(score: f32) -> [f32; 3] {
    let share = if score.is_finite() { score.clamp(0.0, 1.0) } else { 0.0 };
    [1.0 - 0.1 * share, 1.0 - 0.75 * share, 1.0 - 0.85 * share]
}

/// The tint of a point of a patch: a pale hue for each; white for [`NO_PATCH`].
pub fn patch_tint(label: u32) -> [f32; 3] {
    if label == NO_PATCH {
        return WHITE;
    }
    let hue = (label as f32 * TURN).fract() * 6.0;
    [0.0, 4.0, 2.0].map(|shift| {
        let share = (((hue + shift) % 6.0 - 3.0).abs() - 1.0).clamp(0.0, 1.0);
        0.55 + 0.45 * share
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patches_of_neighbouring_numbers_have_different_tints() {
        let apart = |a: u32, b: u32| {
            let (a, b) = (patch_tint(a), patch_tint(b));
            (0..3).map(|c| (a[c] - b[c]).abs()).fold(0.0, f32::max)
        };
        assert!((0..30).all(|i| apart(i, i + 1) > 0.2 && apart(i, i + 2) > 0.1));
        assert_eq!((patch_tint(NO_PATCH), score_tint(f32::NAN)), (WHITE, WHITE));
    }
}
