//! Crease recovery (Gumhold 2001, section 4.1): the points beside a crease are told apart into those of its two faces, and the crease
//! is laid where the faces meet.
//!
//! `stations` (crease points on the spline) -> `vote` over `split` (the wedge fitting in each cross-section, crease strips as a
//! whole) -> `plane` (two planes a crease point, as printed), or, in the form of our own, `beside` -> `grow` (the points of each face as
//! far as no strip crosses) -> `surface` under `choose` -> `edge`.

mod beside;
mod choose;
mod edge;
mod grow;
mod plane;
mod split;
mod stations;
mod surface;
mod vote;

use crate::detect::evidence::hops::hops;
use crate::neighbors::riemannian;
use crate::network::Strip;
use crate::params::WedgeParams;
use crate::patch::Ground;
pub(super) use beside::{Beside, beside};
use grow::Rule;
pub(super) use plane::{Plane, Recovered};
use plane::{fold, project};
pub(super) use split::split;
pub(super) use stations::{Station, stations};
pub(super) use surface::{Axes, Fit};
pub(super) use vote::{FEWEST, Side, cross_section};
use vote::{sides, votes};

/// Least sine of the angle between two planes that meet in a line.
const LEAST_SINE: f64 = 0.15;
/// How far a crease point may move, units of the place.
pub(super) const FAR: f64 = 2.0;
/// Least standard deviation of a point, spacings: no surface is quite a plane.
const FLOOR: f64 = 0.01;
/// Points nearer to the edge than this are left out, spacings; and than this multiple of the noise.
const CLEAR: (f64, f64) = (0.5, 1.5);

/// Points nearer to the edge than this tell whether it is filled, units of the place.
const BESIDE: f64 = 1.25;
/// Greatest standard deviation of a crease point, or of a face at a node, units of the place: with more, as on narrow faces, the spline
/// knows better.
pub(super) const SPREAD: f64 = 0.2;

/// Memory of the searches on a thread.
#[derive(Default)]
pub(super) struct Scratch {
    hops: riemannian::Scratch,
    grow: grow::Scratch,
    /// The neighbourhood found last.
    pub near: Vec<u32>,
}

impl Scratch {
    /// Fills `near` with the neighbourhood of a point of the cloud, itself included.
    pub(super) fn around(&mut self, source: u32, ground: &Ground, params: &WedgeParams) {
        let depth = params.hops.or(|| hops(params.hops, ground.scales.at(source as usize)) + 1);
        self.near.clear();
        self.near.push(source);
        self.near.extend_from_slice(ground.graph.hops(source as usize, depth, &mut self.hops));
    }
}

/// The groups of the points beside a strip, by the votes of its crease points. The ascending `strange` points are not considered.
pub(super) fn group(
    strip: &Strip,
    stations: &[Station],
    strange: &[u32],
    ground: &Ground,
    params: &WedgeParams,
    scratch: &mut Scratch,
) -> Vec<Side> {
    let unit = ground.scales.finest(&strip.sources).unit();
    sides(votes(stations, ground.points, unit, |station, list| {
        scratch.around(station.source, ground, params);
        list.extend(scratch.near.iter().filter(|i| strange.binary_search(i).is_err()));
    }))
}

/// The crease point as printed: two planes through the two groups of its neighbours.
pub(super) fn printed(station: &Station, near: &[u32], sides: &[Side], ground: &Ground) -> Option<Recovered> {
    let floor = floor(station.source, ground);
    let side = |i: u32| sides.binary_search_by_key(&i, |s| s.point).ok().map(|k| sides[k].side);
    let group =
        |k: usize| near.iter().filter(move |&&i| side(i) == Some(k)).map(|&i| ground.points[i as usize]);
    let planes = [Plane::fit(group(0), floor)?, Plane::fit(group(1), floor)?];
    let p = station.at;
    let normals = [planes[0].normal, planes[1].normal];
    let offsets = [planes[0].offset(p), planes[1].offset(p)];
    let variances = [planes[0].variance_at(p), planes[1].variance_at(p)];
    let (at, covariance) = project(p, normals, offsets, variances, LEAST_SINE)?;
    let away = [0, 1].map(|k: usize| Axes::new(at, station.direction, normals[k], planes[k].centre));
    Some(Recovered { at, covariance, fold: fold([away[0]?.away, away[1]?.away]), filled: 0.0 })
}

/// The crease point in our form: the edge of two surfaces. `scratch.near` is its neighbourhood.
pub(super) fn quadric(
    station: &Station,
    strip: usize,
    ground: &Ground,
    beside: &[Beside],
    scratch: &mut Scratch,
) -> Option<Recovered> {
    let mut face = |side: usize| face(station, strip, side, ground, beside, scratch);
    let (a, b) = (face(0)?, face(1)?);
    let unit = ground.scales.unit(station.source);
    let (axes, fits) = ([a.0, b.0], [a.1, b.1]);
    let found = edge::meet(&axes, &fits, LEAST_SINE, FAR * unit)?;
    let points = scratch.near.iter().map(|&i| ground.points[i as usize]);
    let filled = edge::filled(found.at, &axes, &fits, points, BESIDE * unit);
    let spread = [0, 1, 2].map(|k: usize| found.covariance[k][k]).iter().sum::<f64>().sqrt();
    (spread <= SPREAD * unit).then_some(Recovered { filled, ..found })
}

/// One face of a strip at a crease point, or at a node in its place: its axes and its surface in them. `scratch.near` is the
/// neighbourhood from which it is followed.
pub(super) fn face(
    station: &Station,
    strip: usize,
    side: usize,
    ground: &Ground,
    beside: &[Beside],
    scratch: &mut Scratch,
) -> Option<(Axes, Fit)> {
    let resolution = ground.scales.at(station.source as usize);
    let clear = (CLEAR.0 * resolution.spacing).max(CLEAR.1 * resolution.noise);
    let (unit, floor) = (resolution.unit(), floor(station.source, ground));
    let rule = Rule { ground, beside, strip: strip as u32, clear, unit, floor };
    let Scratch { grow, near, .. } = scratch;
    let found = rule.face(station, side, near, choose::WIDEST * unit, grow)?;
    let fit = choose::choose(&found.axes, &found.points, clear, resolution, floor)?;
    Some((found.axes, fit))
}

/// The least standard deviation of a point at a place.
pub(super) fn floor(source: u32, ground: &Ground) -> f64 {
    FLOOR * ground.scales.at(source as usize).spacing
}
