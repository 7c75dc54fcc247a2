//! The triangles that a mesh may have.

use crate::delaunay::{Facet, Triangle, umbrella};
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

/// The triangles without long edges and wide spheres. The usual length of an edge at a point is the median of those of the
/// umbrella filter, not their average as in the paper: at the rim of a hole that the umbrellas close, the long edges over it would
/// pass as usual.
pub(super) fn candidates(points: &[[f64; 3]], all: &[Facet], crossing: Option<&Crossing>) -> Vec<Candidate> {
    let gabriel: Vec<Facet> = all.iter().copied().filter(|f| f.gabriel).collect();
    let usual = medians(points, &umbrella(points.len(), &gabriel));
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

/// `(N)` median length of the edges at each point; infinite without any, as nothing is known there.
fn medians(points: &[[f64; 3]], triangles: &[Triangle]) -> Vec<f64> {
    let mut at: Vec<Vec<f64>> = vec![Vec::new(); points.len()];
    for &[a, b, c] in triangles {
        // An edge of two triangles counts twice at both of its ends.
        for [i, j] in [[a, b], [a, c], [b, c]].map(|edge| edge.map(|end| end as usize)) {
            let length = distance(points[i], points[j]);
            at[i].push(length);
            at[j].push(length);
        }
    }
    let median = |mut lengths: Vec<f64>| match lengths.len() {
        0 => f64::INFINITY,
        count => *lengths.select_nth_unstable_by(count / 2, f64::total_cmp).1,
    };
    at.into_iter().map(median).collect()
}
