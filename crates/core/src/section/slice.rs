//! Slicing (section 2): the frame of the slices, and which points each slab holds.

use rayon::prelude::*;

use super::params::Axis;
use super::spread::Spread;
use crate::math::eigen3::eigen3;
use crate::math::vec3;
use crate::neighbors::Index;

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

/// The frame of an axis; automatic ones look at the faces, or at the principal axes of the points.
pub(crate) fn resolve(axis: Axis, points: &[[f64; 3]], index: &Index, noise: f64) -> SliceFrame {
    let given = SliceFrame::along(axis);
    let faces = || if axis == Axis::Faces { super::axis::of_faces(points, index, noise) } else { None };
    given
        .or_else(|| SliceFrame::along(Axis::Vector(faces().map_or_else(|| automatic(axis, points), settle))))
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

/// What lies within `half` of each plane, ascending: lists one after the other, and where each begins.
pub(crate) struct Slabs {
    starts: Vec<usize>,
    indices: Vec<u32>,
}

impl Slabs {
    /// Sorts what spans some heights into the slabs around ascending `planes`; slabs may overlap.
    pub(crate) fn of(
        spans: impl IndexedParallelIterator<Item = (f64, f64)>,
        planes: &[f64],
        half: f64,
    ) -> Self {
        let range = |(low, high): (f64, f64)| {
            let first = planes.partition_point(|&z| z < low - half);
            (first, planes[first..].iter().take_while(|&&z| z <= high + half).count())
        };
        let ranges: Vec<(usize, usize)> = spans.map(range).collect();
        let mut starts = vec![0usize; planes.len() + 1];
        for &(first, count) in &ranges {
            starts[first + 1..first + 1 + count].iter_mut().for_each(|s| *s += 1);
        }
        for k in 0..planes.len() {
            starts[k + 1] += starts[k];
        }
        let mut next = starts.clone();
        let mut indices = vec![0u32; starts[planes.len()]];
        for (i, (first, count)) in ranges.into_iter().enumerate() {
            for slot in &mut next[first..first + count] {
                indices[*slot] = i as u32;
                *slot += 1;
            }
        }
        Self { starts, indices }
    }

    /// What lies in one slab.
    pub(crate) fn of_plane(&self, plane: usize) -> &[u32] {
        &self.indices[self.starts[plane]..self.starts[plane + 1]]
    }

    /// All that lies in a slab, out of `count`, ascending, each once.
    pub(crate) fn union(&self, count: usize) -> Vec<u32> {
        let mut inside = vec![false; count];
        self.indices.iter().for_each(|&i| inside[i as usize] = true);
        (0..count as u32).filter(|&i| inside[i as usize]).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slabs_hold_what_comes_within_their_half_thickness() {
        let span = |i: u32| (f64::from(i * 37 % 100) / 10.0, f64::from(i * 37 % 100 + i % 3) / 10.0);
        let planes = [-3.0, 2.0, 2.5, 9.0];
        let slabs = Slabs::of((0..100).into_par_iter().map(span), &planes, 1.0);
        for (plane, z) in planes.iter().enumerate() {
            let near = |&i: &u32| span(i).0 <= z + 1.0 && span(i).1 >= z - 1.0;
            assert_eq!(slabs.of_plane(plane), (0..100).filter(near).collect::<Vec<u32>>());
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
