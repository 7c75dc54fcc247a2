//! Least-squares circles in space.

use super::circle::Circle;
use crate::math::eigen3::eigen3;
use crate::math::vec3::{add_scaled, cross, distance, dot, norm, perpendicular, scale, sub, unit};

/// A circle in space.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Round {
    /// Its centre.
    pub centre: [f64; 3],
    /// Unit normal of its plane.
    pub normal: [f64; 3],
    /// Its radius.
    pub radius: f64,
}

/// Distance of two points, in radii, below which they are the same.
const SAME: f64 = 1e-9;
/// Mean height of points over the chord, in halves of the chord, from which on they are more than half a turn.
const FAR_SIDE: f64 = 0.3;
/// Half the distance of the ends of a whole circle, in radii.
const CLOSED: f64 = 1e-6;
/// Least sagitta of an arc, in halves of its chord.
const STRAIGHT: f64 = 1e-6;
/// Factor of a sagitta where a step would turn it over.
const FLATTER: f64 = 0.1;
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

    /// The angle counter-clockwise about the normal from one point to another; a full turn where they are the same.
    pub(crate) fn sweep_between(&self, from: [f64; 3], to: [f64; 3]) -> f64 {
        let full = std::f64::consts::TAU;
        if distance(from, to) <= SAME * self.radius { full } else { self.sweep(&[from, to]).rem_euclid(full) }
    }

    /// `count` points over the angle `sweep` about the normal, from the foot of `from` on.
    pub(crate) fn samples(&self, from: [f64; 3], sweep: f64, count: usize) -> Vec<[f64; 3]> {
        let zero = unit(sub(self.foot(from), self.centre));
        let other = cross(self.normal, zero);
        let at = |k: usize| {
            let (sin, cos) = (sweep * k as f64 / (count - 1) as f64).sin_cos();
            add_scaled(self.centre, add_scaled(scale(zero, cos), other, sin), self.radius)
        };
        (0..count).map(at).collect()
    }

    /// The circle through `from` and `to` that fits the points best, in the plane through both that is nearest to its own. Its radius
    /// counts as one more observation of the weight `hold`, that of a point being one.
    pub(crate) fn through(
        &self,
        from: [f64; 3],
        to: [f64; 3],
        points: &[[f64; 3]],
        hold: f64,
    ) -> Option<Self> {
        let chord = sub(to, from);
        let half = 0.5 * norm(chord);
        if half <= CLOSED * self.radius {
            // Points that go round, or points too near to each other for an arc of this radius.
            points.iter().position(|&p| distance(p, from) > self.radius)?;
            let towards = unit(sub(self.foot(from), self.centre));
            return Some(Self { centre: add_scaled(from, towards, -self.radius), ..*self });
        }
        let along = unit(chord);
        let normal = unit(sub(self.normal, along.map(|x| x * dot(self.normal, along))));
        let across = cross(normal, along);
        let middle = add_scaled(from, chord, 0.5);
        let flat: Vec<[f64; 2]> =
            points.iter().map(|&p| sub(p, middle)).map(|d| [dot(d, along), dot(d, across)]).collect();
        let start = dot(sub(self.centre, middle), across);
        let height = height(&flat, half, start, (self.radius, hold))?;
        let centre = add_scaled(middle, across, height);
        Some(Self { centre, normal, radius: height.hypot(half) })
    }
}

/// The centre's height over the middle of a chord from `-half` to `half` for the least squared distances of points, and of the radius
/// from another with a weight. The unknown is the sagitta, the height of the arc: the distances of the points change evenly with
/// it however little the arc bends. `None` where it does not bend.
fn height(points: &[[f64; 2]], half: f64, start: f64, (known, hold): (f64, f64)) -> Option<f64> {
    let mean = points.iter().map(|p| p[1]).sum::<f64>() / points.len() as f64;
    // Beyond a half turn the arc lies on the side of its centre; half a turn has its mean 2/pi of its radius from the chord.
    let side = if mean * start.signum() > FAR_SIDE * half { start.signum() } else { -start.signum() };
    let first = known.max(half);
    let mut sagitta = (first * first - half * half).sqrt().copysign(start) + side * first;
    for _ in 0..STEPS {
        let (height, radius) = of_sagitta(sagitta, half);
        let rise = 0.5 + 0.5 * (half / sagitta).powi(2);
        let lean = (1.0 - rise) * sagitta.signum();
        let (mut top, mut bottom) = (hold * lean * (radius - known), hold * lean * lean);
        for &[x, y] in points {
            let off = x.hypot(y - height);
            if off > 0.0 {
                let slope = -(y - height) / off * rise - lean;
                top += slope * (off - radius);
                bottom += slope * slope;
            }
        }
        if bottom <= 0.0 {
            break;
        }
        let next = sagitta - top / bottom;
        // Not to the other side of the chord at once.
        sagitta = if next * sagitta > 0.0 { next } else { FLATTER * sagitta };
    }
    (sagitta.abs() > STRAIGHT * half).then(|| of_sagitta(sagitta, half).0)
}

/// Height of the centre and radius of an arc over a chord from `-half` to `half`.
fn of_sagitta(sagitta: f64, half: f64) -> (f64, f64) {
    let square = half * half / sagitta;
    (0.5 * (sagitta - square), 0.5 * (sagitta + square).abs())
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

#[cfg(test)]
mod tests {
    use super::*;

    const AXIS: [f64; 3] = [0.0, 0.0, 1.0];

    fn round(radius: f64) -> Round {
        Round { centre: [3.0, -2.0, 1.0], normal: AXIS, radius }
    }

    #[test]
    fn an_arc_through_its_ends_is_found_however_little_or_far_it_turns() {
        for (radius, sweep) in [(1e5, 1e-3), (100.0, 0.2), (5.0, 1.5), (5.0, 3.1), (5.0, 3.2), (5.0, 6.0)] {
            let points = round(radius).samples([1e6, 7.0, 1.0], sweep, 40);
            let other = Round { radius: 1.3 * radius, ..round(radius) };
            let found = other.through(points[0], points[39], &points, 0.0).unwrap();
            assert!((found.radius - radius).abs() < 1e-6 * radius, "{} for {radius}, {sweep}", found.radius);
            assert!(distance(found.centre, [3.0, -2.0, 1.0]) < 1e-5 * radius, "{radius}, {sweep}");
            assert!((found.sweep_between(points[0], points[39]) - sweep).abs() < 1e-5);
        }
    }

    #[test]
    fn a_radius_that_is_held_stays_where_the_ends_are_aside() {
        let points = round(5.0).samples([9.0, 0.0, 1.0], 0.5, 40);
        let aside = |p: [f64; 3]| add_scaled(p, sub(p, [3.0, -2.0, 1.0]), 0.02);
        let [free, held] = [0.0, 400.0].map(|hold| {
            let round = round(5.0).through(aside(points[0]), aside(points[39]), &points, hold);
            round.unwrap().radius
        });
        assert!((free - 5.0).abs() > 0.5 && (held - 5.0).abs() < 0.1, "{free} {held}");
    }

    #[test]
    fn points_along_the_chord_are_no_arc() {
        let points: Vec<[f64; 3]> = (0..20).map(|k| [f64::from(k), 0.0, 0.0]).collect();
        for radius in [1e12, 1e5, 15.0] {
            assert_eq!(round(radius).through(points[0], points[19], &points, 0.0), None);
        }
    }
}
