//! The least eigenvector of a symmetric 2 x 2 matrix in closed form (Gumhold 2001, section 4.1): the normal of a least-squares
//! line.

/// The entries `[xx, xy, yy]` of a symmetric 2 x 2 matrix.
pub(crate) type Symmetric2 = [f64; 3];

/// A unit eigenvector of the smallest eigenvalue of `m`; of equal eigenvalues `(1, 0)`. All entries must be finite.
///
/// The paper's steps, with its case analysis: `(c, d)` and `(d, -c)` are the two eigenvectors, and the signs of `a` and `d^2 - c^2`
/// say which belongs to the smaller value. Where the off-diagonal entry is zero the printed text returns `(0, 1)` for `m11 > m22`,
/// as here.
pub(crate) fn least_vector([m11, m12, m22]: Symmetric2) -> [f64; 2] {
    let a = (m11 - m22) / 2.0;
    if m12 == 0.0 {
        return if a > 0.0 { [0.0, 1.0] } else { [1.0, 0.0] };
    }
    let diagonal = std::f64::consts::FRAC_1_SQRT_2;
    if a == 0.0 {
        return if m12 > 0.0 { [diagonal, -diagonal] } else { [diagonal, diagonal] };
    }
    let f = a / (2.0 * a.hypot(m12));
    let c = (0.5 + f).max(0.0).sqrt();
    let d = m12.signum() * (0.5 - f).max(0.0).sqrt();
    if (a > 0.0) == (d * d > c * c) { [c, d] } else { [d, -c] }
}

/// The sum of squared distances from the least-squares line of the vectors whose products `m` sums up.
pub(crate) fn residual(m: Symmetric2) -> f64 {
    let [x, y] = least_vector(m);
    (m[0] * x * x + 2.0 * m[1] * x * y + m[2] * y * y).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::uniform::uniform;

    #[test]
    fn vector_and_value_satisfy_the_eigenvalue_equation_and_are_the_least() {
        let mut uniform = uniform(3);
        let mut next = || uniform() - 0.5;
        let mut all: Vec<Symmetric2> = (0..2000).map(|_| [next() + 0.5, next(), next() + 0.5]).collect();
        all.extend([[1.0, 0.0, 2.0], [2.0, 0.0, 1.0], [1.0, 0.5, 1.0], [1.0, -0.5, 1.0], [0.0; 3]]);
        for m in all {
            let [x, y] = least_vector(m);
            assert!((x * x + y * y - 1.0).abs() < 1e-12, "{m:?}");
            let product = [m[0] * x + m[1] * y, m[1] * x + m[2] * y];
            let value = product[0] * x + product[1] * y;
            assert!((product[0] - value * x).hypot(product[1] - value * y) < 1e-12, "{m:?}");
            let other = m[0] + m[2] - value;
            assert!(value <= other + 1e-12, "{m:?}: {value} is not the least");
            assert!((value.max(0.0) - residual(m)).abs() < 1e-12, "{m:?}");
        }
    }
}
