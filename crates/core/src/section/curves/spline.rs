//! Least-squares cubic B-splines on chord-length parameters, clamped, for the pieces of a contour that are neither
//! straight nor round.

use crate::math::vec2::distance;

/// Degree of all splines here.
const DEGREE: usize = 3;

/// A clamped cubic spline in the plane.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Spline {
    /// `controls.len() + 4` of them, from 0 to the length of the polyline it was fitted to.
    pub knots: Vec<f64>,
    /// Control points; the first and last are the ends of the curve.
    pub controls: Vec<[f64; 2]>,
}

/// The spline with the fewest controls, doubling, that stays within `tolerance` of the points; it runs through
/// the first and the last. With it comes its greatest distance from a point. `None` for fewer than four points.
pub(crate) fn fit(points: &[[f64; 2]], tolerance: f64) -> Option<(Spline, f64)> {
    if points.len() < DEGREE + 1 {
        return None;
    }
    let mut spans = 1;
    loop {
        let most = points.len() - DEGREE;
        let spline = least_squares(points, spans.min(most))?;
        let worst = worst(points, &spline.0, &spline.1);
        if worst <= tolerance || spans >= most {
            return Some((spline.0, worst));
        }
        spans *= 2;
    }
}

fn parameters(points: &[[f64; 2]]) -> Vec<f64> {
    let mut at = 0.0;
    let mut result = vec![0.0];
    for w in points.windows(2) {
        at += distance(w[0], w[1]);
        result.push(at);
    }
    result
}

fn least_squares(points: &[[f64; 2]], spans: usize) -> Option<(Spline, Vec<f64>)> {
    let t = parameters(points);
    let length = t[t.len() - 1];
    if length <= 0.0 {
        return None;
    }
    let knots = knots(&t, spans);
    let n = spans + DEGREE;
    let mut band = vec![[0.0; DEGREE + 1]; n];
    let mut right = vec![[0.0; 2]; n];
    for (k, (&u, &p)) in t.iter().zip(points).enumerate() {
        // The ends weigh so much that the curve runs through them.
        let weight = if k == 0 || k + 1 == t.len() { 1e6 } else { 1.0 };
        let (first, basis) = basis(&knots, n, u);
        for i in 0..=DEGREE {
            for j in i..=DEGREE {
                band[first + i][j - i] += weight * basis[i] * basis[j];
            }
            for axis in 0..2 {
                right[first + i][axis] += weight * basis[i] * p[axis];
            }
        }
    }
    let controls = cholesky(band, right)?;
    Some((Spline { knots, controls }, t))
}

/// Inner knots at equal shares of the points, so that every span holds some.
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

/// The index of the first basis function that is not zero at `u`, and the values of four from there (de Boor).
fn basis(knots: &[f64], n: usize, u: f64) -> (usize, [f64; DEGREE + 1]) {
    let span = knots[DEGREE + 1..n].partition_point(|&k| k <= u) + DEGREE;
    let mut values = [0.0; DEGREE + 1];
    values[0] = 1.0;
    for d in 1..=DEGREE {
        let mut carried = 0.0;
        for r in 0..d {
            let (low, high) = (knots[span + 1 + r - d], knots[span + 1 + r]);
            let share = if high > low { values[r] / (high - low) } else { 0.0 };
            values[r] = carried + (high - u) * share;
            carried = (u - low) * share;
        }
        values[d] = carried;
    }
    (span - DEGREE, values)
}

impl Spline {
    /// The point at a parameter.
    pub(crate) fn at(&self, u: f64) -> [f64; 2] {
        let (first, basis) = basis(&self.knots, self.controls.len(), u);
        let mut p = [0.0; 2];
        for (control, b) in self.controls[first..].iter().zip(basis) {
            p = [p[0] + b * control[0], p[1] + b * control[1]];
        }
        p
    }
}

fn worst(points: &[[f64; 2]], spline: &Spline, t: &[f64]) -> f64 {
    points.iter().zip(t).map(|(&p, &u)| distance(p, spline.at(u))).fold(0.0, f64::max)
}

/// Solves a symmetric banded system; a small ridge keeps empty spans solvable.
fn cholesky(mut band: Vec<[f64; DEGREE + 1]>, mut right: Vec<[f64; 2]>) -> Option<Vec<[f64; 2]>> {
    let n = band.len();
    for row in &mut band {
        row[0] += 1e-9;
    }
    for k in 0..n {
        if band[k][0] <= 0.0 || band[k][0].is_nan() {
            return None;
        }
        for i in 1..=DEGREE.min(n - 1 - k) {
            let factor = band[k][i] / band[k][0];
            for j in i..=DEGREE.min(n - 1 - k) {
                band[k + i][j - i] -= factor * band[k][j];
            }
            for axis in 0..2 {
                right[k + i][axis] -= factor * right[k][axis];
            }
        }
    }
    for k in (0..n).rev() {
        for axis in 0..2 {
            let later: f64 = (1..=DEGREE.min(n - 1 - k)).map(|i| band[k][i] * right[k + i][axis]).sum();
            right[k][axis] = (right[k][axis] - later) / band[k][0];
        }
    }
    Some(right)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sine_waves_are_followed_with_few_controls() {
        let points: Vec<[f64; 2]> = (0..200).map(|k| f64::from(k) * 0.05).map(|x| [x, x.sin()]).collect();
        let (spline, worst) = fit(&points, 0.01).unwrap();
        assert!(worst <= 0.01 && spline.controls.len() <= 20, "{worst} with {}", spline.controls.len());
        assert!(distance(spline.at(0.0), points[0]) < 1e-4);
    }
}
