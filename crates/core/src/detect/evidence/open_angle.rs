//! The largest open angle around a point (Gumhold 2001, section 3.1, figure 7 b).

use crate::math::vec3::{cross, dot, perpendicular, sub};
use std::f64::consts::TAU;

/// The paper's `beta`: the largest angle around `points[own]`, seen along `normal`, in which no neighbour lies; radians in `[0, 2 pi]`.
///
/// `angles` is scratch. Neighbours straight above or below the point have no angle and are left out.
pub fn open_angle(
    points: &[[f64; 3]],
    own: usize,
    neighbors: &[u32],
    normal: [f64; 3],
    angles: &mut Vec<f64>,
) -> Opening {
    let x = perpendicular(normal);
    let y = cross(normal, x);
    angles.clear();
    for &j in neighbors {
        let d = sub(points[j as usize], points[own]);
        let (u, v) = (dot(d, x), dot(d, y));
        if u * u + v * v > 1e-6 * dot(d, d) {
            angles.push(v.atan2(u));
        }
    }
    angles.sort_unstable_by(f64::total_cmp);
    let (Some(&first), Some(&last)) = (angles.first(), angles.last()) else {
        return Opening { angle: TAU, middle: x };
    };
    let mut widest = (first + TAU - last, last);
    for pair in angles.windows(2) {
        if pair[1] - pair[0] > widest.0 {
            widest = (pair[1] - pair[0], pair[0]);
        }
    }
    let (sin, cos) = (widest.1 + 0.5 * widest.0).sin_cos();
    Opening { angle: widest.0, middle: std::array::from_fn(|c| cos * x[c] + sin * y[c]) }
}

/// The largest open angle and its direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Opening {
    /// The angle, radians in `[0, 2 pi]`.
    pub angle: f64,
    /// Unit vector in the tangent plane through the middle of the opening; at a border it points out of the surface.
    pub middle: [f64; 3],
}

/// The open angle that `count` random directions exceed with a probability of at most `chance`, radians.
///
/// From the bound `P(largest gap > x) <= n (1 - x / 2 pi)^(n - 1)`.
pub fn chance_opening(count: usize, chance: f64) -> f64 {
    if count < 2 {
        return TAU;
    }
    let n = count as f64;
    TAU * (1.0 - (chance / n).powf(1.0 / (n - 1.0)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn a_half_plane_leaves_half_a_turn_open() {
        let mut points = vec![[0.0; 3]];
        points.extend((0..=10).map(|i| (i as f64 * PI / 10.0).sin_cos()).map(|(s, c)| [c, s, 0.0]));
        let neighbors: Vec<u32> = (1..12).collect();
        let opening = open_angle(&points, 0, &neighbors, [0.0, 0.0, 1.0], &mut Vec::new());
        assert!((opening.angle - PI).abs() < 1e-12);
        assert!((opening.middle[1] + 1.0).abs() < 1e-12);
    }

    #[test]
    fn chance_openings_shrink_with_the_number_of_neighbours() {
        assert!(chance_opening(14, 1e-3) > 1.5 * chance_opening(45, 1e-3));
        assert_eq!(chance_opening(1, 1e-3), TAU);
    }

    #[test]
    fn no_neighbour_leaves_everything_open() {
        assert_eq!(open_angle(&[[0.0; 3]], 0, &[], [0.0, 0.0, 1.0], &mut Vec::new()).angle, TAU);
    }
}
