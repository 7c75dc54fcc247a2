//! The view of a junction in which the points around it can be sorted (Gumhold 2001, section 4.2, figure 11 b and c): along the
//! direction from the centroid of the neighbourhood to the junction point.

use crate::math::vec3::{add_scaled, cross, dot, perpendicular, scale, sub, unit};
use std::f64::consts::TAU;

/// The two dimensional projection around a junction.
pub(super) struct View {
    at: [f64; 3],
    axes: [[f64; 3]; 2],
}

impl View {
    /// From the centroid of some points to the junction at `at`; `None` where they coincide.
    pub(super) fn new(at: [f64; 3], points: impl Iterator<Item = [f64; 3]>) -> Option<Self> {
        let (mut sum, mut count) = ([0.0; 3], 0.0);
        for p in points {
            sum = add_scaled(sum, sub(p, at), 1.0);
            count += 1.0;
        }
        let direction = unit(scale(sum, -1.0 / f64::max(count, 1.0)));
        if direction == [0.0; 3] {
            return None;
        }
        let x = perpendicular(direction);
        Some(View { at, axes: [x, cross(direction, x)] })
    }

    /// The angle of a point around the junction, from 0 to a whole turn.
    pub(super) fn angle(&self, p: [f64; 3]) -> f64 {
        let d = sub(p, self.at);
        dot(d, self.axes[1]).atan2(dot(d, self.axes[0])).rem_euclid(TAU)
    }
}

/// The initial grouping: the sector of an angle between incident crease lines, whose angles ascend. Sector `g` lies between
/// lines `g` and `g + 1`, the last between the last and the first.
pub(super) fn sector(lines: &[f64], angle: f64) -> usize {
    (lines.partition_point(|&l| l <= angle) + lines.len() - 1) % lines.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sectors_lie_between_their_lines_and_wrap_round() {
        let lines = [1.0, 2.0, 5.0];
        let of = |a| sector(&lines, a);
        assert_eq!([of(0.5), of(1.0), of(1.5), of(3.0), of(5.5)], [2, 0, 0, 1, 2]);
    }

    #[test]
    fn the_faces_of_a_box_at_its_corner_are_three_sectors() {
        let points: Vec<[f64; 3]> = (0..3)
            .flat_map(|k| {
                (0..16).map(move |i| {
                    let mut p = [0.0; 3];
                    p[(k + 1) % 3] = 0.5 + f64::from(i % 4);
                    p[(k + 2) % 3] = 0.5 + f64::from(i / 4);
                    p
                })
            })
            .collect();
        let view = View::new([0.0; 3], points.iter().copied()).unwrap();
        let mut lines = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|p| view.angle(p));
        lines.sort_by(f64::total_cmp);
        let groups: Vec<usize> = points.iter().map(|&p| sector(&lines, view.angle(p))).collect();
        assert!(groups.chunks(16).all(|face| face.iter().all(|g| g == &face[0])), "{groups:?}");
        assert!((0..3).all(|g| groups.contains(&g)));
    }
}
