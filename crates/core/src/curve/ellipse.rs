//! Least-squares ellipses in space.

use super::flat_ellipse::{FlatEllipse, UNKNOWNS};
use super::round::plane;
use crate::math::least_squares::inverse;
use crate::math::vec3::{add, add_scaled, cross, distance, dot, norm, scale, sub, unit};

/// Distance of two points, in half axes, below which they are the same.
const SAME: f64 = 1e-9;
/// The parameters of the ends of the half axes.
const QUARTERS: [f64; 3] = [0.0, std::f64::consts::FRAC_PI_2, std::f64::consts::PI];
/// Greatest change of size that ends which lie aside may ask of an ellipse.
const RESIZED: f64 = 0.1;

/// An ellipse in space. Its point at the parameter `t` is `centre + major cos t + minor (normal x unit(major)) sin t`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Ellipse {
    /// Its centre.
    pub centre: [f64; 3],
    /// Unit normal of its plane.
    pub normal: [f64; 3],
    /// The greater half axis, from the centre to the curve.
    pub major: [f64; 3],
    /// The length of the lesser half axis.
    pub minor: f64,
}

/// How well an ellipse is known.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Known {
    /// Variances of the centre along the greater and the lesser half axis, of the lengths of these, and of the turn about the normal, with covariances.
    pub within: [[f64; UNKNOWNS]; UNKNOWNS],
    /// Variances of the centre along the normal and of the tilt.
    pub across: [f64; 2],
}

impl Ellipse {
    /// In the plane through `origin` with the axes `u` and `v`.
    fn lifted(flat: &FlatEllipse, origin: [f64; 3], [u, v, normal]: [[f64; 3]; 3]) -> Self {
        let lift = |[x, y]: [f64; 2]| add_scaled(scale(u, x), v, y);
        let centre = add_scaled(origin, lift(flat.centre), 1.0);
        Self { centre, normal, major: scale(lift(flat.way), flat.axes[0]), minor: flat.axes[1] }
    }

    /// The ellipse of least squared distances from points with their weights, within the plane of least squared distances. `None` where they
    /// show none, or where a first guess leaves more squares than `limit`.
    pub(crate) fn fit(points: &[[f64; 3]], weights: &[f64], limit: f64) -> Option<Self> {
        let (origin, [u, v, _]) = plane(points)?;
        let axes = [u, v, cross(u, v)];
        let flat: Vec<([f64; 2], f64)> = points
            .iter()
            .zip(weights)
            .map(|(&p, &w)| (sub(p, origin), w))
            .map(|(d, w)| ([dot(d, u), dot(d, v)], w))
            .collect();
        FlatEllipse::algebraic(&flat).filter(|first| first.squares(&flat) <= limit)?;
        Some(Self::lifted(&FlatEllipse::fit(&flat)?, origin, axes))
    }

    /// Unit vectors along the greater and the lesser half axis.
    pub(crate) fn axes(&self) -> [[f64; 3]; 2] {
        let along = unit(self.major);
        [along, cross(self.normal, along)]
    }

    /// In its own plane, its centre at the origin.
    fn flat(&self) -> FlatEllipse {
        FlatEllipse { centre: [0.0; 2], axes: [norm(self.major), self.minor], way: [1.0, 0.0] }
    }

    fn flattened(&self, p: [f64; 3]) -> [f64; 2] {
        let d = sub(p, self.centre);
        self.axes().map(|axis| dot(d, axis))
    }

    /// The parameter of the point nearest to `p`, radians.
    pub fn angle(&self, p: [f64; 3]) -> f64 {
        self.flat().angle(self.flattened(p))
    }

    /// The point at a parameter, radians.
    pub fn at(&self, angle: f64) -> [f64; 3] {
        let (sin, cos) = angle.sin_cos();
        add_scaled(add_scaled(self.centre, self.major, cos), self.axes()[1], self.minor * sin)
    }

    /// The point of the ellipse nearest to `p`.
    pub(crate) fn foot(&self, p: [f64; 3]) -> [f64; 3] {
        self.at(self.angle(p))
    }

    /// The signed change of the parameter along a row of points.
    pub(crate) fn sweep(&self, points: &[[f64; 3]]) -> f64 {
        let flat: Vec<[f64; 2]> = points.iter().map(|&p| self.flattened(p)).collect();
        self.flat().sweep(&flat)
    }

    /// The change of the parameter counter-clockwise from one point to another; a full turn where they are the same.
    pub(crate) fn sweep_between(&self, from: [f64; 3], to: [f64; 3]) -> f64 {
        let full = std::f64::consts::TAU;
        let same = distance(from, to) <= SAME * norm(self.major);
        if same { full } else { (self.angle(to) - self.angle(from)).rem_euclid(full) }
    }

    /// Gone round the other way.
    pub(crate) fn turned(self) -> Self {
        Self { normal: scale(self.normal, -1.0), ..self }
    }

    /// The ellipse moved, turned and resized as little as leads it through two points near to it; `None` where that is much.
    pub(crate) fn through(&self, from: [f64; 3], to: [f64; 3]) -> Option<Self> {
        let [a, b] = [from, to].map(|p| self.foot(p));
        if distance(from, to) <= SAME * norm(self.major) {
            return Some(Self { centre: add_scaled(self.centre, sub(from, a), 1.0), ..*self });
        }
        let (old, new) = (sub(b, a), sub(to, from));
        let size = norm(new) / norm(old);
        // Written so that what is not a number is refused too.
        let little = (size - 1.0).abs() <= RESIZED;
        if !little {
            return None;
        }
        let (old, new) = (unit(old), unit(new));
        let (about, cosine) = (cross(old, new), dot(old, new));
        let turn = |v: [f64; 3]| {
            let straight = add_scaled(scale(v, cosine), cross(about, v), 1.0);
            add_scaled(straight, about, dot(about, v) / (1.0 + cosine))
        };
        let centre = add_scaled(from, turn(sub(self.centre, a)), size);
        let normal = unit(turn(self.normal));
        Some(Self { centre, normal, major: scale(turn(self.major), size), minor: size * self.minor })
    }

    /// How well points that have the error 1 determine it, each with its weight; `None` where they do not.
    pub(crate) fn known(&self, points: &[[f64; 3]], weights: &[f64]) -> Option<Known> {
        let flat: Vec<([f64; 2], f64)> =
            points.iter().zip(weights).map(|(&p, &w)| (self.flattened(p), w)).collect();
        let within = self.flat().covariance(&flat)?;
        let mut m = [[0.0; 3]; 3];
        for &([x, y], w) in &flat {
            let row = [1.0, x, y];
            (0..3).for_each(|i| (0..3).for_each(|j| m[i][j] += w * row[i] * row[j]));
        }
        let across = inverse(m)?;
        Some(Known { within, across: [across[0][0], across[1][1] + across[2][2]] })
    }

    /// Moved by an affine map that scales lengths by `unit` and turns nothing.
    pub(crate) fn mapped(&self, map: impl Fn([f64; 3]) -> [f64; 3], unit: f64) -> Self {
        Self { centre: map(self.centre), major: scale(self.major, unit), minor: unit * self.minor, ..*self }
    }

    /// Of the plane, in a frame of which the map gives places.
    pub(crate) fn of_plane(flat: &FlatEllipse, lift: impl Fn([f64; 2]) -> [f64; 3]) -> Self {
        Self::between(QUARTERS.map(|t| lift(flat.at(t))))
    }

    /// Carried by a motion, with or without a change of scale.
    pub(crate) fn carried(&self, motion: impl Fn([f64; 3]) -> [f64; 3]) -> Self {
        let [first, quarter, half] = QUARTERS.map(|t| self.at(t));
        Self::between([motion(first), motion(quarter), motion(half)])
    }

    /// From its points at the parameters 0, a quarter and half a turn.
    fn between([first, quarter, half]: [[f64; 3]; 3]) -> Self {
        let centre = scale(add(first, half), 0.5);
        let (major, minor) = (sub(first, centre), sub(quarter, centre));
        Self { centre, normal: unit(cross(major, minor)), major, minor: norm(minor) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tilted() -> Ellipse {
        let normal = unit([1.0, 2.0, -2.0]);
        let along = unit(cross(normal, [0.0, 0.0, 1.0]));
        Ellipse { centre: [5.0, 6.0, 7.0], normal, major: scale(along, 9.0), minor: 4.0 }
    }

    #[test]
    fn a_tilted_ellipse_is_found_again_from_less_than_half_of_it() {
        let points: Vec<[f64; 3]> = (0..60).map(|k| tilted().at(0.5 + 0.04 * f64::from(k))).collect();
        let found = Ellipse::fit(&points, &[1.0; 60], f64::INFINITY).unwrap();
        assert!(distance(found.centre, tilted().centre) < 1e-7, "{found:?}");
        assert!((norm(found.major) - 9.0).abs() < 1e-7 && (found.minor - 4.0).abs() < 1e-7, "{found:?}");
        assert!((found.sweep(&points).abs() - 59.0 * 0.04).abs() < 1e-7);
    }

    #[test]
    fn ends_that_lie_aside_are_led_through_exactly() {
        let [from, to] = [tilted().at(0.2), tilted().at(3.0)];
        let aside = [[from[0] + 0.1, from[1], from[2] - 0.05], [to[0], to[1] + 0.08, to[2]]];
        let moved = tilted().through(aside[0], aside[1]).unwrap();
        for p in aside {
            assert!(distance(moved.foot(p), p) < 1e-12, "{moved:?}");
        }
        assert!((moved.sweep_between(aside[0], aside[1]) - 2.8).abs() < 0.03);
        assert!(
            distance(moved.centre, tilted().centre) < 0.2 && dot(moved.major, moved.normal).abs() < 1e-12
        );
    }
}
