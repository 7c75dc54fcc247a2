//! A shaft with a keyway, and a dome.

use crate::shapes::face::{Face, Trim};
use crate::shapes::shape::Shape;
use crate::shapes::surface::{Axes, FaceSurface};
use crate::shapes::truth::{CIRCLE, Fold, Truth, TruthCurve, circle, fold_between};
use crate::shapes::turns::sin_cos;

/// Length and radius of the shaft, half the width of its keyway, and how far from the axis that ends.
const LENGTH: f64 = 3.0;
const HALF: f64 = 0.25;
const FLOOR: f64 = 0.6;

/// A shaft about z of radius 1 and length 3 with a keyway of width 0.5 and depth 0.4 all along it.
pub fn keyed_shaft() -> Shape {
    let rim = (1.0 - HALF * HALF).sqrt();
    let plan = [[rim, HALF], [rim, -HALF], [FLOOR, -HALF], [FLOOR, HALF]];
    let corners: Vec<[f64; 3]> = [0.0, LENGTH].iter().flat_map(|&z| plan.map(|[x, y]| [x, y, z])).collect();
    let mut faces = vec![side()];
    // The keyway's walls look at each other, its floor away from the axis.
    let walls = [(2, 1, [0.0, 1.0, 0.0]), (3, 2, [1.0, 0.0, 0.0]), (0, 3, [0.0, -1.0, 0.0])];
    faces.extend(walls.map(|(a, b, z)| wall(corners[a], corners[b], z)));
    faces.extend([cap(0.0), cap(LENGTH)]);
    let mut curves = Vec::new();
    let convex = |points: Vec<[f64; 3]>, ends| TruthCurve::crease(points, 90.0, Fold::Convex, Some(ends));
    for base in [0, 4] {
        let at = |k: u32| corners[(base + k) as usize];
        curves
            .extend([(1, 2), (2, 3), (3, 0)].map(|(a, b)| convex(vec![at(a), at(b)], [base + a, base + b])));
        let arc = arc().map(|[x, y]| [x, y, at(0)[2]]);
        curves.push(convex(arc.collect(), [base, base + 1]));
    }
    for k in 0..4u32 {
        let line = vec![corners[k as usize], corners[k as usize + 4]];
        let (angle, fold) = if k < 2 {
            (fold_between([rim, HALF, 0.0], [0.0, -1.0, 0.0]), Fold::Convex)
        } else {
            (90.0, Fold::Concave)
        };
        curves.push(TruthCurve::crease(line, angle, fold, Some([k, k + 4])));
    }
    Shape { name: "keyed shaft", faces, network: Truth::with_nodes(&corners, curves) }
}

/// The round wall, without the strip over the keyway.
fn side() -> Face {
    let mut face =
        Face::new(FaceSurface::Cone { axes: Axes::at([0.0; 3]), from: [1.0, 0.0], to: [1.0, LENGTH] });
    let notch = [[2.0, -HALF], [FLOOR, -HALF], [FLOOR, HALF], [2.0, HALF]];
    let square = [[-2.0, -2.0], [2.0, -2.0]];
    let outline = square.into_iter().chain(notch).chain([[2.0, 2.0], [-2.0, 2.0]]);
    face.trims.push(Trim::Polygon(outline.collect()));
    face
}

/// An upright wall of the keyway between two corners of its plan.
fn wall(from: [f64; 3], to: [f64; 3], z: [f64; 3]) -> Face {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let width = (dx * dx + dy * dy).sqrt();
    let x = [dx / width, dy / width, 0.0];
    // Right-handed with z: x runs along the wall, y along the shaft up or down.
    let up = x[0] * z[1] - x[1] * z[0];
    let y = [0.0, 0.0, -up.signum()];
    let (low, high) = if y[2] > 0.0 { (0.0, LENGTH) } else { (-LENGTH, 0.0) };
    let axes = Axes { origin: from, x, y, z };
    Face::new(FaceSurface::Plane { axes, low: [0.0, low], high: [width, high] })
}

/// A disc with the notch.
fn cap(z: f64) -> Face {
    let up = if z > 0.0 { 1.0 } else { -1.0 };
    let axes = Axes { origin: [0.0, 0.0, z], x: [1.0, 0.0, 0.0], y: [0.0, up, 0.0], z: [0.0, 0.0, up] };
    let mut face = Face::new(FaceSurface::Plane { axes, low: [-1.0; 2], high: [1.0; 2] });
    // The plan is its own mirror image, so it serves both ends.
    face.trims.push(Trim::Polygon(arc().chain([[FLOOR, -HALF], [FLOOR, HALF]]).collect()));
    face
}

/// The shaft's outline from one side of the keyway round to the other, turning left.
fn arc() -> impl Iterator<Item = [f64; 2]> {
    let rim = (1.0 - HALF * HALF).sqrt();
    let round = (0..CIRCLE).map(|i| sin_cos(f64::from(i) / f64::from(CIRCLE)));
    let clear = round.filter(move |p| !(p[0] > 0.0 && p[1].abs() <= HALF));
    std::iter::once([rim, HALF]).chain(clear).chain([[rim, -HALF]])
}

/// Half a sphere of this radius on a disc at z = 0: one circle.
pub fn dome(radius: f64) -> Shape {
    // The polygon is in x and y of the sphere's frame, so its x points up.
    let axes = Axes { origin: [0.0; 3], x: [0.0, 0.0, 1.0], y: [1.0, 0.0, 0.0], z: [0.0, 1.0, 0.0] };
    let mut half = Face::new(FaceSurface::Sphere { axes, radius });
    let r = 2.0 * radius;
    half.trims.push(Trim::Polygon(vec![[0.0, -r], [r, -r], [r, r], [0.0, r]]));
    let base = Axes::at([0.0; 3]);
    let floor = Face::new(FaceSurface::Cone { axes: base, from: [0.0, 0.0], to: [radius, 0.0] });
    let rim = circle([0.0; 3], base.x, base.y, radius);
    let network = Truth::with_nodes(&[], vec![TruthCurve::crease(rim, 90.0, Fold::Convex, None)]);
    Shape { name: "dome", faces: vec![half, floor], network }
}
