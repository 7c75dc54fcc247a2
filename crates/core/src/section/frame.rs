//! The frame of the slices.

use crate::math::vec3;
use crate::params::section::Axis;

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

#[cfg(test)]
mod tests {
    use super::*;

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
