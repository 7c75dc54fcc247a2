//! The triangles of the Delaunay tetrahedra.
//!
//! A triangle belongs to the Gabriel complex if no fourth point lies in its least circumsphere. The paper finds this by the
//! tetrahedra at the triangle: the centre of the circumsphere of one lies on the same side as its fourth point, the centres of
//! two on different sides. A fourth point has the centre on its side exactly if it lies outside the least circumsphere; this form
//! of the test is used here, as it also holds for flat tetrahedra, whose circumspheres have no centre to speak of.

use super::triangle::Triangle;
use crate::math::vec3::{add, add_scaled, cross, dot, scale, sub};
use crate::parallel;

/// A triangle of the tetrahedra.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Facet {
    /// Its corners, ascending.
    pub(crate) corners: Triangle,
    /// Radius of the least sphere through its corners that holds no other point.
    pub(crate) radius: f64,
    /// Whether that is its least circumsphere.
    pub(crate) gabriel: bool,
}

/// All triangles, ascending by their corners.
pub(crate) fn facets(points: &[[f64; 3]], tetrahedra: &[[u32; 4]]) -> Vec<Facet> {
    let mut all: Vec<(Triangle, u32)> = Vec::with_capacity(4 * tetrahedra.len());
    for t in tetrahedra {
        for k in 0..4 {
            let mut corners = [t[(k + 1) % 4], t[(k + 2) % 4], t[(k + 3) % 4]];
            corners.sort_unstable();
            all.push((corners, t[k]));
        }
    }
    all.sort_unstable();
    let first: Vec<usize> = (0..all.len()).filter(|&i| i == 0 || all[i - 1].0 != all[i].0).collect();
    parallel::map(first.len(), parallel::QUICK, |f| {
        let end = first.get(f + 1).copied().unwrap_or(all.len());
        facet(points, &all[first[f]..end])
    })
}

/// One triangle from its tetrahedra, each by its fourth point.
fn facet(points: &[[f64; 3]], at: &[(Triangle, u32)]) -> Facet {
    let corners = at[0].0;
    let [a, b, c] = corners.map(|i| points[i as usize]);
    let Some((centre, normal, radius)) = circle(a, b, c) else {
        return Facet { corners, radius: f64::INFINITY, gabriel: false };
    };
    let mut shift: f64 = 0.0;
    let mut gabriel = true;
    for &(_, fourth) in at {
        let d = sub(points[fourth as usize], centre);
        let power = dot(d, d) - radius * radius;
        if power < 0.0 {
            gabriel = false;
            // The centre moves along the axis until the fourth point lies on the sphere.
            shift = shift.max((power / (2.0 * dot(d, normal))).abs());
        }
    }
    Facet { corners, radius: (radius * radius + shift * shift).sqrt(), gabriel }
}

/// Centre, unit normal and radius of the circle through three points; `None` if they lie on a line.
fn circle(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> Option<([f64; 3], [f64; 3], f64)> {
    let (u, v) = (sub(b, a), sub(c, a));
    let n = cross(u, v);
    let square = dot(n, n);
    let from_a = add(scale(cross(v, n), dot(u, u)), scale(cross(n, u), dot(v, v)));
    let arm = scale(from_a, 0.5 / square);
    let radius = dot(arm, arm).sqrt();
    radius.is_finite().then(|| (add_scaled(a, arm, 1.0), scale(n, 1.0 / square.sqrt()), radius))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_with_a_point_in_its_least_circumsphere_is_not_gabriel() {
        let triangle = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]];
        for (fourth, gabriel, radius) in [
            ([1.0, 1.0, 0.5], false, 2.25f64),
            ([1.0, 1.0, 3.0], true, 2f64.sqrt()),
            ([3.0, 3.0, 0.1], true, 2f64.sqrt()),
        ] {
            let points = [triangle[0], triangle[1], triangle[2], fourth];
            let all = facets(&points, &[[0, 1, 2, 3]]);
            assert_eq!(all.len(), 4);
            assert_eq!((all[0].corners, all[0].gabriel), ([0, 1, 2], gabriel), "{fourth:?}");
            // The sphere through all four points, or the least one.
            assert!((all[0].radius - radius).abs() < 1e-9, "{:?}", all[0]);
        }
    }
}
