//! Symmetric tridiagonal systems, positive definite, open or cyclic.

use crate::math::vec2::along;

/// Solves an open system for two right sides (Thomas); `upper[k]` couples the rows `k` and `k + 1`, and the last one is not
/// read.
pub fn open(diagonal: &[f64], upper: &[f64], right: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let n = diagonal.len();
    let mut pivots = diagonal.to_vec();
    let mut solved = right.to_vec();
    for k in 1..n {
        let factor = upper[k - 1] / pivots[k - 1];
        pivots[k] -= factor * upper[k - 1];
        solved[k] = along(solved[k], solved[k - 1], -factor);
    }
    for k in (0..n).rev() {
        let later = if k + 1 < n { along(solved[k], solved[k + 1], -upper[k]) } else { solved[k] };
        solved[k] = later.map(|x| x / pivots[k]);
    }
    solved
}

/// Solves a cyclic system, whose last row is coupled with the first by `upper[n - 1]` (Sherman-Morrison formula).
pub fn cyclic(diagonal: &[f64], upper: &[f64], right: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let n = diagonal.len();
    let corner = upper[n - 1];
    if corner == 0.0 || n < 3 {
        return open(diagonal, upper, right);
    }
    let gamma = -diagonal[0];
    let mut own = diagonal.to_vec();
    own[0] -= gamma;
    own[n - 1] -= corner * corner / gamma;
    let plain = open(&own, upper, right);
    let mut unit = vec![[0.0; 2]; n];
    unit[0] = [gamma; 2];
    unit[n - 1] = [corner; 2];
    let bent = open(&own, upper, &unit);
    let ratio = corner / gamma;
    let share = |axis: usize| {
        let top = plain[0][axis] + ratio * plain[n - 1][axis];
        top / (1.0 + bent[0][axis] + ratio * bent[n - 1][axis])
    };
    let shares = [share(0), share(1)];
    (0..n).map(|k| [plain[k][0] - shares[0] * bent[k][0], plain[k][1] - shares[1] * bent[k][1]]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cyclic_systems_are_solved() {
        let n = 7;
        let diagonal: Vec<f64> = (0..n).map(|k| 3.0 + k as f64).collect();
        let upper: Vec<f64> = (0..n).map(|k| 0.5 + 0.1 * k as f64).collect();
        let right: Vec<[f64; 2]> = (0..n).map(|k| [k as f64, 1.0]).collect();
        let x = cyclic(&diagonal, &upper, &right);
        for k in 0..n {
            let (before, after) = ((k + n - 1) % n, (k + 1) % n);
            for axis in 0..2 {
                let sum =
                    upper[before] * x[before][axis] + diagonal[k] * x[k][axis] + upper[k] * x[after][axis];
                assert!((sum - right[k][axis]).abs() < 1e-12);
            }
        }
    }
}
