//! The kinds of surface that are fitted to patches.

use crate::frame::Frame;
use crate::math::vec3::{add_scaled, dot, norm, scale, sub, unit};

/// A surface without bounds. Axes are unit vectors; lengths and places are in the frame of the patch.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Surface {
    /// `normal . x = normal . point`.
    Plane {
        /// A point on the plane, in the middle of the patch.
        point: [f64; 3],
        /// Unit normal, outwards.
        normal: [f64; 3],
    },
    /// All points at one distance from a centre.
    Sphere {
        /// The centre.
        center: [f64; 3],
        /// The radius.
        radius: f64,
    },
    /// All points at one distance from an axis.
    Cylinder {
        /// A point on the axis, beside the middle of the patch.
        point: [f64; 3],
        /// Unit direction of the axis.
        axis: [f64; 3],
        /// The radius.
        radius: f64,
    },
    /// All points seen from the apex at one angle to the axis.
    Cone {
        /// The apex.
        apex: [f64; 3],
        /// Unit direction of the axis, from the apex into the cone.
        axis: [f64; 3],
        /// Half the opening angle, radians.
        half_angle: f64,
    },
    /// All points at one distance from a circle.
    Torus {
        /// The centre of the circle.
        center: [f64; 3],
        /// Unit normal of the plane of the circle.
        axis: [f64; 3],
        /// The radius of the circle.
        major: f64,
        /// The distance from the circle.
        minor: f64,
    },
}

/// A surface fitted to a patch, with its residual.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Fit {
    /// The best surface.
    pub surface: Surface,
    /// Root mean square distance of the points of the patch from it, leaving out those next to strips.
    pub residual: f64,
    /// Whether the patch is free-form: the residual exceeds noise and sampling, as the patch has another shape or several.
    pub free: bool,
    /// Whether the surface's [`normal`](Surface::normal) points outwards at the points of the patch.
    pub outward: bool,
}

impl Surface {
    /// The name in files.
    pub fn name(&self) -> &'static str {
        match self {
            Surface::Plane { .. } => "plane",
            Surface::Sphere { .. } => "sphere",
            Surface::Cylinder { .. } => "cylinder",
            Surface::Cone { .. } => "cone",
            Surface::Torus { .. } => "torus",
        }
    }

    /// The number of independent parameters.
    pub fn freedom(&self) -> usize {
        match self {
            Surface::Plane { .. } => 3,
            Surface::Sphere { .. } => 4,
            Surface::Cylinder { .. } => 5,
            Surface::Cone { .. } => 6,
            Surface::Torus { .. } => 7,
        }
    }

    /// Signed distance of a point: positive on the side of the normal of a plane, and away from a centre or axis.
    pub fn distance(&self, p: [f64; 3]) -> f64 {
        match *self {
            Surface::Plane { point, normal } => dot(normal, sub(p, point)),
            Surface::Sphere { center, radius } => norm(sub(p, center)) - radius,
            Surface::Cylinder { point, axis, radius } => height_and_radius(p, point, axis).1 - radius,
            Surface::Cone { apex, axis, half_angle } => {
                let (h, r) = height_and_radius(p, apex, axis);
                r * half_angle.cos() - h * half_angle.sin()
            }
            Surface::Torus { center, axis, major, minor } => {
                let (h, r) = height_and_radius(p, center, axis);
                ((r - major).powi(2) + h * h).sqrt() - minor
            }
        }
    }

    /// Unit normal at the point of the surface next to `p`: the slope of [`distance`](Self::distance).
    pub fn normal(&self, p: [f64; 3]) -> [f64; 3] {
        let out = |on, axis| {
            let (h, _) = height_and_radius(p, on, axis);
            (h, unit(add_scaled(sub(p, on), axis, -h)))
        };
        match *self {
            Surface::Plane { normal, .. } => normal,
            Surface::Sphere { center, .. } => unit(sub(p, center)),
            Surface::Cylinder { point, axis, .. } => out(point, axis).1,
            Surface::Cone { apex, axis, half_angle } => {
                add_scaled(scale(out(apex, axis).1, half_angle.cos()), axis, -half_angle.sin())
            }
            Surface::Torus { center, axis, major, .. } => {
                let (h, radial) = out(center, axis);
                unit(add_scaled(scale(axis, h), radial, height_and_radius(p, center, axis).1 - major))
            }
        }
    }

    pub(super) fn to_world(self, frame: &Frame) -> Surface {
        let place = |p| frame.to_world(p);
        let length = |l| frame.length_to_world(l);
        match self {
            Surface::Plane { point, normal } => Surface::Plane { point: place(point), normal },
            Surface::Sphere { center, radius } => {
                Surface::Sphere { center: place(center), radius: length(radius) }
            }
            Surface::Cylinder { point, axis, radius } => {
                Surface::Cylinder { point: place(point), axis, radius: length(radius) }
            }
            Surface::Cone { apex, axis, half_angle } => Surface::Cone { apex: place(apex), axis, half_angle },
            Surface::Torus { center, axis, major, minor } => {
                Surface::Torus { center: place(center), axis, major: length(major), minor: length(minor) }
            }
        }
    }
}

impl Fit {
    pub(in crate::patch) fn to_world(self, frame: &Frame) -> Fit {
        Fit {
            surface: self.surface.to_world(frame),
            residual: frame.length_to_world(self.residual),
            free: self.free,
            outward: self.outward,
        }
    }
}

/// Height along an axis and distance from it.
pub(super) fn height_and_radius(p: [f64; 3], on: [f64; 3], axis: [f64; 3]) -> (f64, f64) {
    let v = sub(p, on);
    let h = dot(v, axis);
    (h, norm(add_scaled(v, axis, -h)))
}
