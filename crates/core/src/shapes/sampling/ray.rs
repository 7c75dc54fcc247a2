//! Intersections of rays and faces, for the scanner.

use crate::math::vec3::{add_scaled, dot};
use crate::shapes::face::Face;
use crate::shapes::surface::{Axes, FaceSurface};

/// Number of steps in which a torus is searched along a ray. A graze between two steps is missed, as a scanner would miss it.
const STEPS: u32 = 128;

impl Face {
    /// The least distance `t > 0` at which `origin + t direction` (unit) meets the face, from either side.
    pub fn hit(&self, origin: [f64; 3], direction: [f64; 3]) -> Option<f64> {
        let axes = self.surface.axes();
        let (o, d) = (axes.to_local(origin), axes.turn(direction));
        let candidates = match self.surface {
            FaceSurface::Plane { low, high, .. } => {
                [plane(o, d, 0.0, |p| (0..2).all(|k| (low[k]..=high[k]).contains(&p[k]))); 2]
            }
            FaceSurface::Cone { from, to, .. } => cone(o, d, from, to),
            FaceSurface::Sphere { radius, .. } => {
                quadratic(dot(d, d), 2.0 * dot(o, d), dot(o, o) - radius * radius)
            }
            FaceSurface::Torus { ring, tube, .. } => return torus(o, d, ring, tube),
        };
        let seen = |t: &f64| *t > 0.0 && self.holds(add_scaled(origin, direction, *t));
        candidates.into_iter().flatten().filter(seen).min_by(f64::total_cmp)
    }

    /// Points whose box along the world axes holds the whole surface.
    pub(crate) fn extremes(&self) -> Vec<[f64; 3]> {
        let (low, high) = match self.surface {
            FaceSurface::Plane { low, high, .. } => ([low[0], low[1], 0.0], [high[0], high[1], 0.0]),
            FaceSurface::Cone { from, to, .. } => {
                let r = from[0].max(to[0]);
                ([-r, -r, from[1].min(to[1])], [r, r, from[1].max(to[1])])
            }
            FaceSurface::Sphere { radius, .. } => ([-radius; 3], [radius; 3]),
            FaceSurface::Torus { ring, tube, .. } => {
                ([-ring - tube, -ring - tube, -tube], [ring + tube, ring + tube, tube])
            }
        };
        let corner = |bits: usize| {
            let local = [0, 1, 2].map(|k| if bits >> k & 1 == 0 { low[k] } else { high[k] });
            Axes::to_world(self.surface.axes(), local)
        };
        (0..8).map(corner).collect()
    }
}

fn plane(o: [f64; 3], d: [f64; 3], z: f64, within: impl Fn([f64; 3]) -> bool) -> Option<f64> {
    let t = (z - o[2]) / d[2];
    (t.is_finite() && within(add_scaled(o, d, t))).then_some(t)
}

/// Hits of the frustum between two `(r, z)`; of the annulus, if both have the same height.
fn cone(o: [f64; 3], d: [f64; 3], from: [f64; 2], to: [f64; 2]) -> [Option<f64>; 2] {
    let height = to[1] - from[1];
    if height == 0.0 {
        let [small, large] = if from[0] < to[0] { [from[0], to[0]] } else { [to[0], from[0]] };
        let ring = small * small..=large * large;
        return [plane(o, d, from[1], |p| ring.contains(&(p[0] * p[0] + p[1] * p[1]))), None];
    }
    let slope = (to[0] - from[0]) / height;
    let (r, dr) = (from[0] + slope * (o[2] - from[1]), slope * d[2]);
    let a = d[0] * d[0] + d[1] * d[1] - dr * dr;
    let b = 2.0 * (o[0] * d[0] + o[1] * d[1] - r * dr);
    let c = o[0] * o[0] + o[1] * o[1] - r * r;
    let share = |t: f64| (o[2] + t * d[2] - from[1]) / height;
    quadratic(a, b, c).map(|t| t.filter(|&t| (0.0..=1.0).contains(&share(t))))
}

/// Real roots of `a t^2 + b t + c`, without cancellation.
fn quadratic(a: f64, b: f64, c: f64) -> [Option<f64>; 2] {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return [None; 2];
    }
    let q = -0.5 * (b + discriminant.sqrt().copysign(b));
    [q / a, c / q].map(|t| t.is_finite().then_some(t))
}

/// First sign change of the torus' implicit function along the ray, refined by bisection.
fn torus(o: [f64; 3], d: [f64; 3], ring: f64, tube: f64) -> Option<f64> {
    let outer = ring + tube;
    let [near, far] = quadratic(1.0, 2.0 * dot(o, d), dot(o, o) - outer * outer);
    let (near, far) = near.zip(far)?;
    let (start, end) = (near.min(far).max(0.0), near.max(far));
    let value = |t: f64| {
        let p = add_scaled(o, d, t);
        let r = (p[0] * p[0] + p[1] * p[1]).sqrt() - ring;
        r * r + p[2] * p[2] - tube * tube
    };
    let at = |i: u32| start + (end - start) * f64::from(i) / f64::from(STEPS);
    let first = (0..STEPS).find(|&i| (value(at(i)) > 0.0) != (value(at(i + 1)) > 0.0))?;
    let (mut low, mut high) = (at(first), at(first + 1));
    let outside = value(low) > 0.0;
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if (value(middle) > 0.0) == outside { low = middle } else { high = middle }
    }
    (low > 0.0).then_some(low)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::vec3::{scale, sub, unit};
    use crate::shapes::{Rng, brick, cone, cylinders, sphere, torus};

    #[test]
    fn a_ray_at_a_point_of_a_face_hits_it_there() {
        let mut rng = Rng::new(5);
        for shape in [brick(), cone(1.0, 2.0), cylinders(1.0, 0.6), sphere(1.5), torus(2.0, 0.5)] {
            for face in &shape.faces {
                for _ in 0..200 {
                    let p = face.surface.at(face.surface.uniform(&mut rng));
                    let eye = add_scaled(p, face.surface.normal(p), 0.01);
                    if !face.holds(p) {
                        continue;
                    }
                    let t = face.hit(eye, scale(face.surface.normal(p), -1.0)).unwrap();
                    assert!((t - 0.01).abs() < 1e-9, "{} {t}", shape.name);
                }
            }
        }
    }

    #[test]
    fn a_ray_past_a_face_misses_it() {
        let ball = sphere(1.0);
        let from = [5.0, 0.0, 0.0];
        assert!(ball.faces[0].hit(from, unit(sub([0.0, 1.3, 0.0], from))).is_none());
        assert!(ball.faces[0].hit(from, [1.0, 0.0, 0.0]).is_none());
    }
}
