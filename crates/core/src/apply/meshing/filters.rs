//! The triangles that a mesh may have.

use crate::delaunay::{Facet, umbrella, usual_lengths};
use crate::math::vec3::distance;
use crate::parallel;
use crate::patch::Crossing;

/// Multiple of the usual length at its ends above which an edge is too long, as in the paper's second filter.
const LONG: f64 = 3.0;
/// Multiple of the usual length at its corners above which the sphere of a triangle is too wide: three points along a line are
/// no triangle.
const WIDE: f64 = 2.0;

/// A triangle, and whether it joins two sides of a line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidate {
    pub(super) facet: Facet,
    pub(super) across: bool,
}

/// The triangles without long edges and wide spheres, held against the edges of the umbrella filter.
pub(super) fn candidates(points: &[[f64; 3]], all: &[Facet], crossing: Option<&Crossing>) -> Vec<Candidate> {
    let gabriel: Vec<Facet> = all.iter().copied().filter(|f| f.gabriel).collect();
    let usual = usual_lengths(points, &umbrella(points.len(), &gabriel));
    let across = |i: usize, j: usize| crossing.is_some_and(|crossing| crossing.between(i, j));
    let may = parallel::map(all.len(), parallel::QUICK, |f| {
        let [a, b, c] = all[f].corners.map(|corner| corner as usize);
        let long = |i: usize, j: usize| distance(points[i], points[j]) > LONG * 0.5 * (usual[i] + usual[j]);
        let wide = all[f].radius > WIDE * (usual[a] + usual[b] + usual[c]) / 3.0;
        let may = !wide && !long(a, b) && !long(a, c) && !long(b, c);
        may.then(|| Candidate { facet: all[f], across: across(a, b) || across(a, c) || across(b, c) })
    });
    may.into_iter().flatten().collect()
}
