//! Two sides out of several, for faces narrower than a neighbourhood (robust form).
//!
//! At a chamfer or at the rim of a plate, one neighbourhood holds three faces and two creases, and the place nearest to all
//! three tangent planes lies on neither crease. Where that place is far from the planes, only the point's own face and the
//! nearest other one are taken.

use super::surroundings::Surroundings;
use crate::math::vec3::{distance2, dot, sub};

/// Greatest root mean square distance of the tangent planes of one crease from their common place, spacings; plus twice the
/// noise.
const ONE_CREASE: f64 = 0.2;
/// Greatest angle between the normals of one side.
const SAME_DEG: f64 = 20.0;
/// Greatest distance of the points of one side from its plane, spacings; plus twice the noise.
const SAME_PLANE: f64 = 0.35;

/// A point's own side and the nearest other one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair {
    normals: [[f64; 3]; 2],
    places: [[f64; 3]; 2],
    cosine: f64,
    plane: f64,
}

impl Pair {
    /// Whether a point with its normal lies on either side.
    pub(crate) fn holds(&self, place: [f64; 3], normal: [f64; 3]) -> bool {
        (0..2).any(|k| self.on_side(k, place, normal))
    }

    fn on_side(&self, k: usize, place: [f64; 3], normal: [f64; 3]) -> bool {
        dot(self.normals[k], normal).abs() >= self.cosine
            && dot(self.normals[k], sub(place, self.places[k])).abs() <= self.plane
    }
}

/// The two sides at point `i`; `None` if the tangent planes of `near` all pass near `foot`.
pub(crate) fn pair(surroundings: &Surroundings, i: usize, near: &[u32], foot: [f64; 3]) -> Option<Pair> {
    let (h, noise) = (surroundings.scales.at(i).unit(), surroundings.scales.at(i).noise);
    let normal = |j: usize| surroundings.normal(j);
    let place = |j: usize| surroundings.points[j];
    let (mut squares, mut total) = (0.0, 0.0);
    for j in near.iter().map(|&j| j as usize).chain([i]) {
        let weight = f64::from(surroundings.normals.support[j]);
        squares += weight * dot(normal(j), sub(foot, place(j))).powi(2);
        total += weight;
    }
    if squares <= total * (ONE_CREASE * h + 2.0 * noise).powi(2) {
        return None;
    }
    let own = normal(i);
    let cosine = SAME_DEG.to_radians().cos();
    let other = near.iter().map(|&j| j as usize).filter(|&j| dot(own, normal(j)).abs() < cosine).min_by(
        |&a, &b| distance2(place(a), place(i)).total_cmp(&distance2(place(b), place(i))).then(a.cmp(&b)),
    )?;
    Some(Pair {
        normals: [own, normal(other)],
        places: [place(i), place(other)],
        cosine,
        plane: SAME_PLANE * h + 2.0 * noise,
    })
}
