//! The profile of an edge: two lines that meet in a corner, which is sharp, rounded by an arc that touches both, or cut by a chamfer.

use super::fit::{Fitted, fit};
use super::ramp::Ramp;
use super::walk::Place;
use crate::math::vec2::{along, cross, dot, left, sub, unit};

/// Distance at which the pull of a point ends to grow, in standard deviations.
const FAR: f64 = 3.5;
/// Where chamfers are sought first, in distances to where the arc touches the lines.
const CUTS: [f64; 2] = [0.6, 0.85];
/// Least sine of the angle between the lines.
const PARALLEL: f64 = 0.05;

/// Two lines from a corner, in the plane of a section, spacings.
#[derive(Clone, Copy, Debug)]
pub(super) struct Profile {
    /// Where the lines meet: on the design edge.
    pub(super) corner: [f64; 2],
    /// Unit directions of the lines, away from the corner.
    pub(super) arms: [[f64; 2]; 2],
}

/// What profiles of three kinds leave of the points of a section.
#[derive(Clone, Copy, Debug)]
pub(super) struct Compared {
    /// The lines beside the arc, and its radius.
    pub(super) profile: Profile,
    pub(super) radius: f64,
    /// Standard deviations of the radius and of the corner, for points of unit variance.
    pub(super) radius_sigma: f64,
    pub(super) corner_sigma: f64,
    /// The sums of the squared distances: of the rounded edge, of the sharp one, and of the chamfer.
    pub(super) round: f64,
    pub(super) sharp: f64,
    pub(super) chamfer: f64,
}

impl Profile {
    /// The profile whose lines lie along the faces of a ramp; `None` if they are parallel.
    pub(super) fn of(ramp: &Ramp, places: &[Place]) -> Option<Profile> {
        let [[a, b], [c, d]] = ramp.faces;
        let direction = |outer: usize, inner: usize| {
            let chord = sub(places[outer].at, places[inner].at);
            let (low, high) = (outer.min(inner), outer.max(inner));
            let mean = places[low..=high].iter().fold([0.0; 2], |m, p| along(m, p.tangent, 1.0));
            unit(if dot(chord, mean) < 0.0 { mean.map(|x| -x) } else { mean })
        };
        let arms = [direction(a, b), direction(d, c)];
        let middle = |p: usize, q: usize| places[(p + q) / 2].at;
        let (p, q) = (middle(a, b), middle(c, d));
        let across = cross(arms[0], arms[1]);
        if across.abs() < PARALLEL {
            return None;
        }
        let t = cross(sub(q, p), arms[1]) / across;
        Some(Profile { corner: along(p, arms[0], t), arms })
    }

    fn parameters(&self) -> [f64; 4] {
        let [a, b] = self.arms.map(|a| a[1].atan2(a[0]));
        [self.corner[0], self.corner[1], a, b]
    }

    fn from_parameters(p: &[f64]) -> Profile {
        let arm = |angle: f64| [angle.cos(), angle.sin()];
        Profile { corner: [p[0], p[1]], arms: [arm(p[2]), arm(p[3])] }
    }

    /// The angle by which the surface turns, radians.
    pub(super) fn turn(&self) -> f64 {
        let [a, b] = self.arms;
        (-dot(a, b)).clamp(-1.0, 1.0).acos()
    }

    /// The distance from the corner to where an arc touches the lines.
    fn tangent(&self, radius: f64) -> f64 {
        let [a, b] = self.arms;
        radius * (1.0 + dot(a, b)) / cross(a, b).abs().max(PARALLEL)
    }

    /// Signed distance of an offset from the corner to the line along an arm: positive on the outer side.
    fn outside(&self, arm: usize, d: [f64; 2]) -> f64 {
        let [a, b] = [self.arms[arm], self.arms[1 - arm]];
        if cross(a, b) > 0.0 { -dot(left(a), d) } else { dot(left(a), d) }
    }

    /// Signed distance of a point from the profile rounded by a radius.
    fn off_round(&self, radius: f64, p: [f64; 2]) -> f64 {
        let d = sub(p, self.corner);
        let [s, t] = self.arms.map(|a| dot(d, a));
        let tangent = self.tangent(radius);
        if s >= tangent && s >= t || t >= tangent && t > s {
            return self.outside(usize::from(t > s), d);
        }
        let inwards = unit(along(self.arms[0], self.arms[1], 1.0));
        let from = sub(d, inwards.map(|x| x * radius.hypot(tangent)));
        dot(from, from).sqrt() - radius
    }

    /// Signed distance of a point from the profile cut between two distances from the corner.
    fn off_chamfer(&self, cuts: [f64; 2], p: [f64; 2]) -> f64 {
        let d = sub(p, self.corner);
        let [a, b] = [0, 1].map(|k| self.arms[k].map(|x| x * cuts[k]));
        let chord = unit(sub(b, a));
        let outwards = if dot(left(chord), a) > 0.0 { -1.0 } else { 1.0 };
        let cut = outwards * dot(left(chord), sub(d, a));
        // All three bound a convex region.
        self.outside(0, d).max(self.outside(1, d)).max(cut)
    }

    /// The lengths beyond the arc up to which points lie beside both lines.
    pub(super) fn faces(&self, radius: f64, points: &[[f64; 2]]) -> [f64; 2] {
        let tangent = self.tangent(radius);
        self.arms.map(|a| {
            points.iter().map(|&p| dot(sub(p, self.corner), a)).fold(f64::NEG_INFINITY, f64::max) - tangent
        })
    }

    /// The profiles of least squares from here, rounded by `radius` at first; `None` if the points do not determine the rounded one.
    pub(super) fn compared(self, radius: f64, points: &[[f64; 2]], sigma: f64) -> Option<Compared> {
        let limit = FAR * sigma;
        let [x, y, a, b] = self.parameters();
        let round = fit([x, y, a, b, radius], points, limit, |p, q| {
            Profile::from_parameters(p).off_round(p[4].max(0.0), q)
        })?;
        // Chamfers are sought from where they would touch the arc, and from a wider one.
        let chamfers = CUTS.iter().filter_map(|cut| {
            let cut = cut * self.tangent(radius);
            fit([x, y, a, b, cut, cut], points, limit, |p, q| {
                Profile::from_parameters(p).off_chamfer([p[4].max(0.0), p[5].max(0.0)], q)
            })
        });
        let chamfer = chamfers.map(|f| f.squares).reduce(f64::min);
        let sharp = fit([x, y, a, b], points, limit, |p, q| Profile::from_parameters(p).off_round(0.0, q));
        let most = limit * limit * points.len() as f64;
        let Fitted { parameters, squares, covariance } = round;
        Some(Compared {
            profile: Profile::from_parameters(&parameters),
            radius: parameters[4],
            radius_sigma: covariance[4][4].sqrt(),
            corner_sigma: (covariance[0][0] + covariance[1][1]).sqrt(),
            round: squares,
            sharp: sharp.map_or(most, |f| f.squares),
            chamfer: chamfer.unwrap_or(most),
        })
    }
}
