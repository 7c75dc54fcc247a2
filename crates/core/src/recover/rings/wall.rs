//! The wall of a ring: the face that leads along its axis, as far as it goes all the way round.

use super::ground::{Ground, Ring};
use crate::curve::Round;
use crate::math::vec3::add_scaled;
use crate::recover::faces::Sweep;
use std::f64::consts::TAU;

/// Least part of a wall's direction that leads along the axis.
const UPRIGHT: f64 = 0.9;
/// How far a wall is followed, in spacings.
const FAR: f64 = 24.0;
/// Length of a band of the wall, in spacings; bands begin at every half. Length of a part of it around the axis, and the fewest parts.
const BAND: f64 = 1.0;
const PART: (f64, usize) = (1.5, 6);
/// Least share of the parts of a band that have points on the wall.
const FULL: f64 = 0.5;
/// Distance of points on the wall in standard deviations, and the least in spacings.
const ON: (f64, f64) = (3.0, 0.2);
/// Greatest slope of a wall against the direction of its face at the ring; what is allowed for the tilt of the axis; and the weight of the
/// direction at the ring, as a square of a length in spacings.
const TILT: f64 = 0.15;
const DRIFT: f64 = 0.03;
const STEADY: f64 = 100.0;
/// Ends that are tried, in spacings from the middle of the last band.
const TRIED: [f64; 3] = [0.25, -0.25, 0.75];
/// Distance from a wall of a line that is taken for part of it, in spacings; the radius within which most points must be on it, and
/// their least share.
const BESIDE: (f64, f64, f64) = (1.3, 1.5, 0.8);

/// A wall from the ring on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wall {
    /// Direction across the ring, as that of a face.
    angle: f64,
    /// Its length.
    length: f64,
    /// Greatest distance of its points.
    on: f64,
    /// Whether it ends there.
    ends: bool,
}

impl Wall {
    /// The walls of a ring.
    pub(super) fn of(ring: &Ring, ground: &Ground) -> Vec<Wall> {
        let walls = ring.profile.faces.iter().filter(|f| f.angle.sin().abs() >= UPRIGHT);
        walls.filter_map(|face| along(ring, ground, face.angle)).collect()
    }

    /// Circles about the axis at which it may end.
    pub(super) fn rims(&self, ring: &Ring) -> Vec<Round> {
        let (sin, cos) = self.angle.sin_cos();
        let at = |more: &f64| {
            let s = self.length + more * ring.spacing;
            let centre = add_scaled(ring.round.centre, ring.round.normal, s * sin);
            Round { centre, radius: ring.round.radius + s * cos, ..ring.round }
        };
        let tried = TRIED.iter().filter(|_| self.ends);
        tried.map(at).filter(|r| r.radius > 0.0).collect()
    }

    /// Radius around the ring's centre within which the wall lies.
    pub(super) fn reach(&self, ring: &Ring) -> f64 {
        ring.round.radius.hypot(self.length) + BESIDE.0 * ring.spacing
    }

    /// Length along the wall and distance from it at a place.
    fn place(&self, sweep: &Sweep, place: [f64; 3]) -> [f64; 2] {
        let (sin, cos) = self.angle.sin_cos();
        let [x, y] = sweep.see(place).at;
        [cos * x + sin * y, cos * y - sin * x]
    }

    /// Whether the points around a place of a line lie on the wall, so that there is no fold.
    pub(super) fn explains(&self, ring: &Ring, ground: &Ground, place: [f64; 3]) -> bool {
        let (off, radius, share) = BESIDE;
        let h = ring.spacing;
        let sweep = ring.sweep();
        let [along, aside] = self.place(&sweep, place);
        if aside.abs() > off * h || !(0.0..=self.length).contains(&along) {
            return false;
        }
        let (mut on, mut all) = (0.0, 0.0);
        ground.index.around(place, radius * h, |f| {
            let [along, aside] = self.place(&sweep, ground.points[f.index as usize]);
            if along > 0.0 && along < self.length {
                all += 1.0;
                on += f64::from(u8::from(aside.abs() <= self.on + DRIFT * along));
            }
        });
        on >= share * all
    }
}

/// The wall in one direction across the ring, followed band by band: the direction is that of the bands so far.
fn along(ring: &Ring, ground: &Ground, angle: f64) -> Option<Wall> {
    let (h, round) = (ring.spacing, ring.round);
    let on = (ON.0 * ring.spread).max(ON.1 * h);
    let mut wall = Wall { angle, length: 0.0, on, ends: false };
    let sweep = ring.sweep();
    let around = TAU * round.radius;
    let parts = ((around / (PART.0 * h)).ceil() as usize).max(PART.1);
    // Length along the wall, distance from it, and part of the circle of the points near it.
    let mut near: Vec<([f64; 2], usize)> = Vec::new();
    ground.index.around(round.centre, (round.radius + on).hypot(FAR * h), |f| {
        let place = ground.points[f.index as usize];
        let at = wall.place(&sweep, place);
        if (0.0..FAR * h).contains(&at[0]) && at[1].abs() <= on + TILT * at[0] {
            near.push((at, (sweep.see(place).phase / around * parts as f64) as usize % parts));
        }
    });
    near.sort_by(|a, b| a.0[0].total_cmp(&b.0[0]).then(a.0[1].total_cmp(&b.0[1])));
    let (mut met, mut from, mut slope) = (vec![false; parts], 0, 0.0);
    let (mut products, mut squares) = (0.0, STEADY * h * h);
    let mut reached = 0.0;
    while reached < FAR * h {
        let to = reached + BAND * h;
        met.fill(false);
        from += near[from..].partition_point(|(at, _)| at[0] < reached);
        let count = near[from..].partition_point(|(at, _)| at[0] < to);
        for ([along, off], part) in &near[from..from + count] {
            if (off - slope * along).abs() <= on + DRIFT * along {
                met[*part] = true;
                products += along * off;
                squares += along * along;
            }
        }
        if (met.iter().filter(|m| **m).count() as f64) < FULL * parts as f64 {
            wall.ends = true;
            break;
        }
        slope = products / squares;
        reached += 0.5 * BAND * h;
        wall.length = reached;
    }
    wall.angle += slope.atan();
    (wall.length > 0.0).then_some(wall)
}
