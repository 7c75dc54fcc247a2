//! Least-squares circles in the plane.

use crate::math::vec2::{along, distance, dot, mean, sub, unit};

/// A circle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Circle {
    /// Its centre.
    pub centre: [f64; 2],
    /// Its radius.
    pub radius: f64,
}

impl Circle {
    /// The circle of least squared distances: an algebraic start, then Gauss-Newton steps on the distances. `None` for points
    /// without a circle.
    pub(crate) fn fit(points: &[[f64; 2]]) -> Option<Self> {
        if points.len() < 3 {
            return None;
        }
        let origin = mean(points);
        let local: Vec<[f64; 2]> = points.iter().map(|&p| sub(p, origin)).collect();
        let mut round = algebraic(&local)?;
        for _ in 0..4 {
            round = step(&local, round)?;
        }
        let centre = along(origin, round.centre, 1.0);
        (round.radius.is_finite() && round.radius > 0.0).then_some(Self { centre, ..round })
    }

    /// Distance of a point from the circle.
    pub(crate) fn off(&self, p: [f64; 2]) -> f64 {
        (distance(p, self.centre) - self.radius).abs()
    }

    /// The point of the circle nearest to `p`.
    pub(crate) fn foot(&self, p: [f64; 2]) -> [f64; 2] {
        along(self.centre, unit(sub(p, self.centre)), self.radius)
    }
}

/// Least squares of x^2 + y^2 - 2ax - 2by - c over points around the origin.
fn algebraic(points: &[[f64; 2]]) -> Option<Circle> {
    let (mut xx, mut xy, mut yy, mut xz, mut yz, mut zz) = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    for &[x, y] in points {
        let z = x * x + y * y;
        xx += x * x;
        xy += x * y;
        yy += y * y;
        xz += x * z;
        yz += y * z;
        zz += z;
    }
    let determinant = xx * yy - xy * xy;
    if determinant <= 1e-10 * (xx + yy) * (xx + yy) {
        return None;
    }
    let centre = [0.5 * (xz * yy - yz * xy) / determinant, 0.5 * (yz * xx - xz * xy) / determinant];
    Some(Circle { centre, radius: (dot(centre, centre) + zz / points.len() as f64).sqrt() })
}

fn step(points: &[[f64; 2]], round: Circle) -> Option<Circle> {
    // Unknowns: the changes of the centre and of the radius.
    let mut a = [[0.0; 3]; 3];
    let mut b = [0.0; 3];
    for &p in points {
        let d = sub(p, round.centre);
        let r = dot(d, d).sqrt();
        if r <= 0.0 {
            return None;
        }
        let row = [d[0] / r, d[1] / r, 1.0];
        for i in 0..3 {
            b[i] += row[i] * (r - round.radius);
            for j in 0..3 {
                a[i][j] += row[i] * row[j];
            }
        }
    }
    let shift = solve3(a, b)?;
    Some(Circle {
        centre: [round.centre[0] + shift[0], round.centre[1] + shift[1]],
        radius: round.radius + shift[2],
    })
}

/// Cramer's rule; `None` for a matrix that is singular to rounding.
pub(super) fn solve3(a: [[f64; 3]; 3], b: [f64; 3]) -> Option<[f64; 3]> {
    let minor = |m: [[f64; 3]; 3]| {
        m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
            + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
    };
    let determinant = minor(a);
    if determinant.abs() <= 1e-12 * a[0][0].max(a[1][1]).max(a[2][2]).powi(3) {
        return None;
    }
    let column = |k: usize| {
        let mut m = a;
        (0..3).for_each(|i| m[i][k] = b[i]);
        minor(m) / determinant
    };
    Some([column(0), column(1), column(2)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_noisy_arcs_give_their_circle() {
        let at = |k: i32| {
            let angle = f64::from(k) * 0.02;
            let r = 50.0 + 0.01 * f64::from((k * 7) % 5 - 2);
            [1e5 + r * angle.cos(), -3.0 + r * angle.sin()]
        };
        let points: Vec<[f64; 2]> = (0..40).map(at).collect();
        let round = Circle::fit(&points).unwrap();
        assert!((round.radius - 50.0).abs() < 0.5 && distance(round.centre, [1e5, -3.0]) < 0.5);
        assert!(Circle::fit(&[[0.0, 1.0], [1.0, 2.0], [2.0, 3.0]]).is_none());
    }
}
