//! Spread of weighted points and its least axis.

use crate::math::eigen3::eigen3;
use crate::math::vec3;

/// Share of the spread beside a straight line below which points show no plane.
const LINE_SHARE: f64 = 1e-5;
/// Newton steps towards the least eigenvalue before rotations take over.
const STEPS: usize = 12;

/// Weighted mean and covariance of points.
#[derive(Clone, Copy, Debug)]
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

    /// The spread of all points of several spreads.
    pub(crate) fn merged(parts: &[Spread]) -> Self {
        let origin = parts.first().map_or([0.0; 3], |p| p.centre);
        let mut all = Self::of(parts.iter().map(|p| (p.centre, p.weight)), origin);
        for part in parts {
            let share = part.weight / all.weight.max(1.0);
            all.tensor.iter_mut().zip(&part.tensor).for_each(|(sum, own)| *sum += share * own);
        }
        all
    }
}

fn products(d: [f64; 3]) -> [f64; 6] {
    [d[0] * d[0], d[0] * d[1], d[0] * d[2], d[1] * d[1], d[1] * d[2], d[2] * d[2]]
}

/// The normal of a plane and the spread across it; a zero normal where the points lie on a straight line, or all in
/// one place, and so on any number of planes.
pub(crate) fn normal(tensor: &[f64; 6]) -> (f64, [f64; 3]) {
    let (value, vector) = least(tensor);
    let [xx, xy, xz, yy, yz, zz] = *tensor;
    let trace = xx + yy + zz;
    // The sum of the principal minors is the sum of the products of two eigenvalues: about the greatest times the rest.
    let minors = xx * yy - xy * xy + xx * zz - xz * xz + yy * zz - yz * yz;
    if minors > LINE_SHARE * trace * trace { (value, vector) } else { (value, [0.0; 3]) }
}

/// The least eigenvalue of a tensor and its unit vector, the longest of the products of rows.
///
/// The characteristic polynomial of a positive tensor is concave and rises from zero to its least root, so that
/// Newton's steps from zero come near it from below, and fast where the points are nearly flat. Where two
/// eigenvalues agree so closely that steps shrink slowly or no product is sure, rotations give both.
fn least(tensor: &[f64; 6]) -> (f64, [f64; 3]) {
    let [xx, xy, xz, yy, yz, zz] = *tensor;
    let trace = xx + yy + zz;
    let exact = || {
        let all = eigen3(tensor);
        (all.values[0], all.vectors[0])
    };
    if !(trace > 0.0 && trace.is_finite()) {
        return exact();
    }
    let (a, b, c) = (yy * zz - yz * yz, xx * zz - xz * xz, xx * yy - xy * xy);
    let minors = a + b + c;
    let determinant = xx * a - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
    let (mut value, mut settled) = (0.0, false);
    for _ in 0..STEPS {
        let rest = ((value - trace) * value + minors) * value - determinant;
        let slope = (3.0 * value - 2.0 * trace) * value + minors;
        let step = rest / slope;
        value -= step;
        // Steps shrink quadratically: the one after this is below rounding.
        if step.abs() <= 1e-8 * trace {
            settled = true;
            break;
        }
    }
    if !settled {
        return exact();
    }
    let rows = [[xx - value, xy, xz], [xy, yy - value, yz], [xz, yz, zz - value]];
    let products = [(0, 1), (0, 2), (1, 2)].map(|(i, j)| vec3::cross(rows[i], rows[j]));
    let lengths = products.map(|p| vec3::dot(p, p));
    let best = (0..3).fold(0, |m, k| if lengths[k] > lengths[m] { k } else { m });
    let square = trace * trace;
    if lengths[best] <= 1e-10 * square * square {
        return exact();
    }
    (value, vec3::scale(products[best], 1.0 / lengths[best].sqrt()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_axis_agrees_with_rotations() {
        let mut state = 3_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        for round in 0..2000 {
            let points: Vec<[f64; 3]> =
                (0..12).map(|_| [next(), next(), next() * 10f64.powi(-(round % 6))]).collect();
            let spread = Spread::of(points.iter().map(|&p| (p, 1.0)), points[0]);
            let (value, vector) = least(&spread.tensor);
            let all = eigen3(&spread.tensor);
            assert!((value - all.values[0]).abs() < 1e-13);
            let gap = all.values[1] - all.values[0];
            assert!(vec3::dot(vector, all.vectors[0]).abs() > 1.0 - 1e-12 / gap, "{round}");
        }
        assert_eq!(least(&[0.0; 6]).0, 0.0);
        assert_eq!(least(&[1.0, 0.0, 0.0, 1.0, 0.0, 1.0]).0, 1.0);
    }
}
