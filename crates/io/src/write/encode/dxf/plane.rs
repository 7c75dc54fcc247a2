//! Object coordinates, in which entities of a plane are given, and the bulges of arcs in polylines.

use lineament::math::vec3::{cross, dot, unit};

/// A vertex of a polyline in a plane, and the angle that the arc to the next one sweeps about the normal, radians; 0 for a
/// straight segment.
pub(in crate::write) struct Bend {
    pub at: [f64; 3],
    pub sweep: f64,
}

/// Share of a length below which the components of a normal along x and y count as small.
const SMALL: f64 = 1.0 / 64.0;

/// Object coordinates for an extrusion direction: the arbitrary axis algorithm.
pub(super) fn object(n: [f64; 3], p: [f64; 3]) -> [f64; 3] {
    let small = n[0].abs() < SMALL && n[1].abs() < SMALL;
    let other = if small { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] };
    let x = unit(cross(other, n));
    let y = unit(cross(n, x));
    [dot(x, p), dot(y, p), dot(n, p)]
}

/// Degrees from 0 to 360, in object coordinates.
pub(super) fn angle(centre: [f64; 3], p: [f64; 3]) -> f64 {
    (p[1] - centre[1]).atan2(p[0] - centre[0]).to_degrees().rem_euclid(360.0)
}

/// The height of an arc over half its chord, positive counter-clockwise.
pub(super) fn bulge(sweep: f64) -> f64 {
    (sweep / 4.0).tan()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn object_coordinates_of_z_are_those_of_the_world() {
        assert_eq!(object([0.0, 0.0, 1.0], [1.5, -2.0, 3.0]), [1.5, -2.0, 3.0]);
        assert_eq!(object([0.0, 0.0, -1.0], [1.5, -2.0, 3.0]), [-1.5, -2.0, -3.0]);
        assert_eq!(object([1.0, 0.0, 0.0], [1.5, -2.0, 3.0]), [-2.0, 3.0, 1.5]);
    }

    #[test]
    fn half_a_turn_has_the_bulge_one() {
        assert!((bulge(std::f64::consts::PI) - 1.0).abs() < 1e-15 && bulge(0.0) == 0.0);
        assert!(bulge(-0.5) < 0.0);
    }
}
