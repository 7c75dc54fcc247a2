//! Shared parts of the least-squares fits of B-splines: chord-length parameters and the rows of the normal equations.

use super::bspline::{BSpline, MAX_DEGREE};
use crate::math::points::distance;

/// Chord-length parameters from zero, and the total length.
pub(super) fn chord_lengths<const D: usize>(points: &[[f64; D]], closed: bool) -> (Vec<f64>, f64) {
    let mut length = 0.0;
    let mut parameters = Vec::with_capacity(points.len());
    for (i, &p) in points.iter().enumerate() {
        if i > 0 {
            length += distance(points[i - 1], p);
        }
        parameters.push(length);
    }
    if let (true, Some(&first), Some(&last)) = (closed, points.first(), points.last()) {
        length += distance(first, last);
    }
    (parameters, length)
}

/// The control points with influence at a parameter, with their weights; `degree + 1` of them count.
pub(super) fn terms<const D: usize>(curve: &BSpline<D>, t: f64) -> [(usize, f64); MAX_DEGREE + 1] {
    let (controls, weights) = curve.basis(t);
    std::array::from_fn(|k| (controls[k], weights[k]))
}

/// Adds the row `sum of terms = target` to the normal equations: to the right side directly, and to the matrix by one call of
/// `add(i, j, x)` for each pair of terms.
pub(super) fn add_row<const D: usize>(
    terms: &[(usize, f64)],
    target: [f64; D],
    weight: f64,
    right: &mut [[f64; D]],
    mut add: impl FnMut(usize, usize, f64),
) {
    for (n, &(i, a)) in terms.iter().enumerate() {
        for (x, t) in right[i].iter_mut().zip(target) {
            *x += weight * a * t;
        }
        for &(j, b) in &terms[n..] {
            add(i, j, weight * a * b);
        }
    }
}
