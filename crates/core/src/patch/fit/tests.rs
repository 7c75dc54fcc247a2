use super::{refine, start, surface::Surface};
use crate::math::vec3::{add, add_scaled, cross, dot, scale, unit};
use crate::shapes::Rng;

/// Points and outward normals over part of a surface of revolution; `at(u)` is its profile: radius and height, and the normal.
fn turned(at: impl Fn(f64) -> ([f64; 2], [f64; 2]), arc: f64) -> (Vec<[f64; 3]>, Vec<[f64; 3]>, [f64; 3]) {
    let axis = unit([0.3, -0.5, 0.8]);
    let x = unit(cross(axis, [1.0, 0.0, 0.0]));
    let y = cross(axis, x);
    let mut rng = Rng::new(9);
    let (mut points, mut normals) = (Vec::new(), Vec::new());
    for _ in 0..300 {
        let (angle, u) = (rng.between(0.0, arc), rng.between(0.0, 1.0));
        let out = add_scaled(scale(x, angle.cos()), y, angle.sin());
        let ([r, h], [nr, nh]) = at(u);
        points.push(add([5.0, 2.0, -3.0], add_scaled(scale(out, r), axis, h)));
        normals.push(add_scaled(scale(out, nr), axis, nh));
    }
    (points, normals, axis)
}

/// The best surface for exact points.
fn found(points: &[[f64; 3]], normals: &[[f64; 3]]) -> Surface {
    let refined = start::all(points, normals).into_iter().filter_map(|s| refine::refine(s, points));
    refined.map(|s| (super::cost(&s, points, 1e-3), s)).min_by(|a, b| a.0.total_cmp(&b.0)).unwrap().1
}

#[test]
fn a_third_of_a_cylinder_is_found_with_its_axis_and_radius() {
    let (points, normals, axis) = turned(|u| ([3.0, 4.0 * u], [1.0, 0.0]), 2.0);
    let Surface::Cylinder { axis: a, radius, .. } = found(&points, &normals) else { panic!() };
    assert!((radius - 3.0).abs() < 1e-6, "{radius}");
    assert!(dot(a, axis).abs() > 1.0 - 1e-9);
}

#[test]
fn a_part_of_a_cone_is_found_with_its_angle() {
    let (sin, cos) = 0.4_f64.sin_cos();
    let (points, normals, axis) = turned(|u| ([(2.0 + u) * sin, (2.0 + u) * cos], [cos, -sin]), 2.5);
    let Surface::Cone { axis: a, half_angle, apex } = found(&points, &normals) else { panic!() };
    assert!((half_angle - 0.4).abs() < 1e-6, "{half_angle}");
    assert!(dot(a, axis) > 1.0 - 1e-9);
    assert!(apex.iter().zip([5.0, 2.0, -3.0]).all(|(x, y)| (x - y).abs() < 1e-5), "{apex:?}");
}

#[test]
fn a_part_of_a_sphere_is_found_with_its_center() {
    let (points, normals, _) = turned(|u| ([2.0 * u.sin(), 2.0 * u.cos()], [u.sin(), u.cos()]), 3.0);
    let Surface::Sphere { center, radius } = found(&points, &normals) else { panic!() };
    assert!((radius - 2.0).abs() < 1e-6, "{radius}");
    assert!(center.iter().zip([5.0, 2.0, -3.0]).all(|(x, y)| (x - y).abs() < 1e-5), "{center:?}");
}

#[test]
fn a_part_of_a_torus_is_found_with_both_radii() {
    let at =
        |u: f64| ([6.0 + 1.5 * (2.0 * u).cos(), 1.5 * (2.0 * u).sin()], [(2.0 * u).cos(), (2.0 * u).sin()]);
    let (points, normals, axis) = turned(at, 2.0);
    let Surface::Torus { axis: a, major, minor, .. } = found(&points, &normals) else { panic!() };
    assert!((major - 6.0).abs() < 1e-5 && (minor - 1.5).abs() < 1e-5, "{major} {minor}");
    assert!(dot(a, axis).abs() > 1.0 - 1e-9);
}

#[test]
fn a_plane_stays_a_plane() {
    let (points, normals, axis) = turned(|u| ([4.0 * u, 0.0], [0.0, 1.0]), 6.0);
    let Surface::Plane { normal, .. } = found(&points, &normals) else { panic!() };
    assert!(dot(normal, axis) > 1.0 - 1e-9);
}

#[test]
fn a_plane_with_a_few_points_of_another_face_is_no_sphere() {
    let mut rng = Rng::new(4);
    let mut points: Vec<[f64; 3]> = (0..600)
        .map(|_| [rng.between(0.0, 60.0), rng.between(0.0, 40.0), rng.between(-0.05, 0.05)])
        .collect();
    points.extend((0..12).map(|k| [0.1, f64::from(k), -0.4 - 0.1 * f64::from(k)]));
    let normals = vec![[0.0, 0.0, 1.0]; points.len()];
    let Surface::Plane { normal, .. } = found(&points, &normals) else {
        panic!("{:?}", found(&points, &normals))
    };
    assert!(normal[2] > 0.999, "{normal:?}");
}
