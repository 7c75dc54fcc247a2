//! Refines a first guess to the surface of least squared distances.
//!
//! All kinds but the plane are surfaces of revolution, whose distance depends only on the height `h` along the axis and the
//! distance `r` from it. So one Levenberg-Marquardt iteration (D. Marquardt, "An algorithm for least-squares estimation of
//! nonlinear parameters", SIAM Journal 11, 1963) serves all: three parameters move the centre, two tilt the axis, and up to two
//! shape the profile. A parameter that a kind does not have, such as the axis of a sphere, has no slope and does not change.

use super::Surface;
use super::surface::height_and_radius;
use crate::math::skyline::Skyline;
use crate::math::vec3::{add, add_scaled, cross, dot, norm, perpendicular, scale, sub, unit};

const PARAMETERS: usize = 7;
const STEPS: usize = 40;
/// Relative gain below which the iteration is at rest.
const AT_REST: f64 = 1e-10;

/// A surface of revolution: its axis and its profile.
#[derive(Clone, Copy)]
struct Turned {
    kind: Surface,
    center: [f64; 3],
    axis: [f64; 3],
    shape: [f64; 2],
}

/// The refined surface; `None` if the iteration diverges.
pub fn refine(surface: Surface, points: &[[f64; 3]]) -> Option<Surface> {
    let Some(mut at) = Turned::of(surface) else { return Some(surface) };
    let mut damping = 1e-3;
    let mut cost = at.cost(points);
    for _ in 0..STEPS {
        let (normal, slope) = at.equations(points);
        let Some(step) = solve(&normal, &slope, damping) else { break };
        let next = at.moved(&step);
        let next_cost = next.cost(points);
        if next_cost < cost {
            let gain = (cost - next_cost) / cost;
            (at, cost, damping) = (next, next_cost, (0.2 * damping).max(1e-12));
            if gain < AT_REST {
                break;
            }
        } else {
            damping *= 8.0;
            if damping > 1e8 {
                break;
            }
        }
    }
    at.surface(points)
}

impl Turned {
    fn of(kind: Surface) -> Option<Turned> {
        let (center, axis, shape) = match kind {
            Surface::Plane { .. } => return None,
            Surface::Sphere { center, radius } => (center, [0.0, 0.0, 1.0], [radius, 0.0]),
            Surface::Cylinder { point, axis, radius } => (point, axis, [radius, 0.0]),
            Surface::Cone { apex, axis, half_angle } => (apex, axis, [half_angle, 0.0]),
            Surface::Torus { center, axis, major, minor } => (center, axis, [major, minor]),
        };
        Some(Turned { kind, center, axis, shape })
    }

    /// Distance of a point in the half-plane of the profile, and its slopes by `h`, `r` and the two of the shape.
    fn profile(&self, h: f64, r: f64) -> (f64, [f64; 4]) {
        let [s, t] = self.shape;
        match self.kind {
            Surface::Sphere { .. } => {
                let d = (h * h + r * r).sqrt().max(1e-12);
                (d - s, [h / d, r / d, -1.0, 0.0])
            }
            Surface::Cone { .. } => {
                let (sin, cos) = s.sin_cos();
                (r * cos - h * sin, [-sin, cos, -r * sin - h * cos, 0.0])
            }
            Surface::Torus { .. } => {
                let d = ((r - s).powi(2) + h * h).sqrt().max(1e-12);
                (d - t, [h / d, (r - s) / d, -(r - s) / d, -1.0])
            }
            Surface::Cylinder { .. } | Surface::Plane { .. } => (r - s, [0.0, 1.0, -1.0, 0.0]),
        }
    }

    fn cost(&self, points: &[[f64; 3]]) -> f64 {
        let distance = |&p: &[f64; 3]| {
            let (h, r) = height_and_radius(p, self.center, self.axis);
            self.profile(h, r).0
        };
        points.iter().map(|p| distance(p).powi(2)).sum()
    }

    /// The directions in which the axis can tilt.
    fn tilts(&self) -> [[f64; 3]; 2] {
        let first = unit(perpendicular(self.axis));
        [first, cross(self.axis, first)]
    }

    /// Gauss-Newton's matrix and right-hand side.
    fn equations(&self, points: &[[f64; 3]]) -> ([[f64; PARAMETERS]; PARAMETERS], [f64; PARAMETERS]) {
        let tilts = self.tilts();
        let (mut matrix, mut right) = ([[0.0; PARAMETERS]; PARAMETERS], [0.0; PARAMETERS]);
        for &p in points {
            let v = sub(p, self.center);
            let h = dot(v, self.axis);
            let off = add_scaled(v, self.axis, -h);
            let r = norm(off);
            let out = if r > 0.0 { scale(off, 1.0 / r) } else { tilts[0] };
            let (distance, [by_h, by_r, by_s, by_t]) = self.profile(h, r);
            // A centre that moves by d changes h by -axis . d and r by -out . d; an axis that tilts by d, h by v . d and r by
            // -h out . d.
            let [mx, my, mz] = add_scaled(scale(self.axis, -by_h), out, -by_r);
            let tilt = tilts.map(|d| by_h * dot(v, d) - by_r * h * dot(out, d));
            let row = [mx, my, mz, tilt[0], tilt[1], by_s, by_t];
            for i in 0..PARAMETERS {
                right[i] -= row[i] * distance;
                for j in 0..=i {
                    matrix[i][j] += row[i] * row[j];
                }
            }
        }
        (matrix, right)
    }

    fn moved(&self, step: &[f64; PARAMETERS]) -> Turned {
        let [a, b] = self.tilts();
        let axis = unit(add_scaled(add_scaled(self.axis, a, step[3]), b, step[4]));
        let shape = [self.shape[0] + step[5], self.shape[1] + step[6]];
        Turned { center: add(self.center, [step[0], step[1], step[2]]), axis, shape, ..*self }
    }

    /// The surface; `None` unless radii are positive, a cone is neither a plane nor a line, and all numbers are finite.
    fn surface(&self, points: &[[f64; 3]]) -> Option<Surface> {
        let Turned { center, axis, shape: [s, t], .. } = *self;
        let finite = center.iter().chain(&axis).chain(&[s, t]).all(|x| x.is_finite());
        let middle = scale(points.iter().fold([0.0; 3], |a, &p| add(a, p)), 1.0 / points.len().max(1) as f64);
        let found = match self.kind {
            Surface::Plane { .. } => return None,
            Surface::Sphere { .. } => Surface::Sphere { center, radius: s },
            Surface::Cylinder { .. } => {
                let point = add_scaled(center, axis, dot(sub(middle, center), axis));
                Surface::Cylinder { point, axis, radius: s }
            }
            Surface::Cone { .. } => Surface::Cone { apex: center, axis, half_angle: s },
            Surface::Torus { .. } => Surface::Torus { center, axis, major: s, minor: t },
        };
        let sound = match found {
            Surface::Cone { half_angle, .. } => half_angle > 0.01 && half_angle < 1.56,
            Surface::Torus { major, minor, .. } => minor > 0.0 && major > minor,
            _ => s > 0.0,
        };
        (finite && sound).then_some(found)
    }
}

/// The damped step.
fn solve(
    matrix: &[[f64; PARAMETERS]; PARAMETERS],
    right: &[f64; PARAMETERS],
    damping: f64,
) -> Option<[f64; PARAMETERS]> {
    let mut system = Skyline::zeros(vec![0; PARAMETERS]);
    let largest = (0..PARAMETERS).map(|i| matrix[i][i]).fold(0.0, f64::max);
    for i in 0..PARAMETERS {
        for j in 0..i {
            system.add(i, j, matrix[i][j]);
        }
        // A parameter without slope gets a large diagonal, and with it no step.
        let diagonal = matrix[i][i];
        let least = 1e-9 * largest;
        system.add(
            i,
            i,
            diagonal * (1.0 + damping) + if diagonal < least { largest } else { 1e-12 * largest },
        );
    }
    if !(largest > 0.0) || !system.factorise() {
        return None;
    }
    let mut x: Vec<[f64; 3]> = right.iter().map(|&b| [b, 0.0, 0.0]).collect();
    system.solve(&mut x);
    Some(std::array::from_fn(|i| x[i][0]))
}
