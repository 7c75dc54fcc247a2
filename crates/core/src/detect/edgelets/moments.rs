//! Sums over the points of a piece of a cross-section, from which its parabola follows in constant time.

use super::section::Across;
use crate::math::least_squares::solve;

/// Weight of the normals, per point, beside the places in the choice of the axis: a piece of few points has its axis along them.
const NORMALS: f64 = 0.3;
/// Standard deviation of the slope at the middle of a piece against its axis.
const SLOPE: f64 = 0.5;
/// Curvature that is expected of a piece, per spacing: standard deviation.
const CURVATURE: f64 = 0.08;
/// Binomial coefficients.
const CHOOSE: [[f64; 5]; 5] = [
    [1.0, 0.0, 0.0, 0.0, 0.0],
    [1.0, 1.0, 0.0, 0.0, 0.0],
    [1.0, 2.0, 1.0, 0.0, 0.0],
    [1.0, 3.0, 3.0, 1.0, 0.0],
    [1.0, 4.0, 6.0, 4.0, 1.0],
];

/// Sums of `x^i y^j` for `i + j <= 4`, row `j`, and of the products of the normals.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Moments {
    sum: [[f64; 5]; 5],
    normal: [f64; 3],
}

/// `v = c0 + c1 u + c2 u^2` over an axis through the origin of the section: the most likely parabola under a prior that pieces are
/// nearly straight.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parabola {
    /// Unit axis of `u`; `v` is measured to its left.
    pub(super) axis: [f64; 2],
    pub(super) c: [f64; 3],
    /// Sum of squares over the variance, the prior's included.
    pub(super) cost: f64,
    /// Matrix of the normal equations, the inverse of the covariance times the variance.
    pub(super) normal: [[f64; 3]; 3],
}

impl Moments {
    pub(super) fn add(&mut self, p: &Across) {
        let [x, y] = p.raw;
        let mut row = 1.0;
        for (j, sums) in self.sum.iter_mut().enumerate() {
            let mut term = row;
            for sum in &mut sums[..5 - j] {
                *sum += term;
                term *= x;
            }
            row *= y;
        }
        let [a, b] = p.normal;
        self.normal[0] += a * a;
        self.normal[1] += a * b;
        self.normal[2] += b * b;
    }

    /// The sums over both pieces.
    pub(super) fn with(&self, other: &Moments) -> Moments {
        let mut m = *self;
        m.sum.iter_mut().flatten().zip(other.sum.iter().flatten()).for_each(|(a, b)| *a += b);
        m.normal.iter_mut().zip(other.normal).for_each(|(a, b)| *a += b);
        m
    }

    /// The number of points.
    pub(super) fn count(&self) -> f64 {
        self.sum[0][0]
    }

    /// The parabola of the points, each with the given variance across it; `None` for fewer than two points.
    pub(super) fn fit(&self, variance: f64) -> Option<Parabola> {
        let n = self.count();
        if n < 2.0 {
            return None;
        }
        let axis = self.axis();
        let s = self.along(axis);
        let [x1, x2, x3, x4] = [s[0][1], s[0][2], s[0][3], s[0][4]];
        let [y1, xy, xxy, yy] = [s[1][0], s[1][1], s[1][2], s[2][0]];
        let bend = variance / (CURVATURE * CURVATURE);
        let slope = variance / (SLOPE * SLOPE);
        let twice = 2.0 * x1 / n;
        let normal = [
            [n, x1, x2],
            [x1, x2 + slope, x3 + slope * twice],
            [x2, x3 + slope * twice, x4 + bend + slope * twice * twice],
        ];
        let right = [y1, xy, xxy];
        let c = solve(normal, right)?;
        let rest = yy - c[0] * right[0] - c[1] * right[1] - c[2] * right[2];
        Some(Parabola { axis, c, cost: rest.max(0.0) / variance, normal })
    }

    /// The direction along the piece.
    fn axis(&self) -> [f64; 2] {
        let (s, n) = (&self.sum, self.count());
        let (mx, my) = (s[0][1] / n, s[1][0] / n);
        let xx = s[0][2] - n * mx * mx + NORMALS * self.normal[2];
        let xy = s[1][1] - n * mx * my - NORMALS * self.normal[1];
        let yy = s[2][0] - n * my * my + NORMALS * self.normal[0];
        // The eigenvector of the greater value, from the row that does not cancel.
        let half = 0.5 * (xx - yy);
        let root = half.hypot(xy);
        let [a, b] = if half >= 0.0 { [half + root, xy] } else { [xy, root - half] };
        let length = a.hypot(b);
        if length > 0.0 { [a / length, b / length] } else { [1.0, 0.0] }
    }

    /// Sums of `u^i v^j`, row `j`, in the axes along and to the left of a unit direction.
    fn along(&self, [a, b]: [f64; 2]) -> [[f64; 5]; 3] {
        let powers = |x: f64| [1.0, x, x * x, x * x * x, x * x * x * x];
        let (a, b) = (powers(a), powers(b));
        let mut sums = [[0.0; 5]; 3];
        for (q, p) in [(0, 1), (0, 2), (0, 3), (0, 4), (1, 0), (1, 1), (1, 2), (2, 0)] {
            // (a x + b y)^p (a y - b x)^q, multiplied out.
            for i in 0..=p {
                for j in 0..=q {
                    let sign = if (q - j) % 2 == 0 { 1.0 } else { -1.0 };
                    let factor = CHOOSE[p][i] * CHOOSE[q][j] * a[p - i + j] * b[i + q - j];
                    sums[q][p] += sign * factor * self.sum[i + j][p - i + q - j];
                }
            }
        }
        sums
    }
}

impl Parabola {
    /// `v - c0 - c1 u - c2 u^2` at `p`, its gradient there, and `u`.
    pub(super) fn value(&self, p: [f64; 2]) -> (f64, [f64; 2], f64) {
        let [a, b] = self.axis;
        let (u, v) = (p[0] * a + p[1] * b, p[1] * a - p[0] * b);
        let slope = self.c[1] + 2.0 * self.c[2] * u;
        let off = v - self.c[0] - u * (self.c[1] + self.c[2] * u);
        (off, [-b - slope * a, a - slope * b], u)
    }

    /// Standard deviation of the height at `u`, for points with the given variance.
    pub(super) fn deviation(&self, u: f64, variance: f64) -> f64 {
        let row = [1.0, u, u * u];
        let x = solve(self.normal, row).unwrap_or([f64::INFINITY; 3]);
        (variance * (row[0] * x[0] + row[1] * x[1] + row[2] * x[2])).max(0.0).sqrt()
    }
}
