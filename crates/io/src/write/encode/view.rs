//! The direction in which drawings look.

use lineament::math::vec3::{cross, unit};

/// Lines whose thinnest extent is below this share of the next are drawn from that side.
const FLAT: f64 = 0.1;

/// The directions to the right and up in a view along `direction`; z is up, or y where z is looked along.
pub(in crate::write) fn frame(direction: [f64; 3]) -> [[f64; 3]; 2] {
    let along = unit(direction);
    let steep = along[2].abs() > 0.999;
    let right = unit(cross(along, if steep { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] }));
    [right, cross(right, along)]
}

/// Across the thinnest side of a flat network, otherwise from a corner of its box, so that no two sides coincide.
pub(in crate::write) fn best_view(vertices: &[[f64; 3]]) -> [f64; 3] {
    let limit =
        |a: usize, pick: fn(f64, f64) -> f64| vertices.iter().map(|v| v[a]).reduce(pick).unwrap_or(0.0);
    let extent = [0, 1, 2].map(|a| limit(a, f64::max) - limit(a, f64::min));
    let mut order = [2, 1, 0];
    order.sort_by(|&a, &b| extent[a].total_cmp(&extent[b]));
    if extent[order[0]] < FLAT * extent[order[1]] {
        let mut view = [0.0; 3];
        view[order[0]] = if order[0] == 1 { 1.0 } else { -1.0 };
        return view;
    }
    [-1.0, 0.8, -0.7]
}
