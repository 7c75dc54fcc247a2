//! Corners that one face does not reach: two pieces of a cross-section of which one comes up to the corner, while the other ends
//! a few spacings before it and nothing lies between.
//!
//! Far from a scanner its rows lie several spacings apart on the ground, and the row next to a wall hardly ever touches it.

use super::pieces::{Pieces, meet};
use super::section::{CENTRE, Section};

/// Least number of points of a piece.
const FEW: f64 = 8.0;
/// Greatest gap between the corner and the one piece, and the other, in spacings.
const GAP: (f64, f64) = (0.6, 3.0);

/// Passes every two pieces without a joint, with the place where they meet near the seed, to `take`.
pub(super) fn gaps(
    section: &Section,
    pieces: &Pieces,
    joined: impl Fn((u32, u32)) -> bool,
    mut take: impl FnMut((u32, u32), [f64; 2]),
) {
    let count = pieces.all.len() as u32;
    for pair in (0..count).flat_map(|a| (a + 1..count).map(move |b| (a, b))) {
        let of = |k: u32| pieces.all[k as usize].as_ref().filter(|p| p.count >= FEW);
        let (Some(p), Some(q)) = (of(pair.0), of(pair.1)) else { continue };
        if joined(pair) {
            continue;
        }
        let Some(place) = meet(p, q, [0.0; 2]) else { continue };
        let (p, q) = (p.offset(place), q.offset(place));
        let reached = p.min(q) <= GAP.0 && p.max(q) <= GAP.1;
        if reached && place[0].hypot(place[1]) <= CENTRE && free(section, pieces, pair, place) {
            take(pair, place);
        }
    }
}

/// Whether no other piece touches the ends of two pieces towards a corner, nor comes as near to it as they do.
fn free(section: &Section, pieces: &Pieces, pair: (u32, u32), corner: [f64; 2]) -> bool {
    let ends = [pair.0, pair.1].map(|k| nearest(section, pieces, corner, |label| label == k));
    let apart = |p: [f64; 2], q: [f64; 2]| (p[0] - q[0]).hypot(p[1] - q[1]);
    let piece = |label: u32| pieces.all[label as usize].is_some_and(|p| p.count >= FEW);
    let other = |label| label != pair.0 && label != pair.1 && piece(label);
    let far = ends.map(|end| apart(end, corner)).into_iter().fold(0.0, f64::max);
    let beside = ends.iter().map(|&end| apart(end, nearest(section, pieces, end, other)));
    apart(corner, nearest(section, pieces, corner, other)) > far
        && beside.fold(f64::INFINITY, f64::min) > GAP.0
}

/// The point of some pieces nearest to a place; far away if there is none.
fn nearest(section: &Section, pieces: &Pieces, place: [f64; 2], of: impl Fn(u32) -> bool) -> [f64; 2] {
    let points =
        section.points.iter().zip(&pieces.label).filter(|(_, label)| of(**label)).map(|(p, _)| p.raw);
    let far = |p: &[f64; 2]| (p[0] - place[0]).hypot(p[1] - place[1]);
    points.min_by(|p, q| far(p).total_cmp(&far(q))).unwrap_or([f64::INFINITY; 2])
}
