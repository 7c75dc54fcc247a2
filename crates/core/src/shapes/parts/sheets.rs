//! Open sheets: surfaces that end in a border.

use super::polyhedron::polyhedron;
use crate::shapes::face::Trim;
use crate::shapes::shape::Shape;
use crate::shapes::truth::{TruthCurve, circle};
use crate::shapes::turns::sin_cos;

/// A flat rectangle, 4 by 3, in the plane z = 0: four borders that meet in corners.
pub fn sheet() -> Shape {
    let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 3.0, 0.0], [0.0, 3.0, 0.0]];
    polyhedron("sheet", &corners, &[&[0, 1, 2, 3]])
}

/// The same with a round hole of radius 0.7 at `(1.6, 1.4)`: one border loop more.
pub fn sheet_with_hole() -> Shape {
    let (centre, radius) = ([1.6, 1.4, 0.0], 0.7);
    let mut shape = Shape { name: "sheet with a hole", ..sheet() };
    let axes = *shape.faces[0].surface.axes();
    shape.faces[0].trims.push(Trim::Cylinder { origin: centre, axis: axes.z, radius });
    shape.network.curves.push(TruthCurve::border(circle(centre, axes.x, axes.y, radius), None));
    shape
}

/// Two rectangles, 2 by 3 each, that meet at the y axis and fold by `fold_deg` there, above 0 and below 180: one
/// crease that ends on the border in two junctions.
pub fn bent_sheet(fold_deg: f64) -> Shape {
    let [across, down] = sin_cos(fold_deg / 720.0).map(|x| 2.0 * x);
    let row = |y: f64| [[-across, y, -down], [0.0, y, 0.0], [across, y, -down]];
    let corners: Vec<[f64; 3]> = [row(0.0), row(3.0)].concat();
    polyhedron("bent sheet", &corners, &[&[0, 1, 4, 3], &[1, 2, 5, 4]])
}
