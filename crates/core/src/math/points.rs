//! Points in any dimension.

/// Squared distance of two points.
pub fn distance2<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    let mut sum = 0.0;
    for axis in 0..D {
        sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
    }
    sum
}

/// Distance of two points.
pub fn distance<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    distance2(a, b).sqrt()
}
