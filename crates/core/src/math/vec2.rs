//! Vectors of two f64 in the slicing plane as plain arrays.

/// Coordinates of `p` along and across the unit vector `tangent`, seen from `origin`.
pub(crate) fn local(tangent: [f64; 2], origin: [f64; 2], p: [f64; 2]) -> (f64, f64) {
    let d = sub(p, origin);
    (dot(d, tangent), dot(d, left(tangent)))
}

/// `a + s b`.
pub(crate) fn along(a: [f64; 2], b: [f64; 2], s: f64) -> [f64; 2] {
    [a[0] + s * b[0], a[1] + s * b[1]]
}

/// `a - b`.
pub(crate) fn sub(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// Scalar product.
pub(crate) fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The third coordinate of the vector product: positive if `b` lies to the left of `a`.
pub(crate) fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// `a` turned left by a right angle.
pub(crate) fn left(a: [f64; 2]) -> [f64; 2] {
    [-a[1], a[0]]
}

/// Distance of two points.
pub(crate) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let d = sub(a, b);
    dot(d, d).sqrt()
}

/// The unit vector of `a`, or zero if it has no length.
pub(crate) fn unit(a: [f64; 2]) -> [f64; 2] {
    let length = dot(a, a).sqrt();
    if length > 0.0 { [a[0] / length, a[1] / length] } else { [0.0; 2] }
}

/// The mean of at least one point; sums run relative to the first.
pub(crate) fn mean(points: &[[f64; 2]]) -> [f64; 2] {
    let first = points[0];
    let sum = points.iter().fold([0.0; 2], |s, &p| along(s, sub(p, first), 1.0));
    along(first, sum, 1.0 / points.len() as f64)
}

/// The distances along `a` from `p`, and along `b` from `q`, at which the two lines meet; `None` if they are parallel.
pub(crate) fn meet(p: [f64; 2], a: [f64; 2], q: [f64; 2], b: [f64; 2]) -> Option<(f64, f64)> {
    let denominator = cross(a, b);
    if denominator.abs() < 1e-9 {
        return None;
    }
    let d = sub(q, p);
    Some((cross(d, b) / denominator, cross(d, a) / denominator))
}

/// The point of the segment `a` to `b` nearest to `p` as a share of the segment, and its distance.
pub(crate) fn onto(a: [f64; 2], b: [f64; 2], p: [f64; 2]) -> (f64, f64) {
    let d = sub(b, a);
    let length2 = dot(d, d);
    let share = if length2 > 0.0 { (dot(sub(p, a), d) / length2).clamp(0.0, 1.0) } else { 0.0 };
    (share, distance(p, along(a, d, share)))
}
