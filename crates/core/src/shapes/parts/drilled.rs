//! Parts with round holes: blind, through, crossing, countersunk, on a bolt circle.

use super::polyhedron::prism;
use super::revolution::revolve;
use crate::math::vec3::unit;
use crate::network::StripKind;
use crate::shapes::face::{Face, Trim};
use crate::shapes::shape::Shape;
use crate::shapes::surface::{Axes, FaceSurface};
use crate::shapes::truth::{CIRCLE, Fold, TruthCurve, circle, fold_between};
use crate::shapes::turns::sin_cos;

/// The faces of a prism that lie across it.
pub(super) const BOTTOM: usize = 0;
pub(super) const TOP: usize = 1;

/// A plate of 4 by 4 by 1.5 with a bore of radius 0.4 through its middle, sunk at 45 degrees to radius 0.9 at the top.
pub fn countersunk_plate() -> Shape {
    let (bore, sink, thickness) = (0.4, 0.9, 1.5);
    let depth = sink - bore;
    let mut shape = prism("countersunk plate", &rectangle(4.0, 4.0), thickness, |p| p);
    let axes = Axes::at([2.0, 2.0, thickness]);
    shape.cut(TOP, axes, sink);
    shape.cut(BOTTOM, axes, bore);
    for (from, to) in [([sink, 0.0], [bore, -depth]), ([bore, -depth], [bore, -thickness])] {
        shape.faces.push(Face::new(FaceSurface::Cone { axes, from, to }));
    }
    for (radius, z) in [(sink, thickness), (bore, thickness - depth)] {
        let line = circle([2.0, 2.0, z], axes.x, axes.y, radius);
        shape.network.curves.push(TruthCurve::crease(line, 45.0, Fold::Convex, None));
    }
    shape.ring(axes, bore, -thickness, Fold::Convex);
    shape
}

/// A block of 4 by 3 by 2: a bore of radius 0.5 through it along z, one of radius 0.3 through it along x that crosses the
/// first in its middle, and a blind hole of radius 0.35, 1.4 deep, from the top.
pub fn crossed_bores() -> Shape {
    let size = [4.0, 3.0, 2.0];
    let (upright, level) = (0.5, 0.3);
    let (left, right) = (5, 3);
    let mut shape = prism("crossed bores", &rectangle(size[0], size[1]), size[2], |p| p);
    let z = Axes::at([1.3, 1.5, size[2]]);
    let x = Axes::along([size[0], 1.5, 1.0], [1.0, 0.0, 0.0]);
    for (axes, radius, other, from, to, length) in
        [(z, upright, (x, level), TOP, BOTTOM, size[2]), (x, level, (z, upright), right, left, size[0])]
    {
        shape.pit(from, axes, radius, length);
        let trim = Trim::Cylinder { origin: other.0.origin, axis: other.0.z, radius: other.1 };
        if let Some(wall) = shape.faces.last_mut() {
            wall.trims.push(trim);
        }
        shape.cut(to, axes, radius);
        shape.ring(axes, radius, -length, Fold::Convex);
    }
    shape.network.curves.extend([-1.0, 1.0].map(|side| crossing([1.3, 1.5, 1.0], upright, level, side)));
    let blind = Axes::at([3.0, 0.6, size[2]]);
    shape.pit(TOP, blind, 0.35, 1.4);
    shape.cap(blind, 0.35, -1.4);
    shape.ring(blind, 0.35, -1.4, Fold::Concave);
    shape
}

/// Where a bore along x enters one along z, about their common centre.
fn crossing(centre: [f64; 3], upright: f64, level: f64, side: f64) -> TruthCurve {
    let (mut points, mut folds) = (Vec::new(), Vec::new());
    for i in 0..CIRCLE {
        let [y, z] = sin_cos(f64::from(i) / f64::from(CIRCLE)).map(|c| level * c);
        let x = side * (upright * upright - y * y).sqrt();
        points.push([centre[0] + x, centre[1] + y, centre[2] + z]);
        folds.push(fold_between(unit([x, y, 0.0]), unit([0.0, y, z])));
    }
    TruthCurve::new(StripKind::Crease, points, folds, Fold::Convex, None)
}

/// A flange about z: a disc of radius 2 and thickness 0.5 with six bolt holes of radius 0.2 on a circle of radius 1.45, a
/// hub of radius 0.9 up to 1.5, and a bore of radius 0.5.
pub fn flange() -> Shape {
    let profile = [[0.5, 0.0], [2.0, 0.0], [2.0, 0.5], [0.9, 0.5], [0.9, 1.5], [0.5, 1.5], [0.5, 0.0]];
    let (under, over) = (0, 2);
    let mut shape = revolve("flange", &profile);
    for k in 0..6 {
        let [x, y] = sin_cos(f64::from(k) / 6.0).map(|c| 1.45 * c);
        let axes = Axes::at([x, y, 0.5]);
        shape.pit(over, axes, 0.2, 0.5);
        shape.cut(under, axes, 0.2);
        shape.ring(axes, 0.2, -0.5, Fold::Convex);
    }
    shape
}

pub(super) fn rectangle(x: f64, y: f64) -> [[f64; 2]; 4] {
    [[0.0, 0.0], [x, 0.0], [x, y], [0.0, y]]
}
