//! A trimmed patch of a plane, cylinder, cone, disc, sphere or torus.

use std::f64::consts::PI;

use super::surface::FaceSurface;
use super::turns::sin_cos;
use crate::math::vec3::{cross, norm, sub};

/// A trim: a part of the surface that a [`Face`] lacks.
#[derive(Clone, Debug, PartialEq)]
pub enum Trim {
    /// Everything outside this polygon in `(u, v)` is cut away.
    Polygon(Vec<[f64; 2]>),
    /// Everything inside this endless cylinder is cut away. On a plane the cylinder must be perpendicular to it, its circle
    /// inside the polygon and clear of other circles: `Face::area` relies on that.
    Cylinder {
        /// A point on the axis.
        origin: [f64; 3],
        /// Unit direction of the axis.
        axis: [f64; 3],
        /// Radius.
        radius: f64,
    },
}

/// A smooth, trimmed piece of the boundary of a shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// The surface on which it lies.
    pub surface: FaceSurface,
    /// The parts that are cut away.
    pub trims: Vec<Trim>,
}

impl Face {
    /// A face without trims.
    pub fn new(surface: FaceSurface) -> Self {
        Self { surface, trims: Vec::new() }
    }

    /// The outward unit normal at a point of the face.
    pub fn normal(&self, p: [f64; 3]) -> [f64; 3] {
        self.surface.normal(p)
    }

    /// Whether no trim cuts the point `p` of the surface away.
    pub fn holds(&self, p: [f64; 3]) -> bool {
        self.trims.iter().all(|trim| match trim {
            Trim::Polygon(outline) => {
                let q = self.surface.axes().to_local(p);
                inside([q[0], q[1]], outline)
            }
            Trim::Cylinder { origin, axis, radius } => norm(cross(sub(p, *origin), *axis)) >= *radius,
        })
    }

    /// Area: exact on planes and on untrimmed surfaces, by midpoints of a 1024 by 1024 lattice elsewhere.
    pub fn area(&self) -> f64 {
        if let FaceSurface::Plane { .. } = self.surface {
            return self.trims.iter().fold(self.surface.area(), |area, trim| match trim {
                Trim::Polygon(outline) => shoelace(outline),
                Trim::Cylinder { radius, .. } => area - PI * radius * radius,
            });
        }
        let all = self.surface.area();
        if self.trims.is_empty() { all } else { all * self.share_left(1024) }
    }

    /// The share of the lattice's midpoints that no trim cuts away, weighted by their areas.
    fn share_left(&self, n: u32) -> f64 {
        let middle = |i: u32| (f64::from(i) + 0.5) / f64::from(n);
        let (mut left, mut all) = (0.0, 0.0);
        for v in (0..n).map(middle) {
            let weight = match self.surface {
                FaceSurface::Cone { from, to, .. } => from[0] + (to[0] - from[0]) * v,
                FaceSurface::Torus { ring, tube, .. } => ring + tube * sin_cos(v)[0],
                FaceSurface::Plane { .. } | FaceSurface::Sphere { .. } => 1.0,
            };
            let v = if let FaceSurface::Sphere { .. } = self.surface { 2.0 * v - 1.0 } else { v };
            let kept = (0..n).filter(|&i| self.holds(self.surface.at([middle(i), v]))).count();
            left += weight * kept as f64;
            all += weight * f64::from(n);
        }
        left / all
    }
}

/// Area of a simple polygon that turns left.
pub(crate) fn shoelace(outline: &[[f64; 2]]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    outline.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>() / 2.0
}

/// Even-odd rule.
fn inside(p: [f64; 2], outline: &[[f64; 2]]) -> bool {
    let next = outline.iter().cycle().skip(1);
    let crosses = |a: &[f64; 2], b: &[f64; 2]| {
        (a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1])
    };
    outline.iter().zip(next).filter(|(a, b)| crosses(a, b)).count() % 2 == 1
}
