//! Curves that go over into each other without a corner: a line whose distance from a centre is the radius, circles whose centres
//! are as far apart as the sum or the difference of their radii.

use super::feature::{Feature, between};
use super::odds;
use crate::math::vec3::{add_scaled, cross, distance, dot, scale, sub, unit};

/// Two curves that meet at a joint.
#[derive(Clone, Copy, Debug)]
pub(super) struct Meeting {
    /// The features.
    pub features: [usize; 2],
    /// The joint.
    pub joint: usize,
    /// Where it lies.
    pub at: [f64; 3],
    /// The unit direction in which each leaves it, as drawn.
    pub leaves: [[f64; 3]; 2],
}

/// Two curves that are tangent.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tangent {
    /// The features.
    pub features: [usize; 2],
    /// The joint.
    pub joint: usize,
    /// Its probability.
    pub likelihood: f64,
    /// Distance that the line or the circles lack or have too much.
    pub deviation: f64,
}

/// Least cosine between the drawn curves of a joint that may be smooth: 25 degrees.
const SMOOTH: f64 = 0.906;
/// Density of the sine between a direction and a plane that have nothing to do with each other.
const CHANCE: f64 = 0.5;

/// Those of the meetings that are smooth.
pub(super) fn tangents(features: &[Feature], meetings: &[Meeting], least: f64) -> Vec<Tangent> {
    let judged = |m: &Meeting| {
        let smooth = -dot(m.leaves[0], m.leaves[1]) >= SMOOTH;
        let (deviation, likelihood) = judge(features, m).filter(|_| smooth)?;
        let Meeting { features, joint, .. } = *m;
        (likelihood >= least).then_some(Tangent { features, joint, likelihood, deviation })
    };
    meetings.iter().filter_map(judged).collect()
}

fn judge(features: &[Feature], meeting: &Meeting) -> Option<(f64, f64)> {
    let [a, b] = meeting.features.map(|i| &features[i]);
    match (a.round(), b.round()) {
        (None, None) => None,
        (None, Some(_)) => Some(line(a, b)),
        (Some(_), None) => Some(line(b, a)),
        (Some(_), Some(_)) => circles(a, b, meeting.at),
    }
}

fn line(line: &Feature, circle: &Feature) -> (f64, f64) {
    let (direction, normal) = (line.direction, circle.direction);
    let radius = circle.observed.half;
    let away = sub(circle.at, line.at);
    let far = dot(away, direction);
    let foot = add_scaled(away, direction, -far);
    let across = unit(foot);
    let deviation = dot(foot, across) - radius;
    let turn = far * far * between(across, &line.turn, across);
    let places = between(across, &line.place, across) + between(across, &circle.place, across);
    let off = odds::of_number(deviation, places + turn + circle.radius_variance(), 1.0 / radius);
    let lean = between(normal, &line.turn, normal) + between(direction, &circle.turn, direction);
    (deviation, off.min(odds::of_number(dot(direction, normal), lean, CHANCE)))
}

fn circles(a: &Feature, b: &Feature, at: [f64; 3]) -> Option<(f64, f64)> {
    let towards = sub(b.at, a.at);
    let apart = distance(a.at, b.at);
    let along = scale(towards, 1.0 / apart);
    let [ra, rb] = [a, b].map(|f| f.observed.half);
    let one_side = dot(sub(a.at, at), sub(b.at, at)) > 0.0;
    let deviation = if one_side { apart - (ra - rb).abs() } else { apart - ra - rb };
    let places = between(along, &a.place, along) + between(along, &b.place, along);
    let variance = places + a.radius_variance() + b.radius_variance();
    let off = odds::of_number(deviation, variance, 1.0 / ra.max(rb));
    let sine = cross(a.direction, b.direction);
    let tilt = unit(sine);
    let turned = cross(tilt, a.direction);
    let lean = between(turned, &a.turn, turned) + between(turned, &b.turn, turned);
    let flat = odds::of_number(dot(sine, tilt), lean, CHANCE);
    // Arcs of one circle are not tangent but the same.
    let same = one_side && apart * apart <= odds::bound(1) * places;
    (!same && apart > 0.0).then_some((deviation, off.min(flat)))
}
