//! Centre and correlation matrix (a tensor) of a neighbourhood (Gumhold 2001, section 3.1, equations 2 and 3).

use super::eigen3::{Eigen3, Symmetric3, eigen3};
use super::least_axis::least_axis;
use super::vec3::sub;

/// Centre and correlation ellipsoid of a set of points.
#[derive(Clone, Copy, Debug)]
pub struct Ellipsoid {
    /// Centre of the neighbourhood relative to its own point.
    pub centre: [f64; 3],
    /// Axes: `values[i]` is the variance along `vectors[i]`, ascending.
    pub axes: Eigen3,
    /// The number of points, the own point included.
    pub count: usize,
}

/// The correlation ellipsoid of `points[own]` and `neighbors`, with the point itself as one of the set.
pub fn ellipsoid(points: &[[f64; 3]], own: usize, neighbors: &[u32]) -> Ellipsoid {
    let (centre, tensor) = correlation(points, own, neighbors);
    Ellipsoid { centre, axes: eigen3(&tensor), count: neighbors.len() + 1 }
}

/// The unit normal, without orientation, of the least-squares plane of the same set: the ellipsoid's least axis alone.
pub fn plane_normal(points: &[[f64; 3]], own: usize, neighbors: &[u32]) -> [f64; 3] {
    least_axis(&correlation(points, own, neighbors).1).1
}

/// Centre of the set, from the point, and its correlation tensor.
pub fn correlation(points: &[[f64; 3]], own: usize, neighbors: &[u32]) -> ([f64; 3], Symmetric3) {
    let origin = points[own];
    let (mut sum, mut products): ([f64; 3], Symmetric3) = ([0.0; 3], [0.0; 6]);
    for &j in neighbors {
        let d = sub(points[j as usize], origin);
        for c in 0..3 {
            sum[c] += d[c];
        }
        add_product(&mut products, d, 1.0);
    }
    centred(sum, products, (neighbors.len() + 1) as f64)
}

/// Centre and correlation tensor from the sum of vectors, the sum of their products, and their count or sum of weights.
pub fn centred(sum: [f64; 3], products: Symmetric3, count: f64) -> ([f64; 3], Symmetric3) {
    let centre = sum.map(|s| s / count); // equation 2
    let mut tensor = products.map(|p| p / count);
    add_product(&mut tensor, centre, -1.0); // equation 3
    (centre, tensor)
}

/// The sum of `v v^t` over some vectors.
pub fn scatter(vectors: impl Iterator<Item = [f64; 3]>) -> Symmetric3 {
    let mut sum = [0.0; 6];
    vectors.for_each(|v| add_product(&mut sum, v, 1.0));
    sum
}

/// Adds `weight v v^t`.
#[inline]
pub fn add_product(m: &mut Symmetric3, v: [f64; 3], weight: f64) {
    let w = [v[0] * weight, v[1] * weight, v[2] * weight];
    m[0] += w[0] * v[0];
    m[1] += w[0] * v[1];
    m[2] += w[0] * v[2];
    m[3] += w[1] * v[1];
    m[4] += w[1] * v[2];
    m[5] += w[2] * v[2];
}

/// The product of `m` and `v`.
#[inline]
pub fn apply(m: &Symmetric3, v: [f64; 3]) -> [f64; 3] {
    let row = |a: usize, b: usize, c: usize| m[a] * v[0] + m[b] * v[1] + m[c] * v[2];
    [row(0, 1, 2), row(1, 3, 4), row(2, 4, 5)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_in_a_plane_has_its_normal_as_the_least_axis() {
        let points = [[5.0, 5.0, 2.0], [6.0, 5.0, 2.0], [5.0, 6.0, 2.0], [6.0, 6.0, 2.0]];
        let e = ellipsoid(&points, 0, &[1, 2, 3]);
        assert_eq!(e.centre, [0.5, 0.5, 0.0]);
        assert_eq!(e.axes.values, [0.0, 0.25, 0.25]);
        assert_eq!(e.axes.vectors[0].map(f64::abs), [0.0, 0.0, 1.0]);
    }
}
