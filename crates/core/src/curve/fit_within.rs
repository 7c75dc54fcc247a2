//! Least-squares cubic B-splines with as few spans as a tolerance allows, clamped.
//!
//! It differs from [`fit`](super::fit()) as contours differ from strips: knots at equal shares of the points, so that no span is
//! empty; no smoothing, which would round a tight bend; ends of great weight instead of held ones. The matrix is banded.

use super::bspline::BSpline;
use super::rows::{add_row, chord_lengths, terms};
use crate::math::banded;
use crate::math::points::distance;

/// Degree of all splines here.
const DEGREE: usize = 3;
/// Weight of the end points relative to the others, so great that the curve passes through them.
const END_WEIGHT: f64 = 1e6;
/// Added to the diagonal, so that a span without points can be solved.
const RIDGE: f64 = 1e-9;

/// The first spline within `tolerance` of all points, and its greatest distance from one. The number of spans doubles from one
/// up to what the points allow; the last spline is returned even if it is not within the tolerance. It passes through the first
/// and the last point. `None` for fewer than four points, or if all coincide.
pub(crate) fn fit_within<const D: usize>(points: &[[f64; D]], tolerance: f64) -> Option<(BSpline<D>, f64)> {
    if points.len() < DEGREE + 1 {
        return None;
    }
    let (parameters, length) = chord_lengths(points, false);
    let mut spans = 1;
    loop {
        let most = points.len() - DEGREE;
        let spline = least_squares(points, &parameters, length, spans.min(most))?;
        let worst = worst(points, &spline, &parameters);
        if worst <= tolerance || spans >= most {
            return Some((spline, worst));
        }
        spans *= 2;
    }
}

fn least_squares<const D: usize>(
    points: &[[f64; D]],
    parameters: &[f64],
    length: f64,
    spans: usize,
) -> Option<BSpline<D>> {
    if length <= 0.0 {
        return None;
    }
    let count = spans + DEGREE;
    let knots = knots(parameters, spans);
    let mut curve = BSpline { degree: DEGREE, knots, controls: vec![[0.0; D]; count], periodic: false };
    let mut band = vec![[0.0; banded::HALF + 1]; count];
    let mut right = vec![[0.0; D]; count];
    for (k, (&t, &p)) in parameters.iter().zip(points).enumerate() {
        let weight = if k == 0 || k + 1 == points.len() { END_WEIGHT } else { 1.0 };
        add_row(&terms(&curve, t), p, weight, &mut right, |i, j, x| band[i][j - i] += x);
    }
    band.iter_mut().for_each(|row| row[0] += RIDGE);
    curve.controls = banded::solve(band, right)?;
    Some(curve)
}

/// Inner knots at equal shares of the points, so that every span has some.
fn knots(t: &[f64], spans: usize) -> Vec<f64> {
    let last = t[t.len() - 1];
    let mut knots = vec![0.0; DEGREE + 1];
    for k in 1..spans {
        let place = k as f64 / spans as f64 * (t.len() - 1) as f64;
        let (i, share) = (place.floor() as usize, place.fract());
        knots.push(t[i] + share * (t[(i + 1).min(t.len() - 1)] - t[i]));
    }
    knots.extend([last; DEGREE + 1]);
    knots
}

fn worst<const D: usize>(points: &[[f64; D]], curve: &BSpline<D>, parameters: &[f64]) -> f64 {
    points.iter().zip(parameters).map(|(&p, &t)| distance(p, curve.point(t))).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sine_waves_are_followed_with_few_controls() {
        let points: Vec<[f64; 2]> = (0..200).map(|k| f64::from(k) * 0.05).map(|x| [x, x.sin()]).collect();
        let (spline, worst) = fit_within(&points, 0.01).unwrap();
        assert!(worst <= 0.01 && spline.controls.len() <= 20, "{worst} with {}", spline.controls.len());
        assert!(distance(spline.point(0.0), points[0]) < 1e-4);
    }
}
