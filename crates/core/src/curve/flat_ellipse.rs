//! Least-squares ellipses in the plane: an algebraic start, then Gauss-Newton steps on the distances (Ahn, Rauh and Warnecke 2001, Least-squares
//! orthogonal distances fitting of circle, sphere, ellipse, hyperbola, and parabola).

use crate::math::least_squares::{inverse, least_squares, solve};
use crate::math::vec2::{along, dot, left, sub};

/// Steps of Gauss and Newton, and how often one of them is halved.
const STEPS: usize = 12;
const HALVINGS: usize = 6;
/// Gain of a step, relative to the squares, below which the fit has come to rest.
const REST: f64 = 1e-9;
/// Greatest ratio of the half axes: a flatter ellipse is a line there and back.
const FLATTEST: f64 = 20.0;
/// Newton's steps to the foot of a point.
const FOOT: usize = 60;
/// Unknowns: the centre along both axes, the half axes, the turn.
pub(crate) const UNKNOWNS: usize = 5;

/// An ellipse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FlatEllipse {
    /// Its centre.
    pub centre: [f64; 2],
    /// Its half axes, the greater first.
    pub axes: [f64; 2],
    /// Unit direction of the greater one.
    pub way: [f64; 2],
}

impl FlatEllipse {
    /// The ellipse of least squared distances from points, each with its weight. `None` where they show none.
    pub(crate) fn fit(points: &[([f64; 2], f64)]) -> Option<Self> {
        let mut found = Self::algebraic(points)?;
        let mut squares = found.squares(points);
        for _ in 0..STEPS {
            let (matrix, right) = found.normal_equations(points);
            let step = solve(matrix, right)?;
            let tried = |k: usize| {
                let moved = found.moved(step.map(|s| s * 0.5_f64.powi(k as i32)))?;
                let now = moved.squares(points);
                (now <= squares).then_some((moved, now))
            };
            let Some((moved, now)) = (0..HALVINGS).find_map(tried) else { break };
            let gain = squares - now;
            (found, squares) = (moved, now);
            if gain <= REST * squares {
                break;
            }
        }
        Some(found)
    }

    /// The conic of least squared algebraic distances, its quadratic form of trace 1; `None` where it is no ellipse.
    pub(crate) fn algebraic(points: &[([f64; 2], f64)]) -> Option<Self> {
        let weight: f64 = points.iter().map(|p| p.1).sum();
        let sum = points.iter().fold([0.0; 2], |s, p| along(s, p.0, p.1));
        let mean = sum.map(|x| x / weight);
        let spread: f64 = points.iter().map(|p| p.1 * dot(sub(p.0, mean), sub(p.0, mean))).sum();
        let size = (spread / weight).sqrt();
        let row = |&(p, w): &([f64; 2], f64)| {
            let [x, y] = sub(p, mean).map(|x| x / size);
            let w = w.sqrt();
            ([0.5 * w * (x * x - y * y), w * x * y, w * x, w * y, w], -0.5 * w * (x * x + y * y))
        };
        let [q, b, d, e, f] = least_squares(points.iter().map(row))?;
        let apart = q.hypot(b);
        // The quadratic form ((1 + q, b), (b, 1 - q)) / 2 and its determinant.
        let determinant = 0.25 * (1.0 - apart * apart);
        let sound = determinant > 0.0;
        if !sound {
            return None;
        }
        let solved = |x: f64, y: f64| {
            let (xx, xy, yy) = (0.5 * (1.0 + q), 0.5 * b, 0.5 * (1.0 - q));
            [(yy * x - xy * y) / determinant, (xx * y - xy * x) / determinant]
        };
        let centre = solved(-0.5 * d, -0.5 * e);
        let level = -0.5 * (d * centre[0] + e * centre[1]) - f;
        let axes = [0.5 * (1.0 - apart), 0.5 * (1.0 + apart)].map(|root| (level / root).sqrt() * size);
        let turn = 0.5 * (b.atan2(q) + std::f64::consts::PI);
        Self { centre: along(mean, centre, size), axes, way: [turn.cos(), turn.sin()] }.sound()
    }

    fn sound(self) -> Option<Self> {
        let [a, b] = self.axes;
        (b > 0.0 && a.is_finite() && a <= FLATTEST * b).then_some(self)
    }

    /// With changes of its unknowns.
    fn moved(&self, [x, y, a, b, turn]: [f64; UNKNOWNS]) -> Option<Self> {
        let centre = along(along(self.centre, self.way, x), left(self.way), y);
        let (sin, cos) = turn.sin_cos();
        let way = along(self.way.map(|w| w * cos), left(self.way), sin);
        let axes = [self.axes[0] + a, self.axes[1] + b];
        let crossed = axes[0] < axes[1];
        let (axes, way) = if crossed { ([axes[1], axes[0]], left(way)) } else { (axes, way) };
        Self { centre, axes, way }.sound()
    }

    /// The parameter of the point nearest to `p`, radians.
    pub(crate) fn angle(&self, p: [f64; 2]) -> f64 {
        let d = sub(p, self.centre);
        let [x, y] = [dot(d, self.way), dot(d, left(self.way))];
        let [u, v] = foot(self.axes, [x.abs(), y.abs()]);
        (v / self.axes[1]).copysign(y).atan2((u / self.axes[0]).copysign(x))
    }

    /// The point at a parameter.
    pub(crate) fn at(&self, angle: f64) -> [f64; 2] {
        let (sin, cos) = angle.sin_cos();
        along(along(self.centre, self.way, self.axes[0] * cos), left(self.way), self.axes[1] * sin)
    }

    /// The point nearest to `p`.
    pub(crate) fn foot(&self, p: [f64; 2]) -> [f64; 2] {
        self.at(self.angle(p))
    }

    /// How far a point lies outside, negative inside, and its slopes over the unknowns.
    fn off(&self, p: [f64; 2]) -> (f64, [f64; UNKNOWNS]) {
        let angle = self.angle(p);
        let (sin, cos) = angle.sin_cos();
        let [a, b] = self.axes;
        let length = (b * cos).hypot(a * sin);
        let [u, v] = [b * cos / length, a * sin / length];
        let d = sub(p, self.at(angle));
        let off = dot(d, self.way) * u + dot(d, left(self.way)) * v;
        (off, [-u, -v, -u * cos, -v * sin, u * b * sin - v * a * cos])
    }

    /// The weighted squared distances of points.
    pub(crate) fn squares(&self, points: &[([f64; 2], f64)]) -> f64 {
        points.iter().map(|&(p, w)| w * self.off(p).0.powi(2)).sum()
    }

    fn normal_equations(&self, points: &[([f64; 2], f64)]) -> ([[f64; UNKNOWNS]; UNKNOWNS], [f64; UNKNOWNS]) {
        let (mut matrix, mut right) = ([[0.0; UNKNOWNS]; UNKNOWNS], [0.0; UNKNOWNS]);
        for &(p, w) in points {
            let (off, slopes) = self.off(p);
            for i in 0..UNKNOWNS {
                right[i] -= w * slopes[i] * off;
                (0..UNKNOWNS).for_each(|j| matrix[i][j] += w * slopes[i] * slopes[j]);
            }
        }
        (matrix, right)
    }

    /// Covariance of the centre along both axes, the half axes and the turn, where a point of weight 1 has the error 1.
    pub(crate) fn covariance(&self, points: &[([f64; 2], f64)]) -> Option<[[f64; UNKNOWNS]; UNKNOWNS]> {
        inverse(self.normal_equations(points).0)
    }

    /// The signed change of the parameter along a row of points.
    pub(crate) fn sweep(&self, points: &[[f64; 2]]) -> f64 {
        let angles: Vec<f64> = points.iter().map(|&p| self.angle(p)).collect();
        let turn = |w: &[f64]| (w[1] - w[0]).sin().atan2((w[1] - w[0]).cos());
        angles.windows(2).map(turn).sum()
    }
}

/// The point of an ellipse about the origin nearest to a point of the first quadrant (Eberly 2013, Distance from a point to an ellipse), by
/// Newton's steps from the side on which they do not overshoot.
fn foot([a, b]: [f64; 2], [x, y]: [f64; 2]) -> [f64; 2] {
    if y <= 0.0 {
        let inner = (a * x) / ((a - b) * (a + b));
        // Of a point near the centre on the long axis two feet lie beside the end of the short one.
        return if inner < 1.0 { [a * inner, b * (1.0 - inner * inner).sqrt()] } else { [a, 0.0] };
    }
    let ratio = (a / b).powi(2);
    let (u, v) = (x / a, y / b);
    // One more than the root, which lies near -1 for points near the long axis.
    let mut s = v;
    for _ in 0..FOOT {
        let (p, q) = (ratio * u / (s + ratio - 1.0), v / s);
        let value = p * p + q * q - 1.0;
        let next = s + 0.5 * value / (p * p / (s + ratio - 1.0) + q * q / s);
        if next <= s || !next.is_finite() {
            break;
        }
        s = next;
    }
    [ratio * x / (s + ratio - 1.0), y / s]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::uniform::uniform;
    use crate::math::vec2::distance;

    const TRUE: FlatEllipse = FlatEllipse { centre: [100.0, -40.0], axes: [12.0, 7.0], way: [0.8, -0.6] };

    fn points(sweep: f64, noise: f64, seed: u64) -> Vec<([f64; 2], f64)> {
        let mut uniform = uniform(seed);
        let mut normal = || (0..12).map(|_| uniform()).sum::<f64>() - 6.0;
        let at = |k: usize| TRUE.at(0.3 + sweep * k as f64 / 80.0).map(|x| x + noise * normal());
        (0..80).map(at).map(|p| (p, 1.0)).collect()
    }

    #[test]
    fn the_foot_is_the_nearest_point() {
        for p in
            [[103.0, -41.0], [100.0, -40.0], [112.0, -47.0], [105.6, -44.2], [90.0, -20.0], [100.8, -40.6]]
        {
            let foot = TRUE.foot(p);
            let nearest =
                (0..4000).map(|k| distance(TRUE.at(f64::from(k) * 0.00157), p)).fold(f64::MAX, f64::min);
            assert!(distance(foot, p) <= nearest + 1e-9, "{p:?}: {foot:?}, {nearest}");
        }
    }

    #[test]
    fn an_ellipse_is_found_again_and_the_covariance_tells_how_well() {
        let clean = FlatEllipse::fit(&points(6.0, 0.0, 1)).unwrap();
        assert!(distance(clean.centre, TRUE.centre) < 1e-9 && (clean.axes[0] - 12.0).abs() < 1e-9);
        for sweep in [2.5, 6.0] {
            let (mut inside, trials) = ([0; 2], 400);
            for seed in 0..trials {
                let points = points(sweep, 0.05, seed);
                let found = FlatEllipse::fit(&points).unwrap();
                let known = found.covariance(&points).unwrap();
                for k in 0..2 {
                    let sigma = 0.05 * known[2 + k][2 + k].sqrt();
                    inside[k] += usize::from((found.axes[k] - TRUE.axes[k]).abs() <= 1.96 * sigma);
                }
            }
            assert!(inside.iter().all(|&n| (368..=393).contains(&n)), "{sweep}: {inside:?} of {trials}");
        }
    }

    #[test]
    fn points_along_a_line_or_a_hyperbola_are_none() {
        let line: Vec<([f64; 2], f64)> = (0..30).map(|k| ([f64::from(k), 2.0 * f64::from(k)], 1.0)).collect();
        assert_eq!(FlatEllipse::fit(&line), None);
        let at = |k: i32| [f64::from(k), (25.0 + f64::from(k * k)).sqrt()];
        let hyperbola: Vec<([f64; 2], f64)> = (-15..15).map(|k| (at(k), 1.0)).collect();
        assert_eq!(FlatEllipse::fit(&hyperbola), None);
    }
}
