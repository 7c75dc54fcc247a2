//! Least-squares circles in space.

use super::circle::Circle;
use crate::math::eigen3::eigen3;
use crate::math::vec3::{add_scaled, cross, dot, norm, perpendicular, sub, unit};

/// A circle in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Round {
    /// Its centre.
    pub centre: [f64; 3],
    /// Unit normal of its plane.
    pub normal: [f64; 3],
    /// Its radius.
    pub radius: f64,
}

/// Steps of Gauss and Newton for a circle through two points.
const STEPS: usize = 12;

impl Round {
    /// The circle of least squared distances within the plane of least squared distances; `None` for fewer than three points,
    /// or points in a line.
    pub(crate) fn fit(points: &[[f64; 3]]) -> Option<Self> {
        let (origin, [u, v, normal]) = plane(points)?;
        let flat: Vec<[f64; 2]> =
            points.iter().map(|&p| sub(p, origin)).map(|d| [dot(d, u), dot(d, v)]).collect();
        let Circle { centre: [x, y], radius } = Circle::fit(&flat)?;
        Some(Self { centre: add_scaled(add_scaled(origin, u, x), v, y), normal, radius })
    }

    /// The point of the circle nearest to `p`.
    pub(crate) fn foot(&self, p: [f64; 3]) -> [f64; 3] {
        let d = sub(p, self.centre);
        let inside = sub(d, self.normal.map(|x| x * dot(d, self.normal)));
        let towards = if norm(inside) > 0.0 { unit(inside) } else { perpendicular(self.normal) };
        add_scaled(self.centre, towards, self.radius)
    }

    /// The signed angle that a row of points goes about the normal, radians.
    pub(crate) fn sweep(&self, points: &[[f64; 3]]) -> f64 {
        let turn = |w: &[[f64; 3]]| {
            let (a, b) = (sub(w[0], self.centre), sub(w[1], self.centre));
            dot(cross(a, b), self.normal).atan2(dot(a, b) - dot(a, self.normal) * dot(b, self.normal))
        };
        points.windows(2).map(turn).sum()
    }

    /// The circle through `from` and `to` that fits the points best, in the plane through both that is nearest to its own.
    pub(crate) fn through(&self, from: [f64; 3], to: [f64; 3], points: &[[f64; 3]]) -> Option<Self> {
        let chord = sub(to, from);
        let half = 0.5 * norm(chord);
        if half <= 1e-6 * self.radius {
            let towards = unit(sub(self.foot(from), self.centre));
            return Some(Self { centre: add_scaled(from, towards, -self.radius), ..*self });
        }
        let along = unit(chord);
        let normal = unit(sub(self.normal, along.map(|x| x * dot(self.normal, along))));
        let across = cross(normal, along);
        let middle = add_scaled(from, chord, 0.5);
        let flat: Vec<[f64; 2]> =
            points.iter().map(|&p| sub(p, middle)).map(|d| [dot(d, along), dot(d, across)]).collect();
        let height = height(&flat, half, dot(sub(self.centre, middle), across))?;
        let centre = add_scaled(middle, across, height);
        Some(Self { centre, normal, radius: height.hypot(half) })
    }
}

/// The centre's height over the middle of a chord from `-half` to `half` for the least squared distances of points.
fn height(points: &[[f64; 2]], half: f64, start: f64) -> Option<f64> {
    let mut height = start;
    for _ in 0..STEPS {
        let radius = height.hypot(half);
        let (mut top, mut bottom) = (0.0, 0.0);
        for &[x, y] in points {
            let off = x.hypot(y - height);
            if off > 0.0 {
                let slope = -(y - height) / off - height / radius;
                top += slope * (off - radius);
                bottom += slope * slope;
            }
        }
        if bottom <= 0.0 {
            break;
        }
        height -= top / bottom;
    }
    height.is_finite().then_some(height)
}

/// The plane of least squared distances: its origin and two directions in it, the normal last.
pub(crate) fn plane(points: &[[f64; 3]]) -> Option<([f64; 3], [[f64; 3]; 3])> {
    let (&first, count) = (points.first()?, points.len() as f64);
    let sum = points.iter().fold([0.0; 3], |s, &p| add_scaled(s, sub(p, first), 1.0));
    let origin = add_scaled(first, sum, 1.0 / count);
    let mut spread = [0.0; 6];
    for &p in points {
        let [x, y, z] = sub(p, origin);
        [x * x, x * y, x * z, y * y, y * z, z * z].iter().zip(&mut spread).for_each(|(v, s)| *s += v);
    }
    let axes = eigen3(&spread).vectors;
    (count >= 3.0).then_some((origin, [axes[2], axes[1], axes[0]]))
}
