//! Parts of a fixture: a stepped plate, a ribbed bracket, a dovetail guide, a pulley, a manifold.

use super::drilled::{BOTTOM, TOP, rectangle};
use super::polyhedron::{polyhedron, prism};
use super::revolution::revolve;
use crate::math::vec3::unit;
use crate::network::StripKind;
use crate::shapes::face::{Face, Trim};
use crate::shapes::shape::Shape;
use crate::shapes::surface::{Axes, FaceSurface};
use crate::shapes::truth::{CIRCLE, Fold, TruthCurve, fold_between};
use crate::shapes::turns::sin_cos;

/// A plate of 5 by 3, 1.6 thick up to x = 2.6 and 0.8 beyond, with a bore of radius 0.3 through the thick part, widened to
/// 0.6 for the upper 0.4, and a blind hole of radius 0.5, 0.5 deep, in the thin part.
pub fn stepped_plate() -> Shape {
    let outline = [[0.0, 0.0], [1.6, 0.0], [1.6, 2.6], [0.8, 2.6], [0.8, 5.0], [0.0, 5.0]];
    let mut shape = prism("stepped plate", &outline, 3.0, |[z, x, y]| [x, y, z]);
    let (high, low, under) = (3, 5, 7);
    shape.counterbore([high, under], Axes::at([1.3, 1.5, 1.6]), [0.3, 0.6], [0.4, 1.6]);
    shape.blind(low, Axes::at([3.8, 1.5, 0.8]), 0.5, 0.5);
    shape
}

/// An L-bracket, 4 by 5 by 4 and 0.8 thick, with a triangular rib from x = 1.7 to 2.3 that reaches 2 along foot and wall.
pub fn ribbed_bracket() -> Shape {
    let profile = [[0.0, 0.0], [5.0, 0.0], [5.0, 0.8], [0.8, 0.8], [0.8, 4.0], [0.0, 4.0]];
    let rib = [[0.8, 0.8], [2.8, 0.8], [0.8, 2.8]];
    let at = |x: f64, plan: &[[f64; 2]]| plan.iter().map(|p| [x, p[0], p[1]]).collect::<Vec<[f64; 3]>>();
    let corners = [at(0.0, &profile), at(4.0, &profile), at(1.7, &rib), at(2.3, &rib)].concat();
    let faces: [&[u32]; 11] = [
        &[5, 4, 3, 2, 1, 0],
        &[6, 7, 8, 9, 10, 11],
        &[0, 1, 7, 6],
        &[1, 2, 8, 7],
        &[3, 12, 13, 16, 15, 9, 8, 2],
        &[3, 4, 10, 9, 15, 17, 14, 12],
        &[4, 5, 11, 10],
        &[0, 6, 11, 5],
        &[12, 14, 13],
        &[15, 16, 17],
        &[16, 13, 14, 17],
    ];
    polyhedron("ribbed bracket", &corners, &faces)
}

/// A dovetail guide 3 long along y, 4 wide and 1.6 high, with a groove 0.8 deep, 2.2 wide at its floor and 1.6 at the top.
pub fn dovetail() -> Shape {
    let outline =
        [[0.0, 0.0], [1.6, 0.0], [1.6, 1.2], [0.8, 0.9], [0.8, 3.1], [1.6, 2.8], [1.6, 4.0], [0.0, 4.0]];
    prism("dovetail", &outline, 3.0, |[z, x, y]| [x, y, z])
}

/// A pulley about z of radius 1.6, 1.8 wide: a V-groove down to radius 1.2, a square one to 1.3, a hub of radius 0.8 up to
/// 2.4, and a bore of radius 0.4.
pub fn pulley() -> Shape {
    let profile = [
        [0.4, 0.0],
        [1.6, 0.0],
        [1.6, 0.3],
        [1.2, 0.6], // the V
        [1.6, 0.9],
        [1.6, 1.2],
        [1.3, 1.2], // the square groove
        [1.3, 1.5],
        [1.6, 1.5],
        [1.6, 1.8],
        [0.8, 1.8],
        [0.8, 2.4],
        [0.4, 2.4],
        [0.4, 0.0],
    ];
    revolve("pulley", &profile)
}

/// A block of 4 by 2.4 by 2.4: a bore of radius 0.5 through it along x, two of radius 0.3 through it along z that cross the
/// first, and four blind holes of radius 0.15, 0.8 deep, in the corners of the top.
pub fn manifold() -> Shape {
    let (wide, high, [main, branch]) = (4.0, 2.4, [0.5, 0.3]);
    let (left, right, middle) = (5, 3, 0.5 * high);
    let mut shape = prism("manifold", &rectangle(wide, high), high, |p| p);
    let level = Axes::along([wide, middle, middle], [1.0, 0.0, 0.0]);
    let upright = [1.2, 2.8].map(|x| Axes::at([x, middle, high]));
    shape.drill([right, left], level, main, wide);
    let crossed = upright.map(|a| Trim::Cylinder { origin: a.origin, axis: a.z, radius: branch });
    shape.trim_last(crossed);
    for axes in upright {
        shape.drill([TOP, BOTTOM], axes, branch, high);
        shape.trim_last([Trim::Cylinder { origin: level.origin, axis: level.z, radius: main }]);
        let centre = [axes.origin[0], middle, middle];
        shape.network.curves.extend([-1.0, 1.0].map(|side| branching(centre, main, branch, side)));
    }
    for (x, y) in [(0.4, 0.4), (3.6, 0.4), (0.4, 2.0), (3.6, 2.0)] {
        shape.blind(TOP, Axes::at([x, y, high]), 0.15, 0.8);
    }
    shape
}

/// Where a thinner bore along z leaves one along x, about their common centre.
fn branching(centre: [f64; 3], main: f64, branch: f64, side: f64) -> TruthCurve {
    let (mut points, mut folds) = (Vec::new(), Vec::new());
    for i in 0..CIRCLE {
        let [x, y] = sin_cos(f64::from(i) / f64::from(CIRCLE)).map(|c| branch * c);
        let z = side * (main * main - y * y).sqrt();
        points.push([centre[0] + x, centre[1] + y, centre[2] + z]);
        folds.push(fold_between(unit([0.0, y, z]), unit([x, y, 0.0])));
    }
    TruthCurve::new(StripKind::Crease, points, folds, Fold::Convex, None)
}

/// Bores from one plane face; `axes` stands on it, its z axis the face's outward normal.
impl Shape {
    /// A bore from the first face to the second, `length` away.
    fn drill(&mut self, [from, to]: [usize; 2], axes: Axes, radius: f64, length: f64) {
        self.pit(from, axes, radius, length);
        self.cut(to, axes, radius);
        self.ring(axes, radius, -length, Fold::Convex);
    }

    /// A bore with a flat floor.
    fn blind(&mut self, face: usize, axes: Axes, radius: f64, depth: f64) {
        self.pit(face, axes, radius, depth);
        self.cap(axes, radius, -depth);
        self.ring(axes, radius, -depth, Fold::Concave);
    }

    /// A bore from the first face to the second, `length` away, widened for the first `depth`.
    pub(super) fn counterbore(
        &mut self,
        [from, to]: [usize; 2],
        axes: Axes,
        [bore, head]: [f64; 2],
        [depth, length]: [f64; 2],
    ) {
        self.pit(from, axes, head, depth);
        self.ring(axes, head, -depth, Fold::Concave);
        for (from, to) in [([head, -depth], [bore, -depth]), ([bore, -depth], [bore, -length])] {
            self.faces.push(Face::new(FaceSurface::Cone { axes, from, to }));
        }
        self.cut(to, axes, bore);
        self.ring(axes, bore, -depth, Fold::Convex);
        self.ring(axes, bore, -length, Fold::Convex);
    }

    /// Cuts more from the face that came last.
    fn trim_last(&mut self, trims: impl IntoIterator<Item = Trim>) {
        if let Some(face) = self.faces.last_mut() {
            face.trims.extend(trims);
        }
    }
}
