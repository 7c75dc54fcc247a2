//! Curves of a few parameters through the points of a section, by Gauss-Newton.

use crate::math::least_squares::inverse;

/// Rounds, and the halvings of a step that leads uphill.
const ROUNDS: usize = 12;
const HALVINGS: usize = 5;
/// Step of differences, and the change of a parameter at which the fit has settled.
const STEP: f64 = 1e-4;
const SETTLED: f64 = 1e-4;

/// A curve through points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fitted<const N: usize> {
    pub(super) parameters: [f64; N],
    /// The sum of the squared distances, each up to a limit.
    pub(super) squares: f64,
    /// The covariance of the parameters, for points of unit variance.
    pub(super) covariance: [[f64; N]; N],
}

/// The parameters of least squares from a start on. `off` is the signed distance of a point from the curve with given parameters; beyond the
/// `limit` it counts no more. `None` if the points do not determine the parameters.
pub(super) fn fit<const N: usize>(
    start: [f64; N],
    points: &[[f64; 2]],
    limit: f64,
    off: impl Fn(&[f64; N], [f64; 2]) -> f64,
) -> Option<Fitted<N>> {
    let cost = |at: &[f64; N]| points.iter().map(|&p| off(at, p).clamp(-limit, limit).powi(2)).sum::<f64>();
    let (mut parameters, mut squares) = (start, cost(&start));
    let mut covariance = [[0.0; N]; N];
    for _ in 0..ROUNDS {
        let (matrix, right) = normal_equations(&parameters, points, limit, &off);
        covariance = inverse(matrix)?;
        let mut step: [f64; N] =
            std::array::from_fn(|i| (0..N).map(|j| covariance[i][j] * right[j]).sum::<f64>());
        let mut moved = false;
        for _ in 0..HALVINGS {
            let next: [f64; N] = std::array::from_fn(|i| parameters[i] - step[i]);
            let there = cost(&next);
            if there < squares {
                (parameters, squares, moved) = (next, there, true);
                break;
            }
            step = step.map(|s| 0.5 * s);
        }
        if !moved || step.iter().all(|s| s.abs() < SETTLED) {
            break;
        }
    }
    Some(Fitted { parameters, squares, covariance })
}

fn normal_equations<const N: usize>(
    at: &[f64; N],
    points: &[[f64; 2]],
    limit: f64,
    off: &impl Fn(&[f64; N], [f64; 2]) -> f64,
) -> ([[f64; N]; N], [f64; N]) {
    let moved: [[f64; N]; N] =
        std::array::from_fn(|k| std::array::from_fn(|i| at[i] + if i == k { STEP } else { 0.0 }));
    let (mut matrix, mut right) = ([[0.0; N]; N], [0.0; N]);
    for &p in points {
        let own = off(at, p);
        if own.abs() > limit {
            continue;
        }
        let row: [f64; N] = std::array::from_fn(|k| (off(&moved[k], p) - own) / STEP);
        for i in 0..N {
            (0..N).for_each(|j| matrix[i][j] += row[i] * row[j]);
            right[i] += row[i] * own;
        }
    }
    (matrix, right)
}
