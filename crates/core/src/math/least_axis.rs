//! The least eigenpair of a symmetric 3 x 3 matrix alone, which is enough for a normal.
//!
//! Newton's iteration on the characteristic polynomial, started at zero, rises to the least root of a positive semidefinite
//! matrix without passing it, in two to five steps for flat points; the vector is the greatest cross product of two rows of
//! `m - lambda`. It takes about a third of the time of [`eigen3`].

use super::eigen3::{Symmetric3, eigen3};
use super::vec3::{cross, dot, scale};

/// Number of steps after which only an iteration towards a double root, whose vector is arbitrary, has not converged.
const STEPS: usize = 16;
/// Relative step at which the iteration has converged.
const AT_REST: f64 = 1e-9;
/// Product of the gaps to the other eigenvalues, for a trace of one, below which the cross products are too inaccurate.
const LEAST_GAP: f64 = 1e-10;

/// The least eigenvalue with a unit eigenvector. `m` must be positive semidefinite to rounding, and finite; if it is zero, the
/// vector is the z axis.
pub fn least_axis(m: &Symmetric3) -> (f64, [f64; 3]) {
    let trace = m[0] + m[3] + m[5];
    if trace <= 0.0 {
        return (0.0, [0.0, 0.0, 1.0]);
    }
    let [a, b, c, d, e, f] = m.map(|x| x / trace);
    let minors = [d * f - e * e, a * f - c * c, a * d - b * b];
    let sum = minors[0] + minors[1] + minors[2];
    let determinant = a * minors[0] - b * (b * f - c * e) + c * (b * e - c * d);
    let (mut x, mut last) = (0.0, f64::INFINITY);
    for _ in 0..STEPS {
        let value = ((x - 1.0) * x + sum) * x - determinant;
        let slope = (3.0 * x - 2.0) * x + sum;
        if slope <= 1e-14 {
            break;
        }
        let step = value / slope;
        x -= step;
        last = step.abs();
        if step.abs() <= 1e-16 {
            break;
        }
    }
    let rows = [[a - x, b, c], [b, d - x, e], [c, e, f - x]];
    let crosses = [cross(rows[0], rows[1]), cross(rows[0], rows[2]), cross(rows[1], rows[2])];
    let squares = crosses.map(|v| dot(v, v));
    let most = if squares[0] >= squares[1] { 0 } else { 1 };
    let most = if squares[most] >= squares[2] { most } else { 2 };
    if squares[most] < LEAST_GAP * LEAST_GAP || last > AT_REST {
        let all = eigen3(m);
        return (all.values[0].max(0.0), all.vectors[0]);
    }
    (x.max(0.0) * trace, scale(crosses[most], 1.0 / squares[most].sqrt()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::tensor::add_product;
    use crate::math::uniform::uniform;
    use crate::math::vec3::{add_scaled, unit};

    #[test]
    fn it_agrees_with_jacobi_on_tensors_from_flat_to_round() {
        let mut uniform = uniform(11);
        let mut next = || uniform() - 0.5;
        for round in 0..3000 {
            let flat = [1.0, 0.3, 1e-2, 1e-5, 1e-9, 0.0][round % 6];
            let size = 10_f64.powi(round as i32 % 13 - 6);
            let (x, y) = ([next(), next(), next()], [next(), next(), next()]);
            let z = unit(cross(x, y));
            let mut m = [0.0; 6];
            for _ in 0..9 {
                let p = add_scaled(scale(x, next()), y, next());
                add_product(&mut m, add_scaled(p, z, flat * next()), size);
            }
            let (value, vector) = least_axis(&m);
            let full = eigen3(&m);
            let trace = full.values.iter().sum::<f64>();
            assert!((value - full.values[0]).abs() < 1e-12 * trace, "{value} {:?}", full.values);
            if full.values[1] - full.values[0] > 1e-3 * trace {
                assert!(dot(vector, full.vectors[0]).abs() > 1.0 - 1e-10, "{m:?}");
            }
        }
    }

    #[test]
    fn an_exact_plane_has_its_normal_and_a_least_value_of_rounding() {
        let mut m = [0.0; 6];
        for i in 0..9 {
            add_product(&mut m, [f64::from(i % 3) - 1.0, f64::from(i / 3) - 1.0, 0.0], 1.0);
        }
        assert_eq!(least_axis(&m), (0.0, [0.0, 0.0, 1.0]));
    }

    #[test]
    fn points_on_a_line_and_no_points_have_some_axis() {
        let (value, vector) = least_axis(&[1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!((value, vector[0]), (0.0, 0.0));
        assert_eq!(least_axis(&[0.0; 6]), (0.0, [0.0, 0.0, 1.0]));
        let (value, _) = least_axis(&[2.0, 0.0, 0.0, 2.0, 0.0, 2.0]);
        assert!((value - 2.0).abs() < 1e-12);
    }
}
