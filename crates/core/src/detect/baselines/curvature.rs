//! Mean curvature of a quadric fitted to the neighbourhood (a measure to which Tran 2013, figure 6, compares his own).

use super::SCALE;
use crate::detect::projection::scales::at_every_scale;
use crate::math::least_squares::least_squares;
use crate::math::vec3::{cross, dot, perpendicular, sub};
use crate::resolution::Resolution;

/// Coefficients of `z = a + b u + c v + d u^2 + e u v + f v^2`.
const TERMS: usize = 6;

/// `(N)` absolute mean curvature at each point of the least-squares quadric through it and its 16 nearest neighbours, over their
/// tangent plane: per spacing, at most 1, as no radius below one spacing can be seen. Zero where the points determine no
/// quadric.
pub(super) fn mean(points: &[[f64; 3]], resolution: Resolution) -> Vec<f32> {
    at_every_scale(points, |i, nearest, scales| {
        let w = scales[SCALE.1].normal;
        let u = perpendicular(w);
        let v = cross(w, u);
        let near = &nearest[..SCALE.0.min(nearest.len())];
        let local = near.iter().map(|&j| sub(points[j as usize], points[i])).chain([[0.0; 3]]);
        let rows = local.map(|d| [dot(d, u), dot(d, v), dot(d, w)].map(|x| x / resolution.spacing));
        quadric(rows).map_or(0.0, curvature).min(1.0) as f32
    })
}

/// Absolute mean curvature of the quadric at `u = v = 0`.
fn curvature([_, b, c, d, e, f]: [f64; TERMS]) -> f64 {
    let above = 2.0 * (1.0 + c * c) * d - 2.0 * b * c * e + 2.0 * (1.0 + b * b) * f;
    (0.5 * above / (1.0 + b * b + c * c).powf(1.5)).abs()
}

/// Least squares by the normal equations; `None` if they are singular.
fn quadric(rows: impl Iterator<Item = [f64; 3]>) -> Option<[f64; TERMS]> {
    least_squares(rows.map(|[u, v, z]| ([1.0, u, v, u * u, u * v, v * v], z)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid() -> impl Iterator<Item = [f64; 2]> {
        (0..25).map(|i| [f64::from(i % 5) - 2.0, f64::from(i / 5) - 2.0])
    }

    #[test]
    fn a_quadric_is_found_again_and_its_curvature_is_the_textbooks() {
        let z = |[u, v]: [f64; 2]| 0.3 - 0.1 * u + 0.2 * v + 0.25 * u * u - 0.4 * u * v + 0.05 * v * v;
        let found = quadric(grid().map(|p| [p[0], p[1], z(p)])).unwrap();
        for (x, truth) in found.iter().zip([0.3, -0.1, 0.2, 0.25, -0.4, 0.05]) {
            assert!((x - truth).abs() < 1e-12, "{found:?}");
        }
        assert!(
            (curvature([0.0, 0.0, 0.0, 0.05, 0.0, 0.05]) - 0.1).abs() < 1e-15,
            "a paraboloid of radius 10"
        );
        assert!((curvature([0.0, 0.0, 0.0, 0.05, 0.0, -0.05])).abs() < 1e-15, "a saddle");
    }

    #[test]
    fn points_on_a_line_carry_no_quadric() {
        assert_eq!(quadric((0..17).map(|i| [f64::from(i), 0.0, 0.0])), None);
        assert_eq!(quadric((0..17).map(|_| [0.0; 3])), None);
    }
}
