//! Faces that their loops do not bound: loops that cross themselves or each other, go the wrong way round, or leave a side open. Other
//! programs call such faces invalid, and cannot cut, join or mesh them.

use super::edge::{gap_of, points};
use super::unroll::{area, unrolled};
use super::{Brep, Face};
use crate::math::vec2;
use crate::patch::fit::Surface;
use std::collections::BTreeSet;

/// Sine of an angle below which two places lie in one line.
const IN_LINE: f64 = 1e-9;

/// A closed row of places on a plane.
type Row = Vec<[f64; 2]>;

/// The patches of faces that their loops do not bound. Faces that all of theirs go round the other way look to their other side then: it
/// is the loops that say how faces hang together.
pub(super) fn tangled(found: &mut Brep) -> BTreeSet<u32> {
    let mut tangled = BTreeSet::new();
    for f in 0..found.faces.len() {
        let face = &found.faces[f];
        match sides(found, face) {
            None => _ = tangled.insert(face.patch),
            Some(outward) => found.faces[f].outward = outward,
        }
    }
    tangled
}

/// Whether the normal of a surface points outwards as its loops go; `None` if they bound nothing. Edges may cross by as much as they lie off
/// the surface: programs take places as near as that for one.
pub(super) fn sides(found: &Brep, face: &Face) -> Option<bool> {
    let rows: Vec<Vec<[f64; 3]>> = face.loops.iter().map(|row| along(found, row)).collect();
    let flat = unrolled(face, &rows)?;
    if crossed(&flat, gap_of(found, face)) {
        return None;
    }
    // On a sphere every loop can be the outer one.
    let free = flat.is_empty() || matches!(face.surface, Surface::Sphere { .. });
    if free { Some(face.outward) } else { turned(&flat) }
}

/// Points along a loop, in its direction.
fn along(found: &Brep, row: &[(u32, bool)]) -> Vec<[f64; 3]> {
    let of = |&(e, forward): &(u32, bool)| {
        let edge = &found.edges[e as usize];
        let mut own = points(&edge.shape, edge.ends.map(|v| found.vertices[v as usize]));
        if !forward {
            own.reverse();
        }
        own
    };
    row.iter().flat_map(of).collect()
}

/// Whether the outer one of some rows goes round to the left, and the others, which lie within it, to the right; or all the other way.
fn turned(rows: &[Row]) -> Option<bool> {
    let areas: Vec<f64> = rows.iter().map(|row| area(row)).collect();
    let outer = (0..rows.len()).max_by(|&a, &b| areas[a].abs().total_cmp(&areas[b].abs()))?;
    let hole = |i: usize| areas[i] * areas[outer] < 0.0 && rows[i].iter().any(|&p| within(p, &rows[outer]));
    let bounded = areas[outer] != 0.0 && (0..rows.len()).all(|i| i == outer || hole(i));
    bounded.then_some(areas[outer] > 0.0)
}

/// Whether a place lies within a closed row.
fn within(p: [f64; 2], row: &[[f64; 2]]) -> bool {
    let passes = |w: &&[[f64; 2]]| {
        let [a, b] = [w[0], w[1]];
        let share = (p[1] - a[1]) / (b[1] - a[1]);
        (a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + share * (b[0] - a[0])
    };
    row.windows(2).filter(passes).count() % 2 == 1
}

/// Whether any two pieces of the rows cross by more than `near`.
fn crossed(rows: &[Row], near: f64) -> bool {
    let mut pieces: Vec<[[f64; 2]; 2]> =
        rows.iter().flat_map(|row| row.windows(2)).map(|w| [w[0], w[1]]).collect();
    let least = |s: &[[f64; 2]; 2]| s[0][0].min(s[1][0]);
    pieces.sort_by(|a, b| least(a).total_cmp(&least(b)));
    (0..pieces.len()).any(|i| {
        let end = pieces[i][0][0].max(pieces[i][1][0]);
        pieces[i + 1..]
            .iter()
            .take_while(|other| least(other) <= end)
            .any(|&other| cross(pieces[i], other, near))
    })
}

/// Whether each of two pieces has its ends on both sides of the other, by more than rounding and `near`.
fn cross(a: [[f64; 2]; 2], b: [[f64; 2]; 2], near: f64) -> bool {
    parts(a, b, near) && parts(b, a, near)
}

fn parts([a, b]: [[f64; 2]; 2], ends: [[f64; 2]; 2], near: f64) -> bool {
    let along = vec2::sub(b, a);
    let length = vec2::dot(along, along).sqrt();
    let side = |p: [f64; 2]| {
        let d = vec2::sub(p, a);
        let off = vec2::cross(along, d) / length;
        let most = near + IN_LINE * vec2::dot(d, d).sqrt().max(length);
        if off.abs() > most { off.signum() } else { 0.0 }
    };
    side(ends[0]) * side(ends[1]) < 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn closed(row: &[[f64; 2]]) -> Row {
        row.iter().chain(&row[..1]).copied().collect()
    }

    fn square(low: f64, high: f64) -> Row {
        closed(&[[low, low], [high, low], [high, high], [low, high]])
    }

    #[test]
    fn loops_bound_a_face_if_they_lie_in_the_outer_one_and_go_round_the_other_way() {
        let back = |row: Row| row.into_iter().rev().collect::<Row>();
        assert_eq!(turned(&[square(0.0, 9.0), back(square(2.0, 3.0))]), Some(true));
        assert_eq!(turned(&[square(2.0, 3.0), back(square(0.0, 9.0))]), Some(false));
        assert_eq!(turned(&[square(0.0, 9.0), square(2.0, 3.0)]), None);
        assert_eq!(turned(&[square(0.0, 9.0), back(square(12.0, 13.0))]), None);
    }

    #[test]
    fn loops_that_cross_are_told_from_those_that_touch() {
        assert!(crossed(&[closed(&[[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0]])], 0.0));
        assert!(crossed(&[square(0.0, 4.0), square(3.0, 5.0)], 0.0));
        assert!(!crossed(&[square(0.0, 4.0), square(4.0, 5.0)], 0.0));
        assert!(!crossed(&[square(0.0, 4.0), square(1.0, 2.0)], 0.0));
        assert!(!crossed(&[square(0.0, 4.0), square(3.99, 5.0)], 0.02));
    }
}
