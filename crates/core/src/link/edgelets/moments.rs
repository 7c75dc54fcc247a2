//! Sums over the points of a piece from which its curve follows in constant time.

use super::knobs;
use super::section::Across;
use crate::math::least_squares::solve;

/// Sums of `x^i y^j` for `i + j <= 4`, row `j`, and of the products of the normals.
#[derive(Clone, Copy, Default)]
pub(super) struct Moments {
    sum: [[f64; 5]; 5],
    normal: [f64; 3],
}

/// `y = c0 + c1 x + c2 x^2` over an axis through the origin of the section.
pub(super) struct Parabola {
    pub(super) axis: [f64; 2],
    pub(super) c: [f64; 3],
    /// Sum of squares over the variance.
    pub(super) cost: f64,
}

const CHOOSE: [[f64; 5]; 5] =
    [[1.0, 0.0, 0.0, 0.0, 0.0], [1.0, 1.0, 0.0, 0.0, 0.0], [1.0, 2.0, 1.0, 0.0, 0.0], [1.0, 3.0, 3.0, 1.0, 0.0], [1.0, 4.0, 6.0, 4.0, 1.0]];

impl Moments {
    pub(super) fn add(&mut self, p: &Across) {
        let [x, y] = p.raw;
        let mut yj = 1.0;
        for j in 0..5 {
            let mut xi = yj;
            for i in 0..5 - j {
                self.sum[j][i] += xi;
                xi *= x;
            }
            yj *= y;
        }
        let [a, b] = p.normal;
        self.normal[0] += a * a;
        self.normal[1] += a * b;
        self.normal[2] += b * b;
    }

    pub(super) fn with(&self, other: &Moments) -> Moments {
        let mut m = *self;
        for j in 0..5 {
            for i in 0..5 - j {
                m.sum[j][i] += other.sum[j][i];
            }
        }
        (0..3).for_each(|k| m.normal[k] += other.normal[k]);
        m
    }

    /// Sum of `(ax + by)^p (cx + dy)^q`.
    fn rotated(&self, [a, b]: [f64; 2], p: usize, q: usize) -> f64 {
        // x' = a x + b y, y' = -b x + a y
        let mut total = 0.0;
        for i in 0..=p {
            for j in 0..=q {
                let c = CHOOSE[p][i] * CHOOSE[q][j] * a.powi((p - i) as i32) * b.powi(i as i32) * (-b).powi((q - j) as i32) * a.powi(j as i32);
                total += c * self.sum[i + j][(p - i) + (q - j)];
            }
        }
        total
    }

    pub(super) fn fit(&self, variance: f64) -> Option<Parabola> {
        let n = self.sum[0][0];
        if n < 2.0 {
            return None;
        }
        let (mx, my) = (self.sum[0][1] / n, self.sum[1][0] / n);
        let xx = self.sum[0][2] - n * mx * mx + 0.3 * self.normal[2];
        let xy = self.sum[1][1] - n * mx * my - 0.3 * self.normal[1];
        let yy = self.sum[2][0] - n * my * my + 0.3 * self.normal[0];
        let angle = 0.5 * (2.0 * xy).atan2(xx - yy);
        let axis = [angle.cos(), angle.sin()];
        let s = |p, q| self.rotated(axis, p, q);
        let (x1, x2, x3, x4) = (s(1, 0), s(2, 0), s(3, 0), s(4, 0));
        let (y1, xy1, x2y1, y2) = (s(0, 1), s(1, 1), s(2, 1), s(0, 2));
        // Curvature at the middle of the piece: y = c0 + c1 x + c2 x^2 with priors on c2 and on the slope at the middle.
        let prior = variance / knobs().curve.powi(2);
        let slope = variance / 0.25;
        let middle = 2.0 * x1 / n;
        let m = [
            [n, x1, x2],
            [x1, x2 + slope, x3 + slope * middle],
            [x2, x3 + slope * middle, x4 + prior + slope * middle * middle],
        ];
        let right = [y1, xy1, x2y1];
        let c = solve(m, right)?;
        let cost = y2 - c[0] * right[0] - c[1] * right[1] - c[2] * right[2];
        Some(Parabola { axis, c, cost: cost.max(0.0) / variance })
    }
}
