//! Planes, cones, spheres and tori with their parameters.

use std::f64::consts::PI;

use super::random::Rng;
use super::turns::sin_cos;
use crate::math::vec3::{add_scaled, cross, dot, norm, perpendicular, scale, sub, unit};

/// A right-handed frame: a point and three unit axes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Axes {
    pub origin: [f64; 3],
    pub x: [f64; 3],
    pub y: [f64; 3],
    pub z: [f64; 3],
}

/// The untrimmed surface of a `Face`, with its parameters `(u, v)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FaceSurface {
    /// `origin + u x + v y` with the normal `z`; `(u, v)` from `low` to `high`.
    Plane {
        /// The frame of the plane.
        axes: Axes,
        /// Least `(u, v)`.
        low: [f64; 2],
        /// Greatest `(u, v)`.
        high: [f64; 2],
    },
    /// A straight profile turned about `z`: cylinder, cone, disc or annulus. `u` in turns from 0 to 1; `v` from 0 at
    /// `from` to 1 at `to`. The normal points to the right of the way from `from` to `to` in the `(r, z)` half plane.
    Cone {
        /// The axis of revolution.
        axes: Axes,
        /// Radius and height where the profile starts.
        from: [f64; 2],
        /// Radius and height where it ends.
        to: [f64; 2],
    },
    /// A whole sphere, normal outwards. `u` is the longitude in turns, `v` the sine of the latitude.
    Sphere {
        /// Centre and pole.
        axes: Axes,
        /// Radius.
        radius: f64,
    },
    /// A whole torus about `z`, normal outwards. `u` and `v` are in turns, about the axis and about the tube.
    Torus {
        /// Centre and axis.
        axes: Axes,
        /// Distance of the tube's centre from the axis.
        ring: f64,
        /// Radius of the tube, below `ring`.
        tube: f64,
    },
}

impl Axes {
    /// At a point, `z` along a direction and `x` perpendicular to it, the same for the same direction.
    pub fn along(origin: [f64; 3], direction: [f64; 3]) -> Self {
        let z = unit(direction);
        let x = perpendicular(z);
        Self { origin, x, y: cross(z, x), z }
    }

    /// The world axes moved to a point.
    pub fn at(origin: [f64; 3]) -> Self {
        Self { origin, x: [1.0, 0.0, 0.0], y: [0.0, 1.0, 0.0], z: [0.0, 0.0, 1.0] }
    }

    /// World coordinates of local ones.
    pub fn to_world(&self, local: [f64; 3]) -> [f64; 3] {
        let p = add_scaled(add_scaled(self.origin, self.x, local[0]), self.y, local[1]);
        add_scaled(p, self.z, local[2])
    }

    /// Local coordinates of a direction.
    pub fn turn(&self, d: [f64; 3]) -> [f64; 3] {
        [dot(d, self.x), dot(d, self.y), dot(d, self.z)]
    }

    /// Local coordinates of a point.
    pub fn to_local(&self, p: [f64; 3]) -> [f64; 3] {
        self.turn(sub(p, self.origin))
    }
}

impl FaceSurface {
    /// The point at `(u, v)`.
    pub fn at(&self, [u, v]: [f64; 2]) -> [f64; 3] {
        let around = |axes: &Axes, r: f64, z: f64| {
            let [c, s] = sin_cos(u);
            axes.to_world([r * c, r * s, z])
        };
        match self {
            FaceSurface::Plane { axes, .. } => axes.to_world([u, v, 0.0]),
            FaceSurface::Cone { axes, from, to } => {
                around(axes, from[0] + (to[0] - from[0]) * v, from[1] + (to[1] - from[1]) * v)
            }
            FaceSurface::Sphere { axes, radius } => {
                around(axes, radius * (1.0 - v * v).max(0.0).sqrt(), radius * v)
            }
            FaceSurface::Torus { axes, ring, tube } => {
                let [c, s] = sin_cos(v);
                around(axes, ring + tube * c, tube * s)
            }
        }
    }

    /// The unit normal at a point of the surface.
    pub fn normal(&self, p: [f64; 3]) -> [f64; 3] {
        let axes = self.axes();
        let q = axes.to_local(p);
        let radial = unit([q[0], q[1], 0.0]);
        let local = match self {
            FaceSurface::Plane { .. } => [0.0, 0.0, 1.0],
            FaceSurface::Cone { from, to, .. } => {
                add_scaled(scale(radial, to[1] - from[1]), [0.0, 0.0, 1.0], from[0] - to[0])
            }
            FaceSurface::Sphere { .. } => q,
            FaceSurface::Torus { ring, .. } => sub(q, scale(radial, *ring)),
        };
        unit(sub(axes.to_world(local), axes.origin))
    }

    /// Distance from a point to the untrimmed surface.
    pub fn distance(&self, p: [f64; 3]) -> f64 {
        let q = self.axes().to_local(p);
        let r = norm([q[0], q[1], 0.0]);
        match self {
            FaceSurface::Plane { low, high, .. } => {
                let beyond = |k: usize| q[k] - q[k].clamp(low[k], high[k]);
                norm([beyond(0), beyond(1), q[2]])
            }
            FaceSurface::Cone { from, to, .. } => {
                let [dr, dz] = [to[0] - from[0], to[1] - from[1]];
                let along = ((r - from[0]) * dr + (q[2] - from[1]) * dz) / (dr * dr + dz * dz);
                let v = along.clamp(0.0, 1.0);
                norm([r - from[0] - dr * v, q[2] - from[1] - dz * v, 0.0])
            }
            FaceSurface::Sphere { radius, .. } => (norm(q) - radius).abs(),
            FaceSurface::Torus { ring, tube, .. } => (norm([r - ring, q[2], 0.0]) - tube).abs(),
        }
    }

    /// The frame of the surface.
    pub fn axes(&self) -> &Axes {
        match self {
            FaceSurface::Plane { axes, .. }
            | FaceSurface::Cone { axes, .. }
            | FaceSurface::Sphere { axes, .. }
            | FaceSurface::Torus { axes, .. } => axes,
        }
    }

    /// Area without trims.
    pub fn area(&self) -> f64 {
        match self {
            FaceSurface::Plane { low, high, .. } => (high[0] - low[0]) * (high[1] - low[1]),
            FaceSurface::Cone { from, to, .. } => PI * (from[0] + to[0]) * slant(*from, *to),
            FaceSurface::Sphere { radius, .. } => 4.0 * PI * radius * radius,
            FaceSurface::Torus { ring, tube, .. } => 4.0 * PI * PI * ring * tube,
        }
    }

    /// `(u, v)` of a point uniform by area.
    pub(crate) fn uniform(&self, rng: &mut Rng) -> [f64; 2] {
        let [u, v] = [rng.uniform(), rng.uniform()];
        match self {
            FaceSurface::Plane { low, high, .. } => {
                [low[0] + (high[0] - low[0]) * u, low[1] + (high[1] - low[1]) * v]
            }
            FaceSurface::Cone { from: [a, _], to: [b, _], .. } => {
                // The radius grows along v, so v has the density a + (b - a) v.
                let radius = (a * a + (b * b - a * a) * v).sqrt();
                [u, (a + b) * v / (a + radius).max(f64::MIN_POSITIVE)]
            }
            FaceSurface::Sphere { .. } => [u, 2.0 * v - 1.0],
            FaceSurface::Torus { ring, tube, .. } => {
                let mut angle = v;
                while rng.uniform() * (ring + tube) > ring + tube * sin_cos(angle)[0] {
                    angle = rng.uniform();
                }
                [u, angle]
            }
        }
    }
}

/// Length of the straight profile between two `(r, z)`.
pub(crate) fn slant(from: [f64; 2], to: [f64; 2]) -> f64 {
    let [dr, dz] = [to[0] - from[0], to[1] - from[1]];
    (dr * dr + dz * dz).sqrt()
}
