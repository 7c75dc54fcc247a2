//! Eigenvalues and eigenvectors of symmetric 3 x 3 matrices by cyclic Jacobi rotations.
//!
//! Jacobi keeps the small eigenvalue of a nearly flat correlation tensor to full relative accuracy, which the closed
//! trigonometric form does not; three to five sweeps suffice.

/// The six distinct entries of a symmetric 3 x 3 matrix: `[xx, xy, xz, yy, yz, zz]`.
pub type Symmetric3 = [f64; 6];

/// Eigenvalues in ascending order with their unit eigenvectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eigen3 {
    /// `values[0] <= values[1] <= values[2]`.
    pub values: [f64; 3],
    /// `vectors[i]` belongs to `values[i]`; a right-handed orthonormal frame.
    pub vectors: [[f64; 3]; 3],
}

const SWEEPS: usize = 12;

/// Decomposes `m`. All entries must be finite.
pub fn eigen3(m: &Symmetric3) -> Eigen3 {
    let mut a = [[m[0], m[1], m[2]], [m[1], m[3], m[4]], [m[2], m[4], m[5]]];
    let mut v = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let size = m.iter().fold(0.0_f64, |s, x| s.max(x.abs()));
    for _ in 0..SWEEPS {
        if a[0][1].abs().max(a[0][2].abs()).max(a[1][2].abs()) <= 1e-16 * size {
            break;
        }
        rotate(&mut a, &mut v, 0, 1);
        rotate(&mut a, &mut v, 0, 2);
        rotate(&mut a, &mut v, 1, 2);
    }
    sorted([a[0][0], a[1][1], a[2][2]], v)
}

/// One Jacobi rotation that zeroes `a[p][q]`; the rows of `v` are the vectors.
#[inline]
fn rotate(a: &mut [[f64; 3]; 3], v: &mut [[f64; 3]; 3], p: usize, q: usize) {
    let apq = a[p][q];
    if apq == 0.0 {
        return;
    }
    let theta = (a[q][q] - a[p][p]) / (2.0 * apq);
    let t = if theta.abs() > 1e150 {
        0.5 / theta
    } else {
        theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt())
    };
    let c = 1.0 / (t * t + 1.0).sqrt();
    let s = t * c;
    a[p][p] -= t * apq;
    a[q][q] += t * apq;
    a[p][q] = 0.0;
    a[q][p] = 0.0;
    let r = 3 - p - q;
    let (arp, arq) = (a[r][p], a[r][q]);
    a[r][p] = c * arp - s * arq;
    a[p][r] = a[r][p];
    a[r][q] = s * arp + c * arq;
    a[q][r] = a[r][q];
    for i in 0..3 {
        let (vp, vq) = (v[p][i], v[q][i]);
        v[p][i] = c * vp - s * vq;
        v[q][i] = s * vp + c * vq;
    }
}

fn sorted(values: [f64; 3], vectors: [[f64; 3]; 3]) -> Eigen3 {
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| values[i].total_cmp(&values[j]).then(i.cmp(&j)));
    let pick = order.map(|i| vectors[i]);
    let third = super::vec3::cross(pick[0], pick[1]);
    Eigen3 { values: order.map(|i| values[i]), vectors: [pick[0], pick[1], third] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::uniform::uniform;
    use crate::math::vec3::dot;

    fn product(m: &Symmetric3, x: [f64; 3]) -> [f64; 3] {
        [
            m[0] * x[0] + m[1] * x[1] + m[2] * x[2],
            m[1] * x[0] + m[3] * x[1] + m[4] * x[2],
            m[2] * x[0] + m[4] * x[1] + m[5] * x[2],
        ]
    }

    #[test]
    fn vectors_satisfy_the_eigenvalue_equation_over_many_scales() {
        let mut uniform = uniform(7);
        let mut next = || uniform() - 0.5;
        for round in 0..2000 {
            let scale = 10_f64.powi(round % 25 - 12);
            let m: Symmetric3 = std::array::from_fn(|_| next() * scale);
            let e = eigen3(&m);
            assert!(e.values[0] <= e.values[1] && e.values[1] <= e.values[2]);
            for i in 0..3 {
                let r = product(&m, e.vectors[i]);
                for (a, b) in r.iter().zip(e.vectors[i]) {
                    assert!((a - e.values[i] * b).abs() < 1e-13 * scale, "{m:?}");
                }
                for j in 0..3 {
                    let expected = if i == j { 1.0 } else { 0.0 };
                    assert!((dot(e.vectors[i], e.vectors[j]) - expected).abs() < 1e-14);
                }
            }
        }
    }

    #[test]
    fn a_flat_tensor_keeps_its_tiny_eigenvalue() {
        let e = eigen3(&[2.0, 0.0, 0.0, 1.0, 0.0, 1e-22]);
        assert_eq!(e.values, [1e-22, 1.0, 2.0]);
    }

    #[test]
    fn zero_and_repeated_values_give_an_orthonormal_frame() {
        for m in [[0.0; 6], [3.0, 0.0, 0.0, 3.0, 0.0, 3.0]] {
            let e = eigen3(&m);
            assert_eq!(dot(e.vectors[0], e.vectors[1]), 0.0);
            assert_eq!(dot(e.vectors[2], e.vectors[2]), 1.0);
        }
    }
}
