//! Spread of weighted points and its least axis.

use crate::math::vec3;

/// Weighted mean and covariance of points.
pub(crate) struct Spread {
    /// Sum of the weights.
    pub weight: f64,
    /// Weighted mean.
    pub centre: [f64; 3],
    /// Weighted covariance: xx, xy, xz, yy, yz, zz.
    pub tensor: [f64; 6],
}

impl Spread {
    /// The spread of (point, weight) pairs; sums are taken relative to `origin`, a point among them.
    pub(crate) fn of(weighted: impl Iterator<Item = ([f64; 3], f64)>, origin: [f64; 3]) -> Self {
        let (mut weight, mut first, mut second) = (0.0, [0.0; 3], [0.0; 6]);
        for (point, w) in weighted {
            let d = vec3::sub(point, origin);
            weight += w;
            first = vec3::add_scaled(first, d, w);
            for (slot, value) in second.iter_mut().zip(products(d)) {
                *slot += w * value;
            }
        }
        if weight <= 0.0 {
            return Self { weight: 0.0, centre: origin, tensor: [0.0; 6] };
        }
        let mean = vec3::scale(first, 1.0 / weight);
        let mut tensor = second.map(|s| s / weight);
        for (slot, value) in tensor.iter_mut().zip(products(mean)) {
            *slot -= value;
        }
        Self { weight, centre: vec3::add(origin, mean), tensor }
    }
}

fn products(d: [f64; 3]) -> [f64; 6] {
    [d[0] * d[0], d[0] * d[1], d[0] * d[2], d[1] * d[1], d[1] * d[2], d[2] * d[2]]
}

/// All eigenvalues, ascending, with their unit vectors, by cyclic Jacobi rotations.
pub(crate) fn decompose(tensor: &[f64; 6]) -> ([f64; 3], [[f64; 3]; 3]) {
    let [xx, xy, xz, yy, yz, zz] = *tensor;
    let mut a = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let mut v = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let scale = xx.abs() + yy.abs() + zz.abs();
    for _ in 0..12 {
        if a[0][1].abs() + a[0][2].abs() + a[1][2].abs() <= 1e-15 * scale {
            break;
        }
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            rotate(&mut a, &mut v, p, q);
        }
    }
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| a[i][i].total_cmp(&a[j][j]));
    (order.map(|i| a[i][i]), order.map(|i| [v[0][i], v[1][i], v[2][i]]))
}

/// The least eigenvalue and its unit vector.
pub(crate) fn least(tensor: &[f64; 6]) -> (f64, [f64; 3]) {
    let (values, vectors) = decompose(tensor);
    (values[0], vectors[0])
}

fn rotate(a: &mut [[f64; 3]; 3], v: &mut [[f64; 3]; 3], p: usize, q: usize) {
    if a[p][q] == 0.0 {
        return;
    }
    let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
    let sign = if theta >= 0.0 { 1.0 } else { -1.0 };
    let t = sign / (theta.abs() + (theta * theta + 1.0).sqrt());
    let c = 1.0 / (t * t + 1.0).sqrt();
    let s = t * c;
    for row in a.iter_mut() {
        (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
    }
    for k in 0..3 {
        (a[p][k], a[q][k]) = (c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]);
        (v[k][p], v[k][q]) = (c * v[k][p] - s * v[k][q], s * v[k][p] + c * v[k][q]);
    }
}
