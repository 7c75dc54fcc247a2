//! The frame of the slices.

use crate::math::vec3;
use crate::params::section::Axis;

/// Sine of the angle up to which slices are level, so that z does not tell where up is in them.
const LEVEL: f64 = 1e-3;

/// A right-handed frame whose third axis points across the slices.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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

    /// The same turned about its axis so that z points up in the plane: the second vector is z along the plane, or y where the slices
    /// are level.
    pub fn upright(&self) -> Self {
        let w = self.axes[2];
        let along = |up: [f64; 3]| vec3::add_scaled(up, w, -vec3::dot(up, w));
        let z = along([0.0, 0.0, 1.0]);
        let up = vec3::unit(if vec3::norm(z) > LEVEL { z } else { along([0.0, 1.0, 0.0]) });
        // Zeros without a sign, so that files show none.
        let right = vec3::cross(up, w).map(|x| x + 0.0);
        Self { axes: [right, up.map(|x| x + 0.0), w] }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn z_points_up_whatever_the_axis() {
        let level = SliceFrame::along(Axis::Coordinate(2)).unwrap();
        assert_eq!(level.upright(), level);
        for axis in
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.64279, 0.76604, 0.0], [-1.0, 2.0, 0.5]]
        {
            let [u, v, w] = SliceFrame::along(Axis::Vector(axis)).unwrap().upright().axes;
            assert!(vec3::distance(vec3::cross(u, v), w) < 1e-15);
            assert!(v[2] > 0.5 && u[2].abs() < 1e-15, "{axis:?} {u:?} {v:?}");
        }
        let below = SliceFrame::along(Axis::Vector([0.0, 0.0, -3.0])).unwrap().upright();
        assert_eq!(below.axes, [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]]);
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
