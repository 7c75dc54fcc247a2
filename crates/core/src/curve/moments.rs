//! Sums over points from which the squared distances to their best line and circle follow without another look at them.
//!
//! The sums are those of a weight `w`: `w`, `w p`, `w p p^T`, `w |p|^2 p` and `w |p|^4`, with `p` relative to a reference. They add, and move to
//! another reference, in constant time. A circle's distance is the algebraic one over its gradient (Chernov, Circular and
//! Linear Regression, 2010, section 5.1): `(|p - c|^2 - r^2) / 2r`, least squares of which are linear.

use crate::math::eigen3::{Eigen3, Symmetric3, eigen3};
use crate::math::vec3::{add_scaled, dot, sub};

/// Spread across a line, relative to that along it, below which points bend too little for a circle.
const STRAIGHT: f64 = 1e-10;

/// Weighted sums over points relative to `reference`.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Moments {
    reference: [f64; 3],
    /// Sum of the weights.
    pub weight: f64,
    first: [f64; 3],
    second: Symmetric3,
    third: [f64; 3],
    fourth: f64,
}

/// The weighted squared distances of points from their best curves.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Squares {
    /// From the line of least squares.
    pub line: f64,
    /// From the circle, across its plane and within it; infinite where the points do not bend.
    pub circle: f64,
}

fn trace(m: &Symmetric3) -> f64 {
    m[0] + m[3] + m[5]
}

fn times(m: &Symmetric3, v: [f64; 3]) -> [f64; 3] {
    [
        m[0] * v[0] + m[1] * v[1] + m[2] * v[2],
        m[1] * v[0] + m[3] * v[1] + m[4] * v[2],
        m[2] * v[0] + m[4] * v[1] + m[5] * v[2],
    ]
}

/// Adds `s (a b^T + b a^T) / 2`.
fn add_product(m: &mut Symmetric3, a: [f64; 3], b: [f64; 3], s: f64) {
    for (k, (i, j)) in [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)].into_iter().enumerate() {
        m[k] += 0.5 * s * (a[i] * b[j] + a[j] * b[i]);
    }
}

impl Moments {
    /// Of no point.
    pub(crate) fn at(reference: [f64; 3]) -> Self {
        Self { reference, ..Self::default() }
    }

    /// Adds a point; a negative weight takes it away again.
    pub(crate) fn push(&mut self, point: [f64; 3], weight: f64) {
        let p = sub(point, self.reference);
        let square = dot(p, p);
        self.weight += weight;
        self.first = add_scaled(self.first, p, weight);
        add_product(&mut self.second, p, p, weight);
        self.third = add_scaled(self.third, p, weight * square);
        self.fourth += weight * square * square;
    }

    /// The same points relative to another reference.
    pub(crate) fn moved(&self, reference: [f64; 3]) -> Self {
        let d = sub(self.reference, reference);
        let dd = dot(d, d);
        let Self { weight, first, second, third, fourth, .. } = *self;
        let (q, second_d) = (trace(&second), times(&second, d));
        let mut moved = Self { reference, weight, first: add_scaled(first, d, weight), ..Self::default() };
        moved.second = second;
        add_product(&mut moved.second, first, d, 2.0);
        add_product(&mut moved.second, d, d, weight);
        // Sum of (|p|^2 + 2 d.p + |d|^2) (p + d).
        let along = q + 2.0 * dot(d, first) + weight * dd;
        let mixed = add_scaled(add_scaled(third, second_d, 2.0), first, dd);
        moved.third = add_scaled(mixed, d, along);
        moved.fourth = fourth
            + 4.0 * dot(d, second_d)
            + weight * dd * dd
            + 4.0 * dot(d, third)
            + 2.0 * dd * q
            + 4.0 * dd * dot(d, first);
        moved
    }

    /// Adds what another has summed.
    pub(crate) fn add(&mut self, other: &Moments) {
        let other = other.moved(self.reference);
        self.weight += other.weight;
        self.first = add_scaled(self.first, other.first, 1.0);
        self.second.iter_mut().zip(other.second).for_each(|(a, b)| *a += b);
        self.third = add_scaled(self.third, other.third, 1.0);
        self.fourth += other.fourth;
    }

    /// The sums relative to the mean, and the axes of the points' spread.
    fn centred(&self) -> (Moments, Eigen3) {
        let mean = add_scaled(self.reference, self.first, 1.0 / self.weight);
        let centred = self.moved(mean);
        let axes = eigen3(&centred.second.map(|x| x / self.weight));
        (centred, axes)
    }

    /// Squared distances from the best line and the best circle.
    pub(crate) fn squares(&self) -> Squares {
        if self.weight <= 0.0 {
            return Squares { line: 0.0, circle: f64::INFINITY };
        }
        let (centred, axes) = self.centred();
        let [across, inner, longest] = axes.values.map(|v| v.max(0.0));
        let line = self.weight * (across + inner);
        if inner <= STRAIGHT * longest {
            return Squares { line, circle: f64::INFINITY };
        }
        // With z = |d|^2: least squares of z - 2 a u - 2 b v - c over the plane's axes u and v.
        let mean_square = trace(&centred.second) / self.weight;
        let third = [axes.vectors[1], axes.vectors[2]].map(|v| dot(v, centred.third) / self.weight);
        let explained = third[0] * third[0] / inner + third[1] * third[1] / longest;
        let rest = (centred.fourth / self.weight - mean_square * mean_square - explained).max(0.0);
        let centre = [0.5 * third[0] / inner, 0.5 * third[1] / longest];
        let radius2 = centre[0] * centre[0] + centre[1] * centre[1] + mean_square;
        Squares { line, circle: self.weight * (rest / (4.0 * radius2) + across) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arc(k: i32) -> [f64; 3] {
        let (s, c) = (f64::from(k) * 0.1).sin_cos();
        [100.0 + 7.0 * c, 3.0, 7.0 * s - 40.0]
    }

    #[test]
    fn a_circle_has_no_squares_and_a_line_none() {
        let mut m = Moments::at([90.0, 0.0, 0.0]);
        (0..20).for_each(|k| m.push(arc(k), 0.5));
        let squares = m.squares();
        assert!(squares.circle < 1e-8 && squares.line > 1.0, "{squares:?}");
        let mut m = Moments::at([0.0; 3]);
        (0..20).for_each(|k| m.push([f64::from(k), 2.0 * f64::from(k), 5.0], 1.0));
        assert!(m.squares().line < 1e-9);
    }

    #[test]
    fn sums_in_parts_are_sums_of_the_whole() {
        let (mut whole, mut a, mut b) = (Moments::at(arc(0)), Moments::at(arc(0)), Moments::at(arc(11)));
        (0..20).for_each(|k| whole.push(arc(k * k % 61), 1.5));
        (0..11).for_each(|k| a.push(arc(k * k % 61), 1.5));
        (11..20).for_each(|k| b.push(arc(k * k % 61), 1.5));
        a.add(&b);
        let (x, y) = (whole.squares(), a.squares());
        assert!((x.line - y.line).abs() < 1e-9 * x.line && (x.circle - y.circle).abs() < 1e-7, "{x:?} {y:?}");
    }
}
