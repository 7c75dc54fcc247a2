//! Slicing (section 2): the frame of the slices, and which points each slab holds.

use super::params::Axis;
use super::spread::Spread;
use crate::math::eigen3::eigen3;
use crate::math::vec3;

/// A right-handed frame whose third axis points across the slices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliceFrame {
    /// Unit vectors in the world: two in the plane, then the axis.
    pub axes: [[f64; 3]; 3],
}

impl SliceFrame {
    /// The frame for an axis that is not automatic: the other two coordinates in cyclic order for x, y and z.
    pub fn along(axis: Axis) -> Option<Self> {
        match axis {
            Axis::Coordinate(k) if k < 3 => {
                let unit = |i: usize| std::array::from_fn(|a| f64::from(u8::from(a == i % 3)));
                Some(Self { axes: [unit(k + 1), unit(k + 2), unit(k)] })
            }
            Axis::Vector(v) => {
                // Scaled first, so that squares of very small or large components stay finite.
                let most = v.iter().fold(0.0f64, |m, x| m.max(x.abs()));
                let w = vec3::unit(v.map(|x| x / most));
                if let Some(k) = (0..3).find(|&k| w[k] == 1.0) {
                    return Self::along(Axis::Coordinate(k));
                }
                let u = vec3::perpendicular(w);
                Some(Self { axes: [u, vec3::cross(w, u), w] })
            }
            _ => None,
        }
    }

    /// Coordinates of a vector in this frame.
    pub fn coordinates(&self, p: [f64; 3]) -> [f64; 3] {
        self.axes.map(|axis| vec3::dot(axis, p))
    }

    /// The vector with given coordinates in this frame.
    pub fn vector(&self, c: [f64; 3]) -> [f64; 3] {
        let sum = vec3::add_scaled(vec3::scale(self.axes[0], c[0]), self.axes[1], c[1]);
        vec3::add_scaled(sum, self.axes[2], c[2])
    }
}

/// The frame of an axis; automatic ones look at the principal axes of the points.
pub(crate) fn resolve(axis: Axis, points: &[[f64; 3]]) -> SliceFrame {
    let given = SliceFrame::along(axis);
    given
        .or_else(|| SliceFrame::along(Axis::Vector(automatic(axis, points))))
        .unwrap_or(SliceFrame { axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] })
}

fn automatic(axis: Axis, points: &[[f64; 3]]) -> [f64; 3] {
    let Some(&origin) = points.first() else { return [0.0, 0.0, 1.0] };
    let spread = Spread::of(points.iter().map(|&p| (p, 1.0)), origin);
    let vectors = eigen3(&spread.tensor).vectors;
    let pick = match axis {
        Axis::Thinnest => thinnest(points, &vectors),
        _ => vectors[2],
    };
    settle(pick)
}

/// The sign for which the largest component is positive; components that are rounding are 0, so that a cloud that
/// lies square to the coordinates is cut square to them.
fn settle(v: [f64; 3]) -> [f64; 3] {
    let clean = v.map(|x| if x.abs() < 1e-9 { 0.0 } else { x });
    let largest = clean.iter().fold(0.0f64, |m, x| if x.abs() > m.abs() + 1e-9 { *x } else { m });
    if largest < 0.0 { clean.map(|x| -x) } else { clean }
}

/// The axis for which slices project thinnest: a slab's points, projected, fill the fewest cells of a grid as fine
/// as the slabs are thick.
fn thinnest(points: &[[f64; 3]], axes: &[[f64; 3]; 3]) -> [f64; 3] {
    let filled = |axis: &[f64; 3]| {
        let frame = SliceFrame::along(Axis::Vector(*axis))?;
        let cell = extent(points, &frame) / 64.0;
        let mut cells: Vec<[i64; 3]> =
            points.iter().map(|&p| frame.coordinates(p).map(|x| (x / cell).floor() as i64)).collect();
        cells.sort_unstable();
        cells.dedup();
        Some(cells.len())
    };
    let counts: Vec<usize> = axes.iter().map(|a| filled(a).unwrap_or(usize::MAX)).collect();
    let best = (0..3).min_by_key(|&k| (counts[k], 2 - k)).unwrap_or(2);
    axes[best]
}

fn extent(points: &[[f64; 3]], frame: &SliceFrame) -> f64 {
    let bounds = |(low, high): (f64, f64), p: &[f64; 3]| {
        let z = frame.coordinates(*p)[2];
        (low.min(z), high.max(z))
    };
    let (low, high) = points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), bounds);
    (high - low).max(f64::MIN_POSITIVE)
}

/// The points within `half` of each plane, ascending: lists one after the other, and where each begins.
pub(crate) struct Slabs {
    starts: Vec<usize>,
    indices: Vec<u32>,
}

impl Slabs {
    /// Sorts points (third coordinate: height) into the slabs around ascending `heights`; slabs may overlap.
    pub(crate) fn of(points: &[[f64; 3]], heights: &[f64], half: f64) -> Self {
        let range = |p: &[f64; 3]| {
            let first = heights.partition_point(|&z| z < p[2] - half);
            (first, heights[first..].iter().take_while(|&&z| z <= p[2] + half).count())
        };
        let mut starts = vec![0usize; heights.len() + 1];
        for p in points {
            let (first, count) = range(p);
            starts[first + 1..first + 1 + count].iter_mut().for_each(|s| *s += 1);
        }
        for k in 0..heights.len() {
            starts[k + 1] += starts[k];
        }
        let mut next = starts.clone();
        let mut indices = vec![0u32; starts[heights.len()]];
        for (i, p) in points.iter().enumerate() {
            let (first, count) = range(p);
            for slot in &mut next[first..first + count] {
                indices[*slot] = i as u32;
                *slot += 1;
            }
        }
        Self { starts, indices }
    }

    /// The points of one slab.
    pub(crate) fn of_plane(&self, plane: usize) -> &[u32] {
        &self.indices[self.starts[plane]..self.starts[plane + 1]]
    }

    /// Every point that lies in a slab, ascending, each once.
    pub(crate) fn union(&self, points: usize) -> Vec<u32> {
        let mut inside = vec![false; points];
        self.indices.iter().for_each(|&i| inside[i as usize] = true);
        (0..points as u32).filter(|&i| inside[i as usize]).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slabs_hold_the_points_within_their_half_thickness() {
        let points: Vec<[f64; 3]> = (0..100).map(|i| [0.0, 0.0, f64::from(i * 37 % 100) / 10.0]).collect();
        let heights = [-3.0, 2.0, 2.5, 9.0];
        let slabs = Slabs::of(&points, &heights, 1.0);
        for (plane, z) in heights.iter().enumerate() {
            let wanted: Vec<u32> =
                (0..100u32).filter(|&i| (points[i as usize][2] - z).abs() <= 1.0).collect();
            assert_eq!(slabs.of_plane(plane), wanted);
        }
    }

    #[test]
    fn slice_frames_are_right_handed_and_keep_coordinates() {
        for axis in
            [Axis::Coordinate(1), Axis::Vector([0.0, 3.0, 0.0]), Axis::Vector([1e-200, 2e-200, -1e-200])]
        {
            let frame = SliceFrame::along(axis).unwrap();
            let [u, v, w] = frame.axes;
            assert!(vec3::distance(vec3::cross(u, v), w) < 1e-15);
            let back = frame.vector(frame.coordinates([1.0, -2.0, 3.0]));
            assert!(vec3::distance(back, [1.0, -2.0, 3.0]) < 1e-14);
        }
    }
}
