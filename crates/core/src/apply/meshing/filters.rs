//! The triangles that a mesh may have.

use crate::delaunay::{Facet, averages, umbrella};
use crate::math::vec3::distance;
use crate::parallel;
use crate::patch::Crossing;

/// Multiple of the average length at its ends above which an edge is too long, as in the paper's second filter.
const LONG: f64 = 3.0;

/// The triangles without long edges, the average length being that of the edges of the umbrella filter, and without those that
/// join two sides of a line.
pub(super) fn kept(points: &[[f64; 3]], all: Vec<Facet>, crossing: Option<&Crossing>) -> Vec<Facet> {
    let gabriel: Vec<Facet> = all.iter().copied().filter(|f| f.gabriel).collect();
    let usual = averages(points, &umbrella(points.len(), &gabriel));
    let may = parallel::map(all.len(), parallel::QUICK, |f| {
        let [a, b, c] = all[f].corners.map(|corner| corner as usize);
        let edge = |i: usize, j: usize| {
            let long = distance(points[i], points[j]) > LONG * 0.5 * (usual[i] + usual[j]);
            !long && !crossing.is_some_and(|crossing| crossing.between(i, j))
        };
        all[f].radius.is_finite() && edge(a, b) && edge(a, c) && edge(b, c)
    });
    all.into_iter().zip(may).filter(|(_, may)| *may).map(|(facet, _)| facet).collect()
}
