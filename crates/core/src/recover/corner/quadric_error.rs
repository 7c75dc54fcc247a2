//! The corner of planes: the place of least squared distance from all of them, the quadric error metric of M. Garland and P. S.
//! Heckbert ("Surface simplification using quadric error metrics", 1997; Gumhold 2001, section 4.2).
//!
//! Each plane counts by the inverse of its variance, so that the covariance of the corner is the inverse of the same matrix. A weak
//! prior holds the corner where it was, along directions that the planes leave open.

use crate::math::least_squares::{inverse, solve};
use crate::math::vec3::{add_scaled, norm};

/// Standard deviation of a corner before its planes are known, units of the place.
const PRIOR: f64 = 1.0;
/// How far a corner may move, units of the place.
const FAR: f64 = 2.0;

/// A plane at a corner.
#[derive(Clone, Copy, Debug)]
pub(in crate::recover) struct Facet {
    /// Unit normal.
    pub normal: [f64; 3],
    /// Offset of the place that was taken for the corner from the plane, along the normal.
    pub offset: f64,
    /// Variance of the plane's place there.
    pub variance: f64,
}

/// A recovered corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::recover) struct Corner {
    /// Local frame.
    pub at: [f64; 3],
    /// Covariance of the place.
    pub covariance: [[f64; 3]; 3],
}

/// The place of least quadric error. `share` is the weight of a plane: less than one where several stand for the same face.
pub(in crate::recover) fn corner(at: [f64; 3], facets: &[Facet], share: f64, unit: f64) -> Option<Corner> {
    if facets.len() < 2 {
        return None;
    }
    let held = 1.0 / (PRIOR * unit).powi(2);
    let (mut matrix, mut right) = ([[0.0; 3]; 3], [0.0; 3]);
    (0..3).for_each(|i| matrix[i][i] = held);
    for f in facets {
        let weight = share / f.variance;
        for i in 0..3 {
            (0..3).for_each(|j| matrix[i][j] += weight * f.normal[i] * f.normal[j]);
            right[i] -= weight * f.normal[i] * f.offset;
        }
    }
    let step = solve(matrix, right)?;
    let covariance = inverse(matrix)?;
    (norm(step) <= FAR * unit).then(|| Corner { at: add_scaled(at, step, 1.0), covariance })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::vec3::{distance, dot, sub, unit};

    #[test]
    fn planes_through_a_point_have_it_as_their_corner_and_four_are_settled_by_least_squares() {
        let (truth, start) = ([0.3, -0.2, 0.1], [0.0; 3]);
        let normals = [[1.0, 0.2, 0.0], [-0.1, 1.0, 0.3], [0.2, 0.1, 1.0], [1.0, 1.0, 1.0]].map(unit);
        let facet = |normal, error: f64| Facet {
            normal,
            offset: dot(normal, sub(start, truth)) + error,
            variance: 1e-6,
        };
        for count in [3, 4] {
            let facets: Vec<Facet> = normals[..count].iter().map(|&n| facet(n, 0.0)).collect();
            let found = corner(start, &facets, 1.0, 1.0).unwrap();
            assert!(distance(found.at, truth) < 1e-5, "{found:?}");
        }
        let off: Vec<Facet> =
            normals.iter().zip([1e-3, -1e-3, 1e-3, -1e-3]).map(|(&n, e)| facet(n, e)).collect();
        assert!(distance(corner(start, &off, 1.0, 1.0).unwrap().at, truth) < 4e-3);
    }

    #[test]
    fn two_planes_move_a_corner_onto_their_line_and_not_along_it() {
        let facet = |normal, offset| Facet { normal, offset, variance: 1e-8 };
        let facets = [facet([1.0, 0.0, 0.0], 0.5), facet([0.0, 1.0, 0.0], -0.25)];
        let found = corner([0.0, 0.0, 7.0], &facets, 1.0, 1.0).unwrap();
        assert!(distance(found.at, [-0.5, 0.25, 7.0]) < 1e-6, "{found:?}");
        assert!(found.covariance[2][2] > 0.9 && found.covariance[0][0] < 1e-7);
        assert_eq!(corner([0.0; 3], &facets[..1], 1.0, 1.0), None);
    }
}
