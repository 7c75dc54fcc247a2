//! A range scanner around a shape: rays on a raster, the first surface along each.

use crate::math::vec3::{add, add_scaled, distance, dot, scale, sub, unit};
use crate::shapes::random::Rng;
use crate::shapes::shape::Shape;
use crate::shapes::surface::Axes;
use crate::shapes::turns::sin_cos;

/// The scanner's settings: see `Sampling::Scanner`.
pub(super) struct Rig {
    pub(super) views: u32,
    pub(super) pitch: f64,
    pub(super) distance: Option<f64>,
    pub(super) grazing_deg: f64,
}

/// `(N, 3)` points seen, view by view and row by row, and the face of each.
pub(super) fn scan(shape: &Shape, rig: &Rig, rng: &mut Rng) -> (Vec<[f64; 3]>, Vec<u32>) {
    let [low, high] = shape.bounds();
    let centre = scale(add(low, high), 0.5);
    let radius = distance(low, high) / 2.0;
    let least_cosine = sin_cos(0.25 - rig.grazing_deg / 360.0)[1];
    // An eye at a finite distance sees the sphere's outline widened in the plane through its centre.
    let widened = rig.distance.map_or(1.0, |d| d / (d * d - 1.0).max(f64::EPSILON).sqrt());
    let half = (radius * widened / rig.pitch).ceil() as i32;
    let (mut points, mut faces) = (Vec::new(), Vec::new());
    for view in 0..rig.views {
        let axes = turned(centre, fibonacci(view, rig.views), rng.uniform());
        for (row, column) in (-half..=half).flat_map(|row| (-half..=half).map(move |column| (row, column))) {
            let target = axes.to_world([f64::from(column) * rig.pitch, f64::from(row) * rig.pitch, 0.0]);
            let away = rig.distance.unwrap_or(2.0) * radius;
            let eye = add_scaled(if rig.distance.is_some() { centre } else { target }, axes.z, away);
            if let Some((p, id)) = first_hit(shape, eye, unit(sub(target, eye)), least_cosine) {
                points.push(p);
                faces.push(id);
            }
        }
    }
    (points, faces)
}

/// The nearest face along a ray; `None` if there is none, or if the angle is too flat for a measurement.
fn first_hit(
    shape: &Shape,
    eye: [f64; 3],
    direction: [f64; 3],
    least_cosine: f64,
) -> Option<([f64; 3], u32)> {
    let hits = (0..).zip(&shape.faces).filter_map(|(id, face)| Some((face.hit(eye, direction)?, id)));
    let (t, id): (f64, u32) = hits.min_by(|a, b| a.0.total_cmp(&b.0))?;
    let p = add_scaled(eye, direction, t);
    let cosine = dot(shape.faces[id as usize].normal(p), direction).abs();
    (cosine >= least_cosine).then_some((p, id))
}

/// Direction `i` of `n` spread evenly over the sphere on a golden spiral.
fn fibonacci(i: u32, n: u32) -> [f64; 3] {
    let z = 1.0 - (2.0 * f64::from(i) + 1.0) / f64::from(n);
    let r = (1.0 - z * z).sqrt();
    let [c, s] = sin_cos(f64::from(i) * (5f64.sqrt() - 1.0) / 2.0);
    [r * c, r * s, z]
}

/// A frame that looks along a direction, rolled about it by a number of turns.
fn turned(origin: [f64; 3], direction: [f64; 3], turns: f64) -> Axes {
    let axes = Axes::along(origin, direction);
    let [c, s] = sin_cos(turns);
    let x = add(scale(axes.x, c), scale(axes.y, s));
    let y = sub(scale(axes.y, c), scale(axes.x, s));
    Axes { x, y, ..axes }
}
