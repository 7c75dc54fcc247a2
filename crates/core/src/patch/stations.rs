//! Stations along the strips: place, tangent and a rotation-minimizing frame.
//!
//! The frame is W. Wang, B. Jüttler, D. Zheng and Y. Liu's double reflection ("Computation of rotation minimizing frames", ACM
//! Transactions on Graphics 27, 2008, section 3): directions across a strip can be compared from station to station in it.

use crate::math::vec3::{add_scaled, cross, dot, norm, perpendicular, scale, sub, unit};
use crate::network::{Network, Strip, StripKind};
use crate::surface::Scales;

/// Greatest distance between stations, in spacings at the densest place of the strip.
const STATION_STEP: f64 = 0.6;
/// Greatest number of stations for each source of a strip, beyond which they lie farther apart: in a cloud of two scales a strip
/// can have any number of spacings. Links between points of one scale need less than half as many.
const STATIONS_A_SOURCE: usize = 64;
/// Greatest number of stations of all strips together for each point of the cloud: in a cloud of many scales the strips can have
/// several times as many sources as the cloud has points.
const STATIONS_A_POINT: usize = 16;

/// A station: a place on a strip with its frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station {
    /// The strip that it lies on.
    pub strip: u32,
    /// Local frame.
    pub position: [f64; 3],
    /// Unit tangent in the direction of the strip.
    pub tangent: [f64; 3],
    /// Unit vectors across the strip, at right angles to each other and the tangent.
    pub across: [[f64; 3]; 2],
    /// The end of the strip at this station: `-1.0` at its start, `1.0` at its end, zero within it.
    pub end: f64,
    /// Unit directions in `across` coordinates in which the surface leaves the strip; the second is `None` at a border.
    pub leaves: [Option<[f64; 2]>; 2],
}

/// The stations of all strips, strip after strip.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stations {
    /// All stations.
    pub all: Vec<Station>,
    /// `(S + 1)` index of the first station of each strip, and their number.
    pub first: Vec<usize>,
    /// `(S)` whether the strip is a border.
    pub border: Vec<bool>,
}

impl Stations {
    /// The stations of one strip.
    pub fn of(&self, strip: usize) -> &[Station] {
        &self.all[self.first[strip]..self.first[strip + 1]]
    }
}

/// Stations at the points of each strip, and between points that are far apart, in a cloud of `points` points.
pub fn stations(network: &Network, scales: Scales, points: usize) -> Stations {
    let sources: usize = network.strips.iter().map(|strip| strip.sources.len()).sum();
    let each = (STATIONS_A_POINT * points / sources.max(1)).clamp(2, STATIONS_A_SOURCE);
    let mut stations = Stations { first: vec![0], ..Default::default() };
    for (s, strip) in network.strips.iter().enumerate() {
        let step = STATION_STEP * scales.finest(&strip.sources).spacing;
        append(&mut stations.all, s as u32, strip, &places(strip, step, each));
        stations.first.push(stations.all.len());
        stations.border.push(strip.kind == StripKind::Border);
    }
    stations
}

fn append(all: &mut Vec<Station>, number: u32, strip: &Strip, places: &[[f64; 3]]) {
    let count = places.len();
    let first = all.len();
    for i in 0..count {
        let before = if i > 0 || strip.closed { places[(i + count - 1) % count] } else { places[i] };
        let after = if i + 1 < count || strip.closed { places[(i + 1) % count] } else { places[i] };
        let tangent = unit(sub(after, before));
        let across = match i {
            0 => start(tangent),
            _ => reflected(&all[first + i - 1], places[i], tangent),
        };
        let end = match (strip.closed, i) {
            (true, _) => 0.0,
            (false, 0) => -1.0,
            (false, i) if i + 1 == count => 1.0,
            _ => 0.0,
        };
        all.push(Station { strip: number, position: places[i], tangent, across, end, leaves: [None; 2] });
    }
}

/// Points along a strip, including the closing segment of a loop, no farther than `step` apart as far as `each`, the number of
/// stations for a source, allows.
fn places(strip: &Strip, step: f64, each: usize) -> Vec<[f64; 3]> {
    let most = each * strip.sources.len().max(2);
    let points = thinned(strip, most);
    let count = points.len();
    let segments = if strip.closed { count } else { count.saturating_sub(1) };
    let ends = |i: usize| (points[i], points[(i + 1) % count]);
    let length: f64 = (0..segments).map(ends).map(|(a, b)| norm(sub(b, a))).sum();
    let step = step.max(length / most as f64);
    let mut places = Vec::with_capacity(count);
    for i in 0..segments {
        let (a, b) = ends(i);
        let pieces = (norm(sub(b, a)) / step).ceil().clamp(1.0, most as f64) as usize;
        places.extend((0..pieces).map(|p| add_scaled(a, sub(b, a), p as f64 / pieces as f64)));
    }
    if !strip.closed {
        places.extend(points.last());
    }
    places
}

/// About `most` points of a strip, including its ends; all points if there are no more.
fn thinned(strip: &Strip, most: usize) -> Vec<[f64; 3]> {
    let every = strip.points.len().div_ceil(most).max(1);
    let mut points: Vec<_> = strip.points.iter().copied().step_by(every).collect();
    let whole = strip.points.len().saturating_sub(1).is_multiple_of(every);
    points.extend(strip.points.last().filter(|_| !whole && !strip.closed));
    points
}

fn start(tangent: [f64; 3]) -> [[f64; 3]; 2] {
    let first = unit(perpendicular(tangent));
    [first, cross(tangent, first)]
}

/// The frame of the previous station, reflected in the plane between both places, then in the plane between both tangents.
fn reflected(from: &Station, to: [f64; 3], tangent: [f64; 3]) -> [[f64; 3]; 2] {
    let mirror = |x: [f64; 3], axis: [f64; 3]| {
        let square = dot(axis, axis);
        if square > 0.0 { add_scaled(x, axis, -2.0 * dot(axis, x) / square) } else { x }
    };
    let step = sub(to, from.position);
    let (side, along) = (mirror(from.across[0], step), mirror(from.tangent, step));
    let side = mirror(side, sub(tangent, along));
    // The frame is made orthonormal again, so that rounding cannot add up along a long strip.
    let side = add_scaled(side, tangent, -dot(side, tangent));
    let length = norm(side);
    if length > 0.5 {
        let side = scale(side, 1.0 / length);
        [side, cross(tangent, side)]
    } else {
        start(tangent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A loop of 25 sources.
    fn border() -> Strip {
        Strip {
            kind: StripKind::Border,
            closed: true,
            start: None,
            end: None,
            points: (0..16_000).map(|i| [f64::from(i), f64::from(i % 3), 0.0]).collect(),
            curve: Default::default(),
            sources: (0..25).collect(),
            deviation: 0.0,
            fold_deg: None,
            evidence: None,
            curves: Vec::new(),
            confidence: 1.0,
            sigma: Vec::new(),
            blend: None,
        }
    }

    #[test]
    fn strips_of_any_number_have_a_bounded_number_of_stations_together() {
        let network = Network { strips: vec![border(); 100], ..Network::default() };
        let tiny = crate::Resolution { spacing: 1e-9, noise: 0.0 };
        let count = |points| stations(&network, tiny.into(), points).all.len();
        assert!((1600 * 100..=3200 * 100).contains(&count(1_000_000)));
        assert!((8000..=2 * 16 * 500).contains(&count(500)), "{}", count(500));
    }

    #[test]
    fn a_strip_of_any_number_of_spacings_has_a_bounded_number_of_stations() {
        let strip = border();
        for step in [1e-310, 1e-100, 1e-3] {
            let count = places(&strip, step, 64).len();
            assert!((1600..=3200).contains(&count), "{step:e}: {count}");
        }
        assert_eq!(places(&strip, 1e6, 64).len(), 1600);
        let open = Strip { closed: false, ..strip };
        assert_eq!(places(&open, 1e6, 64).last(), open.points.last());
    }
}
