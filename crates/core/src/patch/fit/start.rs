//! First guesses of the surfaces from points and normals.
//!
//! The axis of a cylinder is at right angles to all normals, and that of a cone has one angle to all of them. The axis of
//! a torus meets all normal lines: H. Pottmann and T. Randrup ("Rotational and helical surface approximation for reverse
//! engineering", Computing 60, 1998, section 2) fit a linear complex to the normal lines; here one of no pitch is taken.

use super::Surface;
use super::surface::height_and_radius;
use crate::math::eigen3::{Eigen3, eigen3};
use crate::math::tensor::scatter;
use crate::math::vec3::{add, add_scaled, cross, dot, norm, perpendicular, scale, sub, unit};

/// A first guess of each kind of surface, where points and normals allow one.
pub fn all(points: &[[f64; 3]], normals: &[[f64; 3]]) -> Vec<Surface> {
    let mut found = vec![plane_towards(points, normals)];
    found.extend(sphere(points));
    let gauss = tensor(normals.iter().copied()).vectors[0];
    found.extend(cylinder(points, gauss));
    found.extend(cone(points, normals));
    if let Some((on, axis)) = revolution(points, normals) {
        found.extend(torus(points, on, axis));
        found.extend(cylinder(points, axis));
    }
    found
}

/// The least-squares plane.
pub fn plane(points: &[[f64; 3]]) -> Surface {
    let point = mean(points);
    let normal = tensor(points.iter().map(|&p| sub(p, point))).vectors[0];
    Surface::Plane { point, normal }
}

fn plane_towards(points: &[[f64; 3]], normals: &[[f64; 3]]) -> Surface {
    match plane(points) {
        Surface::Plane { point, normal } if dot(normal, mean(normals)) < 0.0 => {
            Surface::Plane { point, normal: scale(normal, -1.0) }
        }
        plane => plane,
    }
}

fn mean(points: &[[f64; 3]]) -> [f64; 3] {
    let sum = points.iter().fold([0.0; 3], |sum, &p| add(sum, p));
    scale(sum, 1.0 / points.len().max(1) as f64)
}

/// Eigensystem of the sum of `v v^t` over vectors.
fn tensor(vectors: impl Iterator<Item = [f64; 3]>) -> Eigen3 {
    eigen3(&scatter(vectors))
}

/// Solves `sum (v v^t) x = sum (v b)` in the span of the vectors.
fn solve(rows: &[([f64; 3], f64)]) -> Option<[f64; 3]> {
    let Eigen3 { values, vectors } = tensor(rows.iter().map(|r| r.0));
    if !(values[2] > 0.0) {
        return None;
    }
    let right = rows.iter().fold([0.0; 3], |sum, (v, b)| add_scaled(sum, *v, *b));
    Some(
        (0..3)
            .filter(|&k| values[k] > 1e-9 * values[2])
            .fold([0.0; 3], |x, k| add_scaled(x, vectors[k], dot(right, vectors[k]) / values[k])),
    )
}

/// The algebraic fit: `|p|^2 - 2 c . p` is constant.
fn sphere(points: &[[f64; 3]]) -> Option<Surface> {
    let middle = mean(points);
    let square = points.iter().map(|&p| norm(sub(p, middle)).powi(2)).sum::<f64>() / points.len() as f64;
    let rows: Vec<([f64; 3], f64)> =
        points.iter().map(|&p| sub(p, middle)).map(|v| (scale(v, 2.0), dot(v, v) - square)).collect();
    let c = solve(&rows)?;
    Some(Surface::Sphere { center: add(middle, c), radius: (square + dot(c, c)).sqrt() })
}

/// A circle through the points seen along the axis.
fn cylinder(points: &[[f64; 3]], axis: [f64; 3]) -> Option<Surface> {
    let middle = mean(points);
    let flat: Vec<[f64; 3]> =
        points.iter().map(|&p| sub(p, middle)).map(|v| add_scaled(v, axis, -dot(v, axis))).collect();
    let square = flat.iter().map(|&v| dot(v, v)).sum::<f64>() / flat.len() as f64;
    let rows: Vec<([f64; 3], f64)> = flat.iter().map(|&v| (scale(v, 2.0), dot(v, v) - square)).collect();
    let c = solve(&rows)?;
    let point = add(middle, c);
    Some(Surface::Cylinder { point, axis, radius: (square + dot(c, c)).sqrt() })
}

/// The normals lie on a circle of the unit sphere, and all tangent planes meet in the apex.
fn cone(points: &[[f64; 3]], normals: &[[f64; 3]]) -> Option<Surface> {
    let around = mean(normals);
    let axis = tensor(normals.iter().map(|&n| sub(n, around))).vectors[0];
    let rows: Vec<([f64; 3], f64)> = points.iter().zip(normals).map(|(&p, &n)| (n, dot(n, p))).collect();
    let middle = mean(points);
    let apex = solve(&rows.iter().map(|&(n, d)| (n, d - dot(n, middle))).collect::<Vec<_>>())?;
    let apex = add(middle, apex);
    let axis = if dot(sub(middle, apex), axis) < 0.0 { scale(axis, -1.0) } else { axis };
    let (mut height, mut radius) = (0.0, 0.0);
    for &p in points {
        let (h, r) = height_and_radius(p, apex, axis);
        (height, radius) = (height + h, radius + r);
    }
    Some(Surface::Cone { apex, axis, half_angle: f64::atan2(radius, height) })
}

/// The axis nearest to all normal lines, and a point on it.
///
/// A line through `p` along `n` meets the axis of direction `c` through `q` where `n . (q x c) + (p x n) . c = 0`.
fn revolution(points: &[[f64; 3]], normals: &[[f64; 3]]) -> Option<([f64; 3], [f64; 3])> {
    let middle = mean(points);
    let moments: Vec<[f64; 3]> =
        points.iter().zip(normals).map(|(&p, &n)| cross(sub(p, middle), n)).collect();
    // The best moment of the axis is linear in its direction: one column for each unit vector.
    let columns: Vec<[f64; 3]> = (0..3)
        .map(|k| solve(&normals.iter().zip(&moments).map(|(&n, m)| (n, -m[k])).collect::<Vec<_>>()))
        .collect::<Option<_>>()?;
    let rest = normals.iter().zip(&moments).map(|(&n, m)| {
        let row: [f64; 3] = std::array::from_fn(|k| m[k] + dot(n, columns[k]));
        row
    });
    let c = tensor(rest).vectors[0];
    let moment = (0..3).fold([0.0; 3], |sum, k| add_scaled(sum, columns[k], c[k]));
    // `q x c = moment`, at the point of the axis next to the middle.
    Some((add(middle, cross(c, moment)), c))
}

/// A circle through the points turned into one half-plane.
fn torus(points: &[[f64; 3]], on: [f64; 3], axis: [f64; 3]) -> Option<Surface> {
    let side = unit(perpendicular(axis));
    let turned: Vec<[f64; 3]> = points
        .iter()
        .map(|&p| height_and_radius(p, on, axis))
        .map(|(h, r)| add_scaled(scale(axis, h), side, r))
        .collect();
    let Surface::Cylinder { point, radius, .. } = cylinder(&turned, cross(axis, side))? else { return None };
    let (h, major) = (dot(point, axis), dot(point, side));
    (major > 0.0).then(|| Surface::Torus { center: add_scaled(on, axis, h), axis, major, minor: radius })
}
