//! Flat places: cross-sections in which one nearly straight piece passes through the seed, and nothing else comes near it.

use super::Weighted;
use super::pieces::{Piece, Pieces};
use super::section::Section;
use crate::math::vec3::distance;

/// Distance within which the seed lies on a piece, in spacings.
const ON: f64 = 0.4;
/// How far the piece goes on to either side and in all, at least, in spacings, and the greatest turn over as much on either side,
/// radians.
const AROUND: (f64, f64) = (0.9, 2.4);
const TURN: f64 = 0.1;
/// Distance from the seed within which no other piece has a point, in spacings, and the least number of points of such a piece.
const CLEAR: f64 = 1.5;
const FEW: f64 = 8.0;

/// Whether a section with its corners shows that there is no crease at its seed.
pub(super) fn is_flat(section: &Section, pieces: &Pieces, corners: &[Weighted]) -> bool {
    let far = |c: &Weighted| distance(c.edgelet.place, section.origin) > CLEAR * section.unit;
    if !corners.iter().all(far) {
        return false;
    }
    let through = |p: &Piece| {
        let [from, to] = [-p.extent[0], p.extent[1]].map(|far| far.min(AROUND.1));
        let turn = 2.0 * p.curve.c[2] * (from + to);
        p.offset([0.0; 2]) <= ON && from.min(to) >= AROUND.0 && from + to >= AROUND.1 && turn.abs() <= TURN
    };
    let Some(own) = pieces.all.iter().position(|p| p.as_ref().is_some_and(through)) else { return false };
    let counts = |label: u32| pieces.all[label as usize].is_some_and(|p| p.count >= FEW);
    let other = |label: u32| label != own as u32 && counts(label);
    section.points.iter().zip(&pieces.label).all(|(p, &l)| !other(l) || p.raw[0].hypot(p.raw[1]) > CLEAR)
}
