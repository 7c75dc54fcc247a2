//! Loops of a face on a plane: its surface unrolled, or seen from a pole, so that what lies to the left from outside does so there.

use super::Face;
use super::vertex::radial;
use crate::math::vec2;
use crate::math::vec3::{cross, dot, norm, sub};
use crate::patch::fit::Surface;
use std::f64::consts::{PI, TAU};

/// Share of a surface's size below which a point lies on its axis.
const ON_AXIS: f64 = 1e-9;

/// The places of the rows of points, each closed on itself, of a face on a plane, in the unit of the input; `None` where a row goes
/// round the surface, so that it bounds nothing there.
pub(super) fn unrolled(face: &Face, rows: &[Vec<[f64; 3]>]) -> Option<Vec<Vec<[f64; 2]>>> {
    rows.iter().map(|row| placed(face, row)).collect()
}

fn placed(face: &Face, row: &[[f64; 3]]) -> Option<Vec<[f64; 2]>> {
    let (first, second) = (face.first, cross(face.axis, face.first));
    let across = |p: [f64; 3]| [dot(p, first), dot(p, second)];
    match face.surface {
        Surface::Plane { point, .. } => Some(row.iter().map(|&p| across(sub(p, point))).collect()),
        Surface::Sphere { center, radius } => {
            // From the pole that lies across from the face.
            let second = cross(face.axis, first);
            let seen = |&p: &[f64; 3]| {
                let d = sub(p, center);
                let scale = 2.0 * radius / (radius - dot(d, first)).max(ON_AXIS * radius);
                [-scale * dot(d, second), scale * dot(d, face.axis)]
            };
            Some(row.iter().map(seen).collect())
        }
        Surface::Cone { apex, axis, .. } => {
            // The normal of a cone leans back along its axis, so that it is seen from behind.
            let flat: Vec<[f64; 2]> =
                row.iter().map(|&p| across(radial((apex, axis), p))).map(|[x, y]| [x, -y]).collect();
            let reach = flat.iter().map(|&p| vec2::dot(p, p).sqrt()).fold(0.0, f64::max);
            let through = flat.iter().any(|&p| vec2::dot(p, p).sqrt() <= ON_AXIS * reach);
            (through || turns(&flat)?.1.abs() < PI).then_some(flat)
        }
        Surface::Cylinder { point, axis, radius } => {
            let (angles, whole) = turns(&row.iter().map(|&p| across(sub(p, point))).collect::<Vec<_>>())?;
            let places = row.iter().zip(angles).map(|(&p, a)| [a * radius, dot(sub(p, point), axis)]);
            (whole.abs() < PI).then(|| places.collect())
        }
        Surface::Torus { center, axis, major, minor } => {
            let (long, round) = turns(&row.iter().map(|&p| across(sub(p, center))).collect::<Vec<_>>())?;
            let tube = |&p: &[f64; 3]| [norm(radial((center, axis), p)) - major, dot(sub(p, center), axis)];
            let (short, over) = turns(&row.iter().map(tube).collect::<Vec<_>>())?;
            let places = long.into_iter().zip(short).map(|(a, b)| [a * major, b * minor]);
            (round.abs() < PI && over.abs() < PI).then(|| places.collect())
        }
    }
}

/// The angles of a row of places about zero, without jumps and from the turn in which the least one is; and by how much the row turns in all.
fn turns(row: &[[f64; 2]]) -> Option<(Vec<f64>, f64)> {
    let begin = row.first()?;
    let mut angle = begin[1].atan2(begin[0]).rem_euclid(TAU);
    let mut angles = vec![angle];
    for pair in row.windows(2) {
        angle += vec2::cross(pair[0], pair[1]).atan2(vec2::dot(pair[0], pair[1]));
        angles.push(angle);
    }
    let whole = angle - angles[0];
    let least = angles.iter().copied().fold(f64::INFINITY, f64::min);
    // Rounding at the seam is no turn.
    let turn = TAU * ((least + ON_AXIS) / TAU).floor();
    Some((angles.into_iter().map(|a| a - turn).collect(), whole))
}

/// Twice the area of a closed row of places.
pub(super) fn area(row: &[[f64; 2]]) -> f64 {
    let from = row.first().copied().unwrap_or_default();
    row.windows(2).map(|w| vec2::cross(vec2::sub(w[0], from), vec2::sub(w[1], from))).sum()
}
