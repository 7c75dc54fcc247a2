//! Linear least squares with few unknowns.

/// Least pivot of the normal equations, relative to the diagonal entry, at which the rows determine the unknown.
const LEAST_PIVOT: f64 = 1e-9;

/// The `x` that minimises the sum of `(a . x - b)^2` over rows `(a, b)`, by the normal equations; `None` if the rows do not
/// determine it, or if a value is not a number.
pub fn least_squares<const N: usize>(rows: impl Iterator<Item = ([f64; N], f64)>) -> Option<[f64; N]> {
    let (mut m, mut right) = ([[0.0; N]; N], [0.0; N]);
    for (a, b) in rows {
        for i in 0..N {
            (0..N).for_each(|j| m[i][j] += a[i] * a[j]);
            right[i] += a[i] * b;
        }
    }
    solve(m, right)
}

/// The `x` with `m x = right`, by elimination; the matrix is positive semidefinite and needs no pivoting. `None` where it is singular to
/// rounding.
pub fn solve<const N: usize>(mut m: [[f64; N]; N], mut right: [f64; N]) -> Option<[f64; N]> {
    let diagonal: [f64; N] = std::array::from_fn(|i| m[i][i]);
    for i in 0..N {
        // Written so that a pivot that is not a number is refused too.
        let sound = m[i][i] > LEAST_PIVOT * diagonal[i];
        if !sound {
            return None;
        }
        for k in i + 1..N {
            let factor = m[k][i] / m[i][i];
            (i..N).for_each(|j| m[k][j] -= factor * m[i][j]);
            right[k] -= factor * right[i];
        }
    }
    for i in (0..N).rev() {
        let known: f64 = (i + 1..N).map(|j| m[i][j] * right[j]).sum();
        right[i] = (right[i] - known) / m[i][i];
    }
    Some(right)
}

/// The inverse of a positive definite matrix; `None` where it is singular to rounding.
pub fn inverse<const N: usize>(m: [[f64; N]; N]) -> Option<[[f64; N]; N]> {
    let mut inverse = [[0.0; N]; N];
    for (k, row) in inverse.iter_mut().enumerate() {
        *row = solve(m, std::array::from_fn(|i| f64::from(u8::from(i == k))))?;
    }
    Some(inverse)
}

#[cfg(test)]
mod tests {
    use super::{inverse, least_squares};

    #[test]
    fn coefficients_are_found_again_and_what_is_not_determined_is_refused() {
        let row = |x: f64| ([1.0, x, x * x], 3.0 - 4.0 * x + x * x);
        let found = least_squares((-4..5).map(f64::from).map(row)).unwrap();
        assert!(found.iter().zip([3.0, -4.0, 1.0]).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
        assert_eq!(least_squares([0.0, 1.0].into_iter().map(row)), None);
        assert_eq!(least_squares([0.0, 1.0, f64::NAN].into_iter().map(row)), None);
        assert_eq!(least_squares(std::iter::empty::<([f64; 2], f64)>()), None);
    }

    #[test]
    fn a_matrix_times_its_inverse_is_one() {
        let m = [[4.0, 1.0, 0.5], [1.0, 3.0, -1.0], [0.5, -1.0, 2.0]];
        let other = inverse(m).unwrap();
        for (i, row) in m.iter().enumerate() {
            for j in 0..3 {
                let sum: f64 = row.iter().zip(&other).map(|(x, other)| x * other[j]).sum();
                assert!((sum - f64::from(u8::from(i == j))).abs() < 1e-12);
            }
        }
        assert!(inverse([[1.0, 1.0], [1.0, 1.0]]).is_none());
    }
}
