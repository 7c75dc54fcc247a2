//! Least-squares cubic B-splines on a chordal length parameterization (Gumhold 2001, section 4, the simple solution).
//!
//! A small multiple of the squared second differences of the control points is added to the squared distances. It determines
//! spans without data and keeps the curve calm between noisy points.

use super::bspline::{BSpline, clamped_knots};
use super::rows::{add_row, chord_lengths, terms};
use crate::math::skyline::Skyline;

/// Options of a fit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitOptions {
    /// Length of curve for each span, in the unit of the points.
    pub span: f64,
    /// Weight of the squared second differences of the control points relative to one data point.
    pub smoothing: f64,
    /// Whether the curve closes; otherwise its ends are held at the first and last point.
    pub closed: bool,
}

/// Fits a curve through `points`, which are in order along it. A closed curve's first point is not repeated.
///
/// Returns the curve and the parameter of each point. The degree is below 3 only for fewer than four points. The points must
/// not all coincide; fewer than two (three if closed) give a degenerate curve of equal controls.
pub fn fit<const D: usize>(points: &[[f64; D]], options: FitOptions) -> (BSpline<D>, Vec<f64>) {
    let (parameters, length) = chord_lengths(points, options.closed);
    let spans = ((length / options.span).round() as usize).clamp(1, points.len().max(2) - 1);
    let mut curve = if options.closed {
        let spans = spans.max(4);
        let knots = (0..=spans).map(|i| length * (i as f64 / spans as f64)).collect();
        BSpline { degree: 3, knots, controls: vec![[0.0; D]; spans], periodic: true }
    } else {
        let degree = (points.len().saturating_sub(1)).clamp(1, 3);
        let knots = clamped_knots(degree, spans, length);
        BSpline { degree, knots, controls: vec![[0.0; D]; spans + degree], periodic: false }
    };
    let (held, ends) = held_ends(points, &curve);
    let (mut matrix, mut right) = normal_equations(points, &parameters, &curve, options.smoothing, ends);
    if matrix.factorise() {
        matrix.solve(&mut right);
        curve.controls[held..held + right.len()].copy_from_slice(&right);
    } else {
        polygon(points, &mut curve);
    }
    if let [first, .., last] = points
        && !options.closed
    {
        let end = curve.controls.len() - 1;
        curve.controls[0] = *first;
        curve.controls[end] = *last;
    }
    (curve, parameters)
}

/// The number of control points held at each end, and their positions.
fn held_ends<const D: usize>(points: &[[f64; D]], curve: &BSpline<D>) -> (usize, Option<[[f64; D]; 2]>) {
    match (curve.periodic, points.first(), points.last()) {
        (false, Some(&first), Some(&last)) => (1, Some([first, last])),
        _ => (0, None),
    }
}

/// The normal equations for the free control points.
fn normal_equations<const D: usize>(
    points: &[[f64; D]],
    parameters: &[f64],
    curve: &BSpline<D>,
    smoothing: f64,
    ends: Option<[[f64; D]; 2]>,
) -> (Skyline, Vec<[f64; D]>) {
    let count = curve.controls.len();
    let free = if ends.is_some() { count - 2 } else { count };
    let mut matrix = Skyline::zeros(profile(free, curve.periodic));
    let mut right = vec![[0.0; D]; free];
    let mut row = |terms: &[(usize, f64)], target: [f64; D], weight: f64| {
        let (terms, target) = freed(terms, target, count, ends);
        add_row(&terms, target, weight, &mut right, |i, j, x| matrix.add(i, j, x));
    };
    for (&p, &t) in points.iter().zip(parameters) {
        row(&terms(curve, t)[..=curve.degree], p, 1.0);
    }
    let differences = if curve.periodic { count } else { count.saturating_sub(2) };
    for i in 0..differences {
        let [first, second] = slopes(curve, i);
        let terms = [(i, first), ((i + 1) % count, -(first + second)), ((i + 2) % count, second)];
        row(&terms, [0.0; D], smoothing);
    }
    (matrix, right)
}

/// A row over the free control points alone: the terms of held ones go to the right side.
fn freed<const D: usize>(
    terms: &[(usize, f64)],
    mut target: [f64; D],
    count: usize,
    ends: Option<[[f64; D]; 2]>,
) -> (Vec<(usize, f64)>, [f64; D]) {
    let Some([first, last]) = ends else { return (terms.to_vec(), target) };
    let mut free = Vec::with_capacity(terms.len());
    for &(control, weight) in terms {
        let held = match control {
            0 => first,
            c if c == count - 1 => last,
            c => {
                free.push((c - 1, weight));
                continue;
            }
        };
        target.iter_mut().zip(held).for_each(|(x, h)| *x -= h * weight);
    }
    (free, target)
}

/// Weights of the differences of control points `i`, `i + 1` and `i + 1`, `i + 2` in a second difference: the inverse of their
/// distance in parameter, relative to a span, so that the second difference of evenly moving controls is 0.
fn slopes<const D: usize>(curve: &BSpline<D>, i: usize) -> [f64; 2] {
    if curve.periodic {
        return [1.0; 2];
    }
    // The parameter of a control point: the mean of the knots under it (Greville).
    let abscissa = |c: usize| curve.knots[c + 1..=c + curve.degree].iter().sum::<f64>() / curve.degree as f64;
    let (from, to) = curve.domain();
    let span = (to - from) / (curve.controls.len() - curve.degree) as f64;
    [0, 1].map(|k| span / (abscissa(i + k + 1) - abscissa(i + k)).max(1e-9 * span))
}

/// The first column of each row: a band of three, and full last rows when periodic.
fn profile(free: usize, periodic: bool) -> Vec<usize> {
    (0..free).map(|i| if periodic && i + 3 >= free { 0 } else { i.saturating_sub(3) }).collect()
}

/// Control points on the polyline of the data, for systems that rounding makes singular.
fn polygon<const D: usize>(points: &[[f64; D]], curve: &mut BSpline<D>) {
    let last = curve.controls.len().max(2) - 1;
    for (i, c) in curve.controls.iter_mut().enumerate() {
        *c = points.get(i * points.len().saturating_sub(1) / last).copied().unwrap_or([0.0; D]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::vec3::distance;

    #[test]
    fn a_circle_of_points_gives_a_circle() {
        let points: Vec<[f64; 3]> = (0..60)
            .map(|i| (i as f64 * std::f64::consts::TAU / 60.0).sin_cos())
            .map(|(s, c)| [5.0 * c, 5.0 * s, 1.0])
            .collect();
        let (curve, _) = fit(&points, FitOptions { span: 3.0, smoothing: 1e-6, closed: true });
        for i in 0..500 {
            let [x, y, z] = curve.point(curve.domain().1 * i as f64 / 500.0);
            assert!(((x * x + y * y).sqrt() - 5.0).abs() < 0.02 && (z - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn the_ends_of_an_open_curve_are_held_and_a_line_stays_a_line() {
        let points: Vec<[f64; 3]> = (0..20).map(|i| [i as f64, 2.0 * i as f64, 0.0]).collect();
        let (curve, parameters) = fit(&points, FitOptions { span: 3.0, smoothing: 0.01, closed: false });
        assert_eq!(curve.point(0.0), points[0]);
        assert_eq!(curve.point(curve.domain().1), points[19]);
        for (p, t) in points.iter().zip(parameters) {
            assert!(distance(*p, curve.point(t)) < 1e-9);
        }
    }

    #[test]
    fn two_points_give_a_segment() {
        let (curve, _) =
            fit(&[[0.0; 3], [1.0, 0.0, 0.0]], FitOptions { span: 3.0, smoothing: 0.01, closed: false });
        assert_eq!(curve.degree, 1);
        assert_eq!(curve.point(0.5), [0.5, 0.0, 0.0]);
    }
}
