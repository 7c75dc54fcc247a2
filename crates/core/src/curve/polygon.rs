//! Area, length and centroid of a polyline in the plane, and the test whether a point lies within a polygon.

use crate::math::vec2::{cross, distance};

/// Area, length and centroid of a polyline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Extent {
    /// Signed: positive if the contour runs counter-clockwise; 0 if it is open.
    pub area: f64,
    /// Closing segment included.
    pub length: f64,
    /// Of the enclosed area, or of the line if it is open or encloses nothing.
    pub centroid: [f64; 2],
}

/// Measures a polyline. Sums run relative to its first point, so that map coordinates lose nothing.
pub(crate) fn measure(points: &[[f64; 2]], closed: bool) -> Extent {
    let Some(&origin) = points.first() else {
        return Extent { area: 0.0, length: 0.0, centroid: [0.0; 2] };
    };
    let (mut length, mut twice, mut line, mut face) = (0.0, 0.0, [0.0; 2], [0.0; 2]);
    let count = if closed { points.len() } else { points.len() - 1 };
    for i in 0..count {
        let (a, b) = (points[i], points[if i + 1 == points.len() { 0 } else { i + 1 }]);
        let step = distance(a, b);
        let (a, b) = ([a[0] - origin[0], a[1] - origin[1]], [b[0] - origin[0], b[1] - origin[1]]);
        let wedge = cross(a, b);
        length += step;
        twice += wedge;
        for axis in 0..2 {
            line[axis] += 0.5 * step * (a[axis] + b[axis]);
            face[axis] += wedge * (a[axis] + b[axis]) / 3.0;
        }
    }
    let area = if closed { 0.5 * twice } else { 0.0 };
    let solid = area.abs() > 1e-12 * length * length;
    let mean = |sum: [f64; 2], weight: f64| [origin[0] + sum[0] / weight, origin[1] + sum[1] / weight];
    let centroid = match (solid, length > 0.0) {
        (true, _) => mean(face, twice),
        (false, true) => mean(line, length),
        (false, false) => origin,
    };
    Extent { area, length, centroid }
}

/// Whether a point lies within a closed polygon, by the parity of crossings.
pub(crate) fn contains(polygon: &[[f64; 2]], p: [f64; 2]) -> bool {
    let mut inside = false;
    for i in 0..polygon.len() {
        let (a, b) = (polygon[i], polygon[(i + 1) % polygon.len()]);
        if (a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) {
            inside = !inside;
        }
    }
    inside
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn squares_measure_right_far_from_the_origin() {
        let points: Vec<[f64; 2]> = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .iter()
            .map(|p| [p[0] + 4e6, p[1] - 7e6])
            .collect();
        let extent = measure(&points, true);
        assert_eq!((extent.area, extent.length, extent.centroid), (4.0, 8.0, [4e6, -7e6]));
    }
}
