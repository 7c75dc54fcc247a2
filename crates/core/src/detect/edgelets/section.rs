//! The cross-section of the surface at a seed: the points beside a line of the field, pooled in the plane across it.

use super::field::Field;
use crate::math::vec3::{add_scaled, cross, dot, norm, scale, sub, unit};
use crate::resolution::Resolution;

/// Half the width of a section, in spacings.
pub(super) const WIDE: f64 = 4.2;
/// Greatest distance of a corner from the seed, in spacings.
pub(super) const CENTRE: f64 = 2.5;
/// Stations on either side of the seed without noise, one spacing apart, what noise adds to them in its own unit of spacings, and
/// the greatest number: where the line turns, and where it is nearly straight.
const STATIONS: (f64, f64, f64) = (4.0, 20.0, 9.0);
const STRAIGHT: (f64, f64, f64) = (8.0, 24.0, 16.0);
/// Greatest turn of the line from one station to the next, and of one that is nearly straight from the seed on: cosines. The points
/// of many stations around a bend do not fall on one curve.
const TURN: f64 = 0.85;
const BENT: f64 = 0.9;
/// Least certainty of the field beside the next station: sum of weights, and share of it that points one way.
const CERTAIN: (f64, f64) = (0.3, 0.8);
/// Least number of points of a section.
const FEW: usize = 20;
/// Least part of a point's normal that lies in the plane of the section.
const UPRIGHT: f64 = 0.7;

/// How far a section reaches, in spacings.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reach {
    /// Half its width.
    wide: f64,
    /// Stations on either side of the seed where the line turns.
    bent: usize,
    /// The same where it is nearly straight.
    straight: usize,
}

impl Reach {
    /// That of a section in which creases are looked for, at a noise in spacings.
    pub(super) fn narrow(noise: f64) -> Reach {
        let stations = |(fewest, noisy, most): (f64, f64, f64)| (fewest + noisy * noise).min(most) as usize;
        Reach { wide: WIDE, bent: stations(STATIONS), straight: stations(STRAIGHT) }
    }

    /// A reach of its own.
    pub(super) fn of(wide: f64, stations: usize) -> Reach {
        Reach { wide, bent: stations, straight: stations }
    }
}

/// A point across the line, in spacings: as measured, at its place on the surface, and its normal.
#[derive(Clone, Copy, Debug)]
pub(super) struct Across {
    pub(super) raw: [f64; 2],
    pub(super) place: [f64; 2],
    pub(super) normal: [f64; 2],
}

/// A cross-section with its frame at the seed: the direction of the line and two axes across it.
#[derive(Clone, Debug, Default)]
pub(super) struct Section {
    pub(super) origin: [f64; 3],
    pub(super) axes: [[f64; 3]; 3],
    /// The point at which it is taken.
    pub(super) seed: u32,
    /// The spacing there.
    pub(super) unit: f64,
    /// Noise in spacings.
    pub(super) noise: f64,
    pub(super) points: Vec<Across>,
    /// Number of stations, one spacing apart.
    pub(super) stations: usize,
}

#[derive(Clone, Copy)]
struct Station {
    place: [f64; 3],
    axes: [[f64; 3]; 3],
}

impl Section {
    /// Takes the section at a point; false where the field has no direction, or where it comes to a crowded place.
    pub(super) fn take(&mut self, field: &Field, seed: usize) -> bool {
        let Resolution { spacing, noise } = field.scales.at(seed);
        self.take_within(field, seed, Reach::narrow(noise / spacing))
    }

    /// As [`Section::take`], of another reach.
    pub(super) fn take_within(&mut self, field: &Field, seed: usize, reach: Reach) -> bool {
        let Some((along, _)) = field.along(seed) else { return false };
        let resolution = field.scales.at(seed);
        let normal = field.normal(seed);
        let across = unit(add_scaled(normal, along, -dot(normal, along)));
        let start = Station { place: field.place(seed), axes: [along, across, cross(along, across)] };
        self.seed = seed as u32;
        self.origin = start.place;
        self.axes = start.axes;
        self.unit = resolution.spacing;
        self.noise = resolution.noise / resolution.spacing;
        self.points.clear();
        self.stations = 1;
        if !self.pool(field, &start, reach.wide) {
            return false;
        }
        let around = self.follow(field, &start, -1.0, reach) && self.follow(field, &start, 1.0, reach);
        around && self.points.len() >= FEW
    }

    /// Adds the points beside the stations on one side of the seed; false where it comes to a crowded place.
    fn follow(&mut self, field: &Field, start: &Station, sign: f64, reach: Reach) -> bool {
        let mut at = *start;
        for k in 0..reach.straight {
            let Some(next) = step(field, &at, sign * self.unit) else { break };
            if k >= reach.bent && dot(next.axes[0], start.axes[0]) < BENT {
                break;
            }
            if !self.pool(field, &next, reach.wide) {
                return false;
            }
            at = next;
            self.stations += 1;
        }
        true
    }

    /// Adds the points beside a station; false where it is crowded.
    fn pool(&mut self, field: &Field, station: &Station, wide: f64) -> bool {
        let [along, u, v] = station.axes;
        let per = 1.0 / self.unit;
        field.around(station.place, wide, self.unit, |f| {
            let j = f.index as usize;
            let d = scale(sub(field.points[j], station.place), per);
            if !(-0.5..0.5).contains(&dot(d, along)) {
                return;
            }
            let normal = field.normal(j);
            let normal = [dot(normal, u), dot(normal, v)];
            let length = (normal[0] * normal[0] + normal[1] * normal[1]).sqrt();
            if length < UPRIGHT {
                return;
            }
            let q = scale(sub(field.place(j), station.place), per);
            self.points.push(Across {
                raw: [dot(d, u), dot(d, v)],
                place: [dot(q, u), dot(q, v)],
                normal: normal.map(|x| x / length),
            });
        })
    }

    /// A direction or offset of the section in space.
    pub(super) fn in_space(&self, [u, v]: [f64; 2]) -> [f64; 3] {
        add_scaled(scale(self.axes[1], u), self.axes[2], v)
    }
}

/// The next station along the field, by the direction in the middle of the step.
fn step(field: &Field, at: &Station, length: f64) -> Option<Station> {
    let before = at.axes[0];
    let half = direction(field, add_scaled(at.place, before, 0.5 * length), before, length.abs())?;
    let place = add_scaled(at.place, half, length);
    let along = direction(field, place, half, length.abs())?;
    if dot(along, before) < TURN {
        return None;
    }
    let u = unit(add_scaled(at.axes[1], along, -dot(at.axes[1], along)));
    Some(Station { place, axes: [along, u, cross(along, u)] })
}

/// The direction of the field at a place, with the sign of a direction near it.
fn direction(field: &Field, place: [f64; 3], near: [f64; 3], h: f64) -> Option<[f64; 3]> {
    let (mut sum, mut weight) = ([0.0; 3], 0.0);
    let all = field.around(place, 2.0, h, |f| {
        if let Some((along, grade)) = field.along(f.index as usize) {
            let w = grade * (-f.distance2 / (h * h)).exp();
            sum = add_scaled(sum, along, w * dot(along, near).signum());
            weight += w;
        }
    });
    let (least, share) = CERTAIN;
    (all && weight > least && norm(sum) > share * weight).then(|| unit(sum))
}
