//! Full systems of a few dozen unknowns.

/// Least pivot, relative to the greatest entry of the matrix, at which it is not singular.
const LEAST_PIVOT: f64 = 1e-14;

/// The `x` with `matrix x = right`, by elimination with the greatest pivot of each column; `None` where the matrix is singular to rounding.
pub(crate) fn solve(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Option<Vec<f64>> {
    let n = right.len();
    let greatest = matrix.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
    for i in 0..n {
        let pivot = (i..n).max_by(|&a, &b| matrix[a][i].abs().total_cmp(&matrix[b][i].abs()))?;
        let sound = matrix[pivot][i].abs() > LEAST_PIVOT * greatest;
        if !sound {
            return None;
        }
        matrix.swap(i, pivot);
        right.swap(i, pivot);
        let (upper, lower) = matrix.split_at_mut(i + 1);
        let row = &upper[i];
        for (k, other) in lower.iter_mut().enumerate() {
            let factor = other[i] / row[i];
            if factor != 0.0 {
                (i..n).for_each(|j| other[j] -= factor * row[j]);
                right[i + 1 + k] -= factor * right[i];
            }
        }
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|j| matrix[i][j] * right[j]).sum();
        right[i] = (right[i] - known) / matrix[i][i];
    }
    Some(right)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_system_without_diagonal_is_solved_and_a_singular_one_refused() {
        let matrix = vec![vec![0.0, 2.0, 1.0], vec![1.0, 0.0, 0.0], vec![3.0, 0.0, -1.0]];
        let found = solve(matrix, vec![7.0, 1.0, 0.0]).unwrap();
        assert!(found.iter().zip([1.0, 2.0, 3.0]).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
        assert_eq!(solve(vec![vec![1.0, 2.0], vec![2.0, 4.0]], vec![1.0, 2.0]), None);
    }
}
