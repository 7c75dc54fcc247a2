//! The points beside a line of the field, in the plane across it.

use super::knobs;
use super::field::Field;
use crate::math::vec3::{add_scaled, cross, dot, norm, scale, sub, unit};
use crate::neighbors::Index;
use crate::surface::Scales;

/// A point across the line, in spacings, with its denoised place and normal there.
#[derive(Clone, Copy)]
pub(super) struct Across {
    pub(super) raw: [f64; 2],
    pub(super) place: [f64; 2],
    pub(super) normal: [f64; 2],
}

/// The frame at the seed: the line's direction and two axes across it.
pub(super) struct Section {
    pub(super) origin: [f64; 3],
    pub(super) axes: [[f64; 3]; 3],
    pub(super) unit: f64,
    pub(super) noise: f64,
    pub(super) points: Vec<Across>,
    pub(super) stations: usize,
}

const WIDE: f64 = 4.2;

struct Station {
    place: [f64; 3],
    axes: [[f64; 3]; 3],
}

pub(super) fn section(points: &[[f64; 3]], field: &Field, index: &Index, scales: Scales, seed: usize) -> Section {
    let r = scales.at(seed);
    let h = r.spacing;
    let noise = r.noise / h;
    let reach = (4.0 + knobs().half * noise).clamp(4.0, 9.0) as usize;
    let t = field.along[seed];
    let u = unit(add_scaled(field.normal[seed], t, -dot(field.normal[seed], t)));
    let start = Station { place: field.place[seed], axes: [t, u, cross(t, u)] };
    let mut stations = vec![];
    for sign in [-1.0, 1.0] {
        let mut at = Station { place: start.place, axes: start.axes };
        for _ in 0..reach {
            let Some(next) = step(field, index, &at, sign * h) else { break };
            at = Station { place: next.place, axes: next.axes };
            stations.push(next);
        }
    }
    let axes = start.axes;
    stations.push(start);
    let mut across = Vec::new();
    for s in &stations {
        index.around(s.place, WIDE * h, |f| {
            let j = f.index as usize;
            let d = scale(sub(points[j], s.place), 1.0 / h);
            if !(-0.5..0.5).contains(&dot(d, s.axes[0])) {
                return;
            }
            let q = scale(sub(field.place[j], s.place), 1.0 / h);
            let [_, u, v] = s.axes;
            let n = [dot(field.normal[j], u), dot(field.normal[j], v)];
            let length = (n[0] * n[0] + n[1] * n[1]).sqrt();
            if length < 0.7 {
                return;
            }
            across.push(Across {
                raw: [dot(d, u), dot(d, v)],
                place: [dot(q, u), dot(q, v)],
                normal: [n[0] / length, n[1] / length],
            });
        });
    }
    Section { origin: field.place[seed], axes, unit: h, noise, points: across, stations: stations.len() }
}

/// One step along the field, by the direction in its middle.
fn step(field: &Field, index: &Index, at: &Station, length: f64) -> Option<Station> {
    let h = length.abs();
    let t0 = at.axes[0];
    let direction = |p: [f64; 3], near: [f64; 3]| -> Option<[f64; 3]> {
        let mut sum = [0.0; 3];
        let mut n = 0.0;
        index.around(p, 2.0 * h, |f| {
            let j = f.index as usize;
            let c = dot(field.along[j], near);
            let w = f64::from(field.grade[j]) * (-f.distance2 / (h * h)).exp();
            sum = add_scaled(sum, field.along[j], w * c.signum());
            n += w;
        });
        (n > 0.3 && norm(sum) > 0.8 * n).then(|| unit(sum))
    };
    let half = direction(add_scaled(at.place, t0, 0.5 * length), t0)?;
    let place = add_scaled(at.place, half, length);
    let t = direction(place, half)?;
    if dot(t, t0) < 0.85 {
        return None;
    }
    let u = unit(add_scaled(at.axes[1], t, -dot(at.axes[1], t)));
    Some(Station { place, axes: [t, u, cross(t, u)] })
}
