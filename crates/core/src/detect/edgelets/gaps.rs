//! Corners that no point reaches: two pieces of a cross-section that would meet if they went on, where the gap before the corner is
//! no wider than others on the same face.
//!
//! Far from a scanner its rows lie several spacings apart on the ground, and the row next to a wall hardly ever touches it.

use super::corners::{CENTRE, arm, meet};
use super::field::Field;
use super::pieces::{Piece, Pieces};
use super::section::Section;
use crate::math::vec3::{add_scaled, dot, sub};

/// Least number of points of a piece.
const FEW: f64 = 8.0;
/// Gap before a corner that asks no more of a face, and the greatest, in spacings.
const NARROW: f64 = 0.6;
const WIDEST: f64 = 3.0;
/// Greatest gap before a corner, in the widest of the face.
const SAME: f64 = 1.2;
/// Extent of a face that is searched for gaps, away from the corner and to either side along the line, in spacings.
const FACE: (f64, f64) = (9.0, 4.0);
/// Greatest distance of its points from the piece as it goes on, in spacings, and what a spacing of noise and of distance add.
const OFF: (f64, f64, f64) = (0.2, 2.0, 0.05);

/// Passes every two pieces without a joint, with the place where they meet near the seed, to `take`.
pub(super) fn gaps(
    field: &Field,
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
        let near = place[0].hypot(place[1]) <= CENTRE && p.offset(place).max(q.offset(place)) <= WIDEST;
        let reaches = |p: &Piece| reaches(field, section, p, place);
        if near && free(section, pieces, pair, place) && reaches(p) && reaches(q) {
            take(pair, place);
        }
    }
}

/// Whether the gap between a piece and a corner is no wider than others on its face.
fn reaches(field: &Field, section: &Section, piece: &Piece, corner: [f64; 2]) -> bool {
    let gap = piece.offset(corner);
    gap <= NARROW || gap <= SAME * widest(field, section, piece, corner)
}

/// The widest gap between rows of points on the face of a piece, in spacings; none where it is crowded.
fn widest(field: &Field, section: &Section, piece: &Piece, corner: [f64; 2]) -> f64 {
    let at = add_scaled(section.origin, section.in_space(corner), section.unit);
    let [x, y] = arm(piece, corner);
    let [out, up] = [[x, y], [-y, x]].map(|axis| section.in_space(axis));
    let (far, aside) = FACE;
    let (off, noisy, sloped) = OFF;
    let mut rows: Vec<f64> = Vec::new();
    let all = field.around(at, far, section.unit, |f| {
        let d = sub(field.points[f.index as usize], at).map(|x| x / section.unit);
        let u = dot(d, out);
        let on = dot(d, up).abs() <= off + noisy * section.noise + sloped * u.abs();
        if on && u > 0.0 && dot(d, section.axes[0]).abs() <= aside {
            rows.push(u);
        }
    });
    rows.sort_unstable_by(f64::total_cmp);
    if all { rows.windows(2).map(|w| w[1] - w[0]).fold(0.0, f64::max) } else { 0.0 }
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
        && beside.fold(f64::INFINITY, f64::min) > NARROW
}

/// The point of some pieces nearest to a place; far away if there is none.
fn nearest(section: &Section, pieces: &Pieces, place: [f64; 2], of: impl Fn(u32) -> bool) -> [f64; 2] {
    let points =
        section.points.iter().zip(&pieces.label).filter(|(_, label)| of(**label)).map(|(p, _)| p.raw);
    let far = |p: &[f64; 2]| (p[0] - place[0]).hypot(p[1] - place[1]);
    points.min_by(|p, q| far(p).total_cmp(&far(q))).unwrap_or([f64::INFINITY; 2])
}
