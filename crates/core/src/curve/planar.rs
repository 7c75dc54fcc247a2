//! Sums over points of a plane from which the squared distances to their best line and circle follow without another look at them.
//!
//! The circle is Taubin's (Estimation of planar curves, surfaces, and nonplanar space curves defined by implicit equations, 1991;
//! Chernov, Circular and Linear Regression, 2010, section 5.8): the algebraic distance over its mean gradient, which unlike the plain
//! algebraic fit is right for short arcs under noise.

use super::moments::Squares;
use crate::math::vec2::{along, dot, sub};

/// Determinant of the spread, relative to its square, below which points lie on a line.
const STRAIGHT: f64 = 1e-14;
/// Newton's steps to the least root of the characteristic polynomial.
const STEPS: usize = 12;

/// Weighted sums over points relative to `reference`: of `w`, `w p`, `w p p^T`, `w |p|^2 p` and `w |p|^4`.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct PlaneMoments {
    reference: [f64; 2],
    /// Sum of the weights.
    pub weight: f64,
    first: [f64; 2],
    /// xx, xy, yy.
    second: [f64; 3],
    third: [f64; 2],
    fourth: f64,
}

impl PlaneMoments {
    /// Of no point.
    pub(crate) fn at(reference: [f64; 2]) -> Self {
        Self { reference, ..Self::default() }
    }

    /// Adds a point.
    pub(crate) fn push(&mut self, point: [f64; 2], weight: f64) {
        let p = sub(point, self.reference);
        let square = dot(p, p);
        self.weight += weight;
        self.first = along(self.first, p, weight);
        let products = [p[0] * p[0], p[0] * p[1], p[1] * p[1]];
        self.second.iter_mut().zip(products).for_each(|(s, x)| *s += weight * x);
        self.third = along(self.third, p, weight * square);
        self.fourth += weight * square * square;
    }

    /// The mean of the points.
    pub(crate) fn mean(&self) -> [f64; 2] {
        along(self.reference, self.first, 1.0 / self.weight)
    }

    /// The standard deviation of the points along their longest axis.
    pub(crate) fn spread(&self) -> f64 {
        let [xx, xy, yy] = self.moved(self.mean()).second.map(|x| x / self.weight);
        greater(xx, xy, yy).max(0.0).sqrt()
    }

    /// Squared distances across a direction from the line along it through the mean.
    pub(crate) fn across(&self, direction: [f64; 2]) -> f64 {
        let [xx, xy, yy] = self.moved(self.mean()).second;
        let [x, y] = direction;
        (xx * y * y - 2.0 * xy * x * y + yy * x * x).max(0.0)
    }

    /// The same points relative to another reference.
    fn moved(&self, reference: [f64; 2]) -> Self {
        let d = sub(self.reference, reference);
        let dd = dot(d, d);
        let Self { weight, first, second: [xx, xy, yy], third, fourth, .. } = *self;
        let second_d = [xx * d[0] + xy * d[1], xy * d[0] + yy * d[1]];
        let (square, first_d) = (xx + yy, dot(first, d));
        // Sum of (|p|^2 + 2 d.p + |d|^2) (p + d), and of its square.
        let over = square + 2.0 * first_d + weight * dd;
        let mixed = along(along(third, second_d, 2.0), first, dd);
        Self {
            reference,
            weight,
            first: along(first, d, weight),
            second: [
                xx + 2.0 * first[0] * d[0] + weight * d[0] * d[0],
                xy + first[0] * d[1] + first[1] * d[0] + weight * d[0] * d[1],
                yy + 2.0 * first[1] * d[1] + weight * d[1] * d[1],
            ],
            third: along(mixed, d, over),
            fourth: fourth
                + 4.0 * dot(d, second_d)
                + weight * dd * dd
                + 4.0 * dot(d, third)
                + 2.0 * dd * square
                + 4.0 * dd * first_d,
        }
    }

    /// Adds the points of another.
    pub(crate) fn add(&mut self, other: &PlaneMoments) {
        let other = other.moved(self.reference);
        self.weight += other.weight;
        self.first = along(self.first, other.first, 1.0);
        self.second.iter_mut().zip(other.second).for_each(|(a, b)| *a += b);
        self.third = along(self.third, other.third, 1.0);
        self.fourth += other.fourth;
    }

    /// Squared distances from the best line and the best circle.
    pub(crate) fn squares(&self) -> Squares {
        if self.weight <= 0.0 {
            return Squares { line: 0.0, circle: f64::INFINITY };
        }
        let centred = self.moved(self.mean());
        let [xx, xy, yy] = centred.second.map(|x| x / self.weight);
        let (trace, determinant) = (xx + yy, (xx * yy - xy * xy).max(0.0));
        // The lesser eigenvalue, without the difference of like numbers.
        let greater = greater(xx, xy, yy);
        let line = if greater > 0.0 { self.weight * determinant / greater } else { 0.0 };
        if determinant <= STRAIGHT * trace * trace {
            return Squares { line, circle: f64::INFINITY };
        }
        let [xz, yz] = centred.third.map(|x| x / self.weight);
        let spread = centred.fourth / self.weight - trace * trace;
        let polynomial = [
            xz * (xz * yy - yz * xy) + yz * (yz * xx - xz * xy) - spread * determinant,
            spread * trace + 4.0 * determinant * trace - xz * xz - yz * yz,
            -3.0 * trace * trace - (spread + trace * trace),
            4.0 * trace,
        ];
        Squares { line, circle: self.weight * least_root(polynomial).min(trace) }
    }
}

/// The greater eigenvalue of a symmetric matrix.
fn greater(xx: f64, xy: f64, yy: f64) -> f64 {
    0.5 * (xx + yy) + (0.25 * (xx - yy) * (xx - yy) + xy * xy).sqrt()
}

/// The least root, from below, of a cubic whose roots are the mean squared distances of algebraic circles.
fn least_root([a, b, c, d]: [f64; 4]) -> f64 {
    let mut x = 0.0;
    for _ in 0..STEPS {
        let (value, slope) = (a + x * (b + x * (c + x * d)), b + x * (2.0 * c + 3.0 * x * d));
        let next = x - value / slope;
        if !next.is_finite() || next <= x {
            break;
        }
        x = next;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::circle::Circle;
    use crate::math::uniform::uniform;

    fn noisy(sweep: f64, noise: f64) -> Vec<[f64; 2]> {
        let mut uniform = uniform(5);
        let mut normal = || (0..12).map(|_| uniform()).sum::<f64>() - 6.0;
        let at = |k: i32| {
            let (s, c) = (f64::from(k) * sweep / 60.0).sin_cos();
            let r = 20.0 + noise * normal();
            [300.0 + r * c, r * s - 40.0]
        };
        (0..60).map(at).collect()
    }

    fn sum(points: &[[f64; 2]]) -> PlaneMoments {
        let mut sum = PlaneMoments::at([290.0, 0.0]);
        points.iter().for_each(|&p| sum.push(p, 1.5));
        sum
    }

    #[test]
    fn squares_are_those_of_the_geometric_circle_also_of_short_arcs() {
        for sweep in [0.5, 1.0, 3.0, 6.2] {
            let points = noisy(sweep, 0.2);
            let circle = Circle::fit(&points).unwrap();
            let squares: f64 = points.iter().map(|&p| 1.5 * circle.off(p).powi(2)).sum();
            let found = sum(&points).squares().circle;
            assert!((found - squares).abs() < 0.02 * squares, "{found} for {squares} at {sweep}");
        }
    }

    #[test]
    fn a_circle_has_no_squares_and_a_line_none() {
        let squares = sum(&noisy(2.0, 0.0)).squares();
        assert!(squares.circle < 1e-7 && squares.line > 100.0, "{squares:?}");
        let line: Vec<[f64; 2]> = (0..20).map(|k| [f64::from(k), 3.0 * f64::from(k)]).collect();
        assert!(sum(&line).squares().line < 1e-7);
    }

    #[test]
    fn sums_in_parts_are_sums_of_the_whole() {
        let points = noisy(1.0, 0.3);
        let (mut a, b) = (sum(&points[..25]), sum(&points[25..]));
        a.add(&b.moved([310.0, -20.0]));
        let (x, y) = (sum(&points).squares(), a.squares());
        assert!((x.line - y.line).abs() < 1e-7 * x.line, "{x:?} {y:?}");
        assert!((x.circle - y.circle).abs() < 1e-5 * x.circle, "{x:?} {y:?}");
    }
}
