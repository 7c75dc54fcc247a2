//! Demarsin's brick: five cylinders on a plane.

use super::polyhedron::polyhedron;
use crate::shapes::shape::Shape;
use crate::shapes::surface::Axes;
use crate::shapes::truth::Fold;

/// A plane, 10 by 7, with four walls at right angles that are open below; on it four cylinders that are open above, and
/// a small fifth that points the other way and is closed (Demarsin et al. 2007, figure 10).
///
/// Creases: 8 straight ones, and 6 circles; borders: the rectangle below, whose corners are junctions with the walls'
/// creases, and 4 circles.
pub fn brick() -> Shape {
    let corner = |i: usize| [10.0 * (i & 1) as f64, 7.0 * (i >> 1 & 1) as f64, 3.0 * (i >> 2) as f64];
    let corners: Vec<[f64; 3]> = (0..8).map(corner).collect();
    let (plane, walls) = ([4, 5, 7, 6], [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3]]);
    let [a, b, c, d] = &walls;
    let mut shape = polyhedron("brick", &corners, &[&plane, a, b, c, d]);
    let on_plane = |x: f64, y: f64| Axes::along([x, y, 3.0], [0.0, 0.0, 1.0]);
    for (x, y) in [(2.0, 1.75), (8.0, 1.75), (8.0, 5.25), (2.0, 5.25)] {
        shape.post(0, on_plane(x, y), 1.0, 1.5);
        shape.rim(on_plane(x, y), 1.0, 1.5);
    }
    let small = on_plane(5.0, 3.5);
    shape.pit(0, small, 0.6, 1.2);
    shape.cap(small, 0.6, -1.2);
    shape.ring(small, 0.6, -1.2, Fold::Concave);
    shape
}
