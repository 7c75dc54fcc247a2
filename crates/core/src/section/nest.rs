//! Which contour lies within which, how they run, and what they enclose.

use super::vec2::{cross, distance};

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

/// For each contour the smallest closed one around it, by a point inside of its extent. Open contours have a
/// surrounding contour too, but surround nothing.
pub(crate) fn parents(contours: &[(Vec<[f64; 2]>, bool)]) -> Vec<Option<usize>> {
    let areas: Vec<f64> = contours.iter().map(|(p, c)| measure(p, *c).area.abs()).collect();
    let boxes: Vec<[f64; 4]> = contours.iter().map(|(p, _)| bounds(p)).collect();
    let inside = |i: usize, j: usize| {
        let (b, o) = (boxes[i], boxes[j]);
        let apart = b[0] < o[0] || b[1] < o[1] || b[2] > o[2] || b[3] > o[3];
        contours[j].1 && !apart && mostly_inside(&contours[i].0, &contours[j].0)
    };
    let around = |i: usize| {
        let larger = |&j: &usize| j != i && (areas[j] > areas[i] || (areas[j] == areas[i] && j < i));
        let mut candidates: Vec<usize> = (0..contours.len()).filter(larger).collect();
        candidates.sort_by(|&a, &b| areas[a].total_cmp(&areas[b]).then(a.cmp(&b)));
        candidates.into_iter().find(|&j| inside(i, j))
    };
    (0..contours.len()).map(around).collect()
}

fn bounds(points: &[[f64; 2]]) -> [f64; 4] {
    let start = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
    points.iter().fold(start, |b, p| [b[0].min(p[0]), b[1].min(p[1]), b[2].max(p[0]), b[3].max(p[1])])
}

/// Several vertices vote, as touching contours may cross by the noise.
fn mostly_inside(inner: &[[f64; 2]], outer: &[[f64; 2]]) -> bool {
    let step = (inner.len() / 9).max(1);
    let votes: Vec<bool> = inner.iter().step_by(step).map(|&p| contains(outer, p)).collect();
    votes.iter().filter(|&&v| v).count() * 2 > votes.len()
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

    fn square(half: f64) -> Vec<[f64; 2]> {
        vec![[-half, -half], [half, -half], [half, half], [-half, half]]
    }

    #[test]
    fn squares_measure_right_far_from_the_origin() {
        let points: Vec<[f64; 2]> = square(1.0).iter().map(|p| [p[0] + 4e6, p[1] - 7e6]).collect();
        let extent = measure(&points, true);
        assert_eq!((extent.area, extent.length, extent.centroid), (4.0, 8.0, [4e6, -7e6]));
    }

    #[test]
    fn squares_nest_by_size() {
        let contours = vec![(square(1.0), true), (square(3.0), true), (square(2.0), true)];
        assert_eq!(parents(&contours), [Some(2), None, Some(1)]);
    }
}
