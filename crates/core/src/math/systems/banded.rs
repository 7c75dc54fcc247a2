//! Elimination of a symmetric positive definite matrix with a narrow band.

/// Half-width of the band.
pub const HALF: usize = 3;

/// Solves for one right side of `D` columns. `band[k][i]` is the entry of row `k` and column `k + i`. `None` if a pivot is not
/// positive.
pub fn solve<const D: usize>(
    mut band: Vec<[f64; HALF + 1]>,
    mut right: Vec<[f64; D]>,
) -> Option<Vec<[f64; D]>> {
    let n = band.len();
    for k in 0..n {
        if band[k][0] <= 0.0 || band[k][0].is_nan() {
            return None;
        }
        for i in 1..=HALF.min(n - 1 - k) {
            let factor = band[k][i] / band[k][0];
            for j in i..=HALF.min(n - 1 - k) {
                band[k + i][j - i] -= factor * band[k][j];
            }
            for axis in 0..D {
                right[k + i][axis] -= factor * right[k][axis];
            }
        }
    }
    for k in (0..n).rev() {
        for axis in 0..D {
            let later: f64 = (1..=HALF.min(n - 1 - k)).map(|i| band[k][i] * right[k + i][axis]).sum();
            right[k][axis] = (right[k][axis] - later) / band[k][0];
        }
    }
    Some(right)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_banded_system_is_solved_and_a_singular_one_refused() {
        let n = 8;
        let entry = |k: usize, i: usize| if i == 0 { 9.0 + k as f64 } else { 1.0 / (k + 2 * i) as f64 };
        let band: Vec<[f64; HALF + 1]> = (0..n).map(|k| std::array::from_fn(|i| entry(k, i))).collect();
        let truth: Vec<[f64; 2]> = (0..n).map(|k| [k as f64, 1.0 - k as f64]).collect();
        let at = |r: usize, c: usize| {
            let (low, off) = (r.min(c), r.abs_diff(c));
            if off <= HALF { entry(low, off) } else { 0.0 }
        };
        let row = |r: usize| [0, 1].map(|axis| (0..n).map(|c| at(r, c) * truth[c][axis]).sum::<f64>());
        let found = solve(band, (0..n).map(row).collect()).unwrap();
        for (x, y) in found.iter().flatten().zip(truth.iter().flatten()) {
            assert!((x - y).abs() < 1e-12);
        }
        assert_eq!(solve(vec![[1.0, 1.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0]], vec![[0.0]; 2]), None);
    }
}
