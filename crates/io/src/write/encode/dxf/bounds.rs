//! The box around the entities of a drawing.

use super::Shape;
use super::plane::Bend;
use lineament::curve::Ellipse;
use lineament::math::vec3::{add, add_scaled, cross, distance, norm, scale, sub, unit};
use std::f64::consts::TAU;

/// Share of a turn by which the extremes of an arc may lie outside of it.
const SLACK: f64 = 1e-9;

/// Least and greatest corner; `None` where there is nothing. Splines count with their control points, texts with their place.
pub(super) fn extent(entities: &[(usize, Shape)]) -> Option<[[f64; 3]; 2]> {
    let mut found = None;
    for (_, shape) in entities {
        each(shape, &mut |p| {
            let [low, high] = found.unwrap_or([p, p]);
            let corner = |pick: fn(f64, f64) -> f64, a: [f64; 3]| [0, 1, 2].map(|k| pick(a[k], p[k]));
            found = Some([corner(f64::min, low), corner(f64::max, high)]);
        });
    }
    found
}

/// Calls `take` with points whose box is that of the shape.
fn each(shape: &Shape, take: &mut dyn FnMut([f64; 3])) {
    match shape {
        Shape::Point(at) | Shape::Text { at, .. } => take(*at),
        Shape::Line(ends) => ends.iter().for_each(|&p| take(p)),
        Shape::Arc { centre, radius, normal, ends } => {
            ends.iter().for_each(|&p| take(p));
            extremes(*centre, *radius, *normal, Some(*ends), take);
        }
        Shape::Circle { centre, radius, normal } => extremes(*centre, *radius, *normal, None, take),
        Shape::Ellipse { ellipse, from, sweep } => oval(ellipse, *from, *sweep, take),
        Shape::Spline(curve) => curve.controls.iter().for_each(|&p| take(p)),
        Shape::Polyline { points, .. } => points.iter().for_each(|&p| take(p)),
        Shape::Flat { bends, normal, .. } => {
            bends.iter().for_each(|b| take(b.at));
            for (a, b) in bends.iter().zip(bends.iter().cycle().skip(1)).filter(|(a, _)| a.sweep != 0.0) {
                bent(a, b.at, *normal, take);
            }
        }
    }
}

/// The extremes of the arc from a bend to the next vertex.
fn bent(from: &Bend, to: [f64; 3], normal: [f64; 3], take: &mut dyn FnMut([f64; 3])) {
    let half = 0.5 * distance(from.at, to);
    let across = unit(cross(normal, sub(to, from.at)));
    let middle = scale(add(from.at, to), 0.5);
    let centre = add_scaled(middle, across, half / (0.5 * from.sweep).tan());
    let radius = half / (0.5 * from.sweep).sin().abs();
    let ends = if from.sweep > 0.0 { [from.at, to] } else { [to, from.at] };
    extremes(centre, radius, normal, Some(ends), take);
}

/// The points of a circle that lie farthest along x, y and z, of an arc those that lie on it.
fn extremes(
    centre: [f64; 3],
    radius: f64,
    normal: [f64; 3],
    ends: Option<[[f64; 3]; 2]>,
    take: &mut dyn FnMut([f64; 3]),
) {
    for axis in 0..3 {
        let along: [f64; 3] = std::array::from_fn(|k| f64::from(u8::from(k == axis)));
        let inside = add_scaled(along, normal, -normal[axis]);
        if norm(inside) == 0.0 {
            take(centre);
            continue;
        }
        for side in [-radius, radius] {
            let p = add_scaled(centre, unit(inside), side);
            let on = |[from, to]: [[f64; 3]; 2]| {
                turn(centre, normal, from, p) <= turn(centre, normal, from, to) + SLACK * TAU
            };
            if ends.is_none_or(on) {
                take(p);
            }
        }
    }
}

/// The ends of a stretch of an ellipse, and its points that lie farthest along x, y and z.
fn oval(ellipse: &Ellipse, from: [f64; 3], sweep: f64, take: &mut dyn FnMut([f64; 3])) {
    let first = ellipse.angle(from);
    [first, first + sweep].into_iter().for_each(|t| take(ellipse.at(t)));
    let minor = sub(ellipse.at(0.25 * TAU), ellipse.centre);
    for axis in 0..3 {
        let most = minor[axis].atan2(ellipse.major[axis]);
        for t in [most, most + 0.5 * TAU] {
            if (t - first).rem_euclid(TAU) <= sweep + SLACK * TAU {
                take(ellipse.at(t));
            }
        }
    }
}

/// The angle from one point to another about the normal, 0 to a full turn.
fn turn(centre: [f64; 3], normal: [f64; 3], from: [f64; 3], to: [f64; 3]) -> f64 {
    let (a, b) = (sub(from, centre), sub(to, centre));
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    dot(cross(a, b), normal).atan2(dot(a, b)).rem_euclid(TAU)
}

#[cfg(test)]
mod tests {
    use super::*;

    const Z: [f64; 3] = [0.0, 0.0, 1.0];

    fn of(shape: Shape) -> [[f64; 3]; 2] {
        extent(&[(0, shape)]).unwrap()
    }

    #[test]
    fn an_arc_reaches_as_far_as_it_goes() {
        let arc = |ends| Shape::Arc { centre: [1.0, 1.0, 5.0], radius: 2.0, normal: Z, ends };
        // A quarter, and the three quarters beside it.
        let ends = [[3.0, 1.0, 5.0], [1.0, 3.0, 5.0]];
        assert_eq!(of(arc(ends)), [[1.0, 1.0, 5.0], [3.0, 3.0, 5.0]]);
        assert_eq!(of(arc([ends[1], ends[0]])), [[-1.0, -1.0, 5.0], [3.0, 3.0, 5.0]]);
    }

    #[test]
    fn an_ellipse_reaches_as_far_as_it_goes() {
        let ellipse = Ellipse { centre: [1.0, 1.0, 5.0], normal: Z, major: [0.0, 3.0, 0.0], minor: 2.0 };
        let of = |from, sweep| of(Shape::Ellipse { ellipse, from, sweep });
        let near = |a: [[f64; 3]; 2], b: [[f64; 3]; 2]| {
            assert!(a.iter().flatten().zip(b.iter().flatten()).all(|(a, b)| (a - b).abs() < 1e-12), "{a:?}");
        };
        near(of([1.0, 4.0, 5.0], TAU), [[-1.0, -2.0, 5.0], [3.0, 4.0, 5.0]]);
        // From its top over the left to the bottom.
        near(of([1.0, 4.0, 5.0], 0.5 * TAU), [[-1.0, -2.0, 5.0], [1.0, 4.0, 5.0]]);
    }

    #[test]
    fn a_tilted_circle_has_its_box() {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let [low, high] = of(Shape::Circle { centre: [0.0; 3], radius: 2.0, normal: [0.0, half, half] });
        for (found, size) in high.into_iter().zip([2.0, 2.0 * half, 2.0 * half]) {
            assert!((found - size).abs() < 1e-12, "{high:?}");
        }
        assert!((0..3).all(|k| (low[k] + high[k]).abs() < 1e-12));
    }

    #[test]
    fn a_polyline_bulges_over_its_vertices() {
        let bend = |x: f64, sweep: f64| Bend { at: [x, 0.0, 0.0], sweep };
        let flat =
            |sweep| Shape::Flat { bends: vec![bend(-1.0, sweep), bend(1.0, 0.0)], closed: false, normal: Z };
        // From left to right counter-clockwise the arc hangs below.
        let [low, high] = of(flat(std::f64::consts::PI));
        assert!((low[1] + 1.0).abs() < 1e-12 && high[1].abs() < 1e-12, "{low:?} {high:?}");
        let [low, high] = of(flat(-std::f64::consts::PI));
        assert!((high[1] - 1.0).abs() < 1e-12 && low[1].abs() < 1e-12, "{low:?} {high:?}");
    }
}
