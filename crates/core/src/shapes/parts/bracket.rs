//! An L-bracket with a bore and a boss, and the round features that plane faces can carry.

use super::polyhedron::prism;
use crate::shapes::face::{Face, Trim};
use crate::shapes::shape::Shape;
use crate::shapes::surface::{Axes, FaceSurface};
use crate::shapes::truth::{Fold, TruthCurve, circle};

/// Depth along x, length of the foot along y, height of the wall along z, thickness of both.
const SIZE: [f64; 3] = [4.0, 6.0, 5.0];
const THICKNESS: f64 = 1.2;

/// An L-bracket, 4 by 6 by 5: 18 straight creases (one concave) between 12 junctions, a bore through the foot and a
/// boss on the inner side of the wall: four circles.
pub fn bracket() -> Shape {
    let [depth, length, height] = SIZE;
    let t = THICKNESS;
    let outline = [[0.0, 0.0], [length, 0.0], [length, t], [t, t], [t, height], [0.0, height]];
    let mut shape = prism("bracket", &outline, depth, |[y, z, x]| [x, y, z]);
    let (underside, top_of_foot, inner_wall) = (2, 4, 5);

    let bore = Axes::along([2.0, 4.0, t], [0.0, 0.0, 1.0]);
    shape.pit(top_of_foot, bore, 0.9, t);
    shape.cut(underside, bore, 0.9);
    shape.ring(bore, 0.9, -t, Fold::Convex);

    let boss = Axes::along([2.0, t, 3.3], [0.0, 1.0, 0.0]);
    shape.post(inner_wall, boss, 0.8, 1.0);
    shape.cap(boss, 0.8, 1.0);
    shape.ring(boss, 0.8, 1.0, Fold::Convex);
    shape
}

/// Round features on plane faces. `axes` stands on the face, its z axis the face's outward normal.
impl Shape {
    /// A cylinder that stands on a face, open at `height`; the circle at its foot.
    pub(super) fn post(&mut self, face: usize, axes: Axes, radius: f64, height: f64) {
        self.cut(face, axes, radius);
        self.ring(axes, radius, 0.0, Fold::Concave);
        self.faces.push(Face::new(FaceSurface::Cone { axes, from: [radius, 0.0], to: [radius, height] }));
    }

    /// A cylindrical wall down from a face, open at `depth`; the circle at its rim.
    pub(super) fn pit(&mut self, face: usize, axes: Axes, radius: f64, depth: f64) {
        self.cut(face, axes, radius);
        self.ring(axes, radius, 0.0, Fold::Convex);
        self.faces.push(Face::new(FaceSurface::Cone { axes, from: [radius, 0.0], to: [radius, -depth] }));
    }

    /// Takes a disc out of a face.
    pub(super) fn cut(&mut self, face: usize, axes: Axes, radius: f64) {
        self.faces[face].trims.push(Trim::Cylinder { origin: axes.origin, axis: axes.z, radius });
    }

    /// A disc at `height` that looks along z.
    pub(super) fn cap(&mut self, axes: Axes, radius: f64, height: f64) {
        self.faces.push(Face::new(FaceSurface::Cone { axes, from: [radius, height], to: [0.0, height] }));
    }

    /// A circle at `height` with a right angle.
    pub(super) fn ring(&mut self, axes: Axes, radius: f64, height: f64, fold: Fold) {
        let line = circle(axes.to_world([0.0, 0.0, height]), axes.x, axes.y, radius);
        self.network.curves.push(TruthCurve::crease(line, 90.0, fold, None));
    }

    /// A circle at `height` where the surface ends.
    pub(super) fn rim(&mut self, axes: Axes, radius: f64, height: f64) {
        let line = circle(axes.to_world([0.0, 0.0, height]), axes.x, axes.y, radius);
        self.network.curves.push(TruthCurve::border(line, None));
    }
}
