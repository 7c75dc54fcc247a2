//! Numbers that stand for no value, such as -3.4e38 in grids: points so far out that f64 cannot hold the others beside them.

use super::morton::finite;
use crate::parallel;

/// Share of the spacing that coordinates from the least corner must tell apart.
const TOLD_APART: f64 = 1.0 / 1024.0;

/// Whether coordinates of a cloud of this extent, from its least corner, are too coarse for its spacing; `repeats` of its `count`
/// points fall together with others.
pub(super) fn suspected(extent: f64, spacing: f64, repeats: usize, count: usize) -> bool {
    extent * f64::EPSILON > TOLD_APART * spacing || 2 * repeats >= count && repeats > 0
}

/// The points with those beyond reach put out as if they were not finite; and how many these are. `None` if there are none.
///
/// The nearer half of the points on each axis, about their median, says how far the cloud reaches, and so how closely its points lie at
/// least; beyond reach is what leaves less than a thousandth of that. Half of the points may be such numbers.
pub(super) fn without(points: &[[f64; 3]]) -> Option<(Vec<[f64; 3]>, usize)> {
    let axes = [0, 1, 2].map(|axis| {
        let along: Vec<f64> = points.iter().filter(|p| finite(p)).map(|p| p[axis]).collect();
        let middle = median(along.clone());
        (middle, median(along.into_iter().map(|x| (x - middle).abs()).collect()))
    });
    let half = axes.iter().map(|axis| axis.1).fold(0.0, f64::max);
    let reach = half / (points.len() as f64).sqrt() * TOLD_APART / f64::EPSILON;
    let beyond = |p: &[f64; 3]| finite(p) && (0..3).any(|a| (p[a] - axes[a].0).abs() > reach);
    let count = points.iter().filter(|p| beyond(p)).count();
    if count == 0 || half == 0.0 {
        return None;
    }
    let nowhere = [f64::NAN; 3];
    let kept =
        parallel::map(
            points.len(),
            parallel::QUICK,
            |i| if beyond(&points[i]) { nowhere } else { points[i] },
        );
    Some((kept, count))
}

/// The lower median; zero of no numbers.
fn median(mut values: Vec<f64>) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let middle = (values.len() - 1) / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}
