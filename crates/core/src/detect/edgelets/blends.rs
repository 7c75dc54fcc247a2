//! Blends: rounded edges between two faces, from wide cross-sections of the surface. Ours.
//!
//! At seeds on the bends of the field a section is taken wide enough for the round and the faces on both sides of it. `walk` follows
//! the surface in it, `ramp` finds where it bends evenly between two straight stretches, and `profile` fits two lines and the arc that
//! touches both. Where its radius is significant the design edge, in which the faces would meet, is an edgelet with that radius.

mod fit;
mod profile;
mod ramp;
mod walk;

use super::Weighted;
use super::distinct::distinct;
use super::field::Field;
use super::section::{Reach, Section};
use crate::math::vec3::add_scaled;
use crate::measure::Edgelet;
use crate::parallel;
use profile::{Compared, Profile};
use ramp::{Ramp, ramp};

/// Half the width of a section, in spacings, and the stations on either side of the seed: without noise, what noise adds to them in its
/// unit of spacings, and the greatest number.
const WIDE: f64 = 13.0;
const STATIONS: (f64, f64, f64) = (3.0, 24.0, 9.0);
/// Stations of a short section on either side of the seed: as many as are needed to follow the surface.
const SHORT: usize = 4;
/// Distance between seeds, in spacings.
const APART: f64 = 1.8;
/// Radii of blends, in spacings.
const RADIUS: std::ops::RangeInclusive<f64> = 0.7..=8.0;
/// Turns of blends, degrees: beyond them the faces meet too far off.
const TURN_DEG: std::ops::RangeInclusive<f64> = 25.0..=155.0;
/// Least length of both faces beside the round, in spacings.
const FACE: f64 = 1.5;
/// Greatest standard deviation of a radius, as a share of it.
const KNOWN: f64 = 0.3;
/// Evidence, twice the log likelihood ratio, that an edge is round rather than sharp. Whether it is cut by a chamfer is told by the whole edge.
const ROUND: f64 = 6.0;
/// Greatest mean square of the distances from the profile, in variances of the points.
const MEAN: f64 = 2.5;
/// Standard deviation of points without noise, spacings: up to which they may leave the profile, and the least that is believed.
const LEAST: f64 = 0.06;
const CLEAN: f64 = 0.015;

#[derive(Default)]
struct Scratch {
    section: Section,
    walk: walk::Walk,
}

/// The design edges of blends, local frame.
pub(super) fn blends(field: &Field) -> Vec<Edgelet> {
    let seeds = super::seeds(field, APART);
    let found = parallel::flat_map_with(seeds.len(), super::SEEDS, |scratch: &mut Scratch, i, out| {
        out.extend(blend(field, seeds[i], scratch));
    });
    distinct(&found, field.index, 1)
}

/// The blend at a seed: in a section as long as the noise asks for, or in a short one beside the end of the edge.
fn blend(field: &Field, seed: usize, scratch: &mut Scratch) -> Option<Weighted> {
    let resolution = field.scales.at(seed);
    let (fewest, noisy, most) = STATIONS;
    let stations = (fewest + noisy * resolution.noise / resolution.spacing).min(most) as usize;
    // Most seeds lie on sharp edges, which a short section shows at less cost.
    let ramp = bent(field, seed, SHORT.min(stations), scratch)?;
    let short = round(scratch, ramp);
    if stations <= SHORT {
        return short;
    }
    bent(field, seed, stations, scratch).and_then(|ramp| round(scratch, ramp)).or(short)
}

/// Where the surface bends in the section over so many stations on either side of a seed.
fn bent(field: &Field, seed: usize, stations: usize, scratch: &mut Scratch) -> Option<Ramp> {
    let Scratch { section, walk } = scratch;
    if !section.take_within(field, seed, Reach::of(WIDE, stations)) {
        return None;
    }
    walk.along(&section.points, section.noise);
    ramp(&walk.places)
}

/// The blend that bends the surface there.
fn round(Scratch { section, walk }: &Scratch, ramp: Ramp) -> Option<Weighted> {
    let points: Vec<[f64; 2]> = walk.points(&section.points, ramp.window).collect();
    let (noise, count) = (section.noise, points.len() as f64);
    let sigma = noise.hypot(LEAST);
    let found = Profile::of(&ramp, &walk.places)?.compared(ramp.radius, &points, sigma)?;
    let Compared { profile, radius, .. } = found;
    // Clean points tell an arc from a chamfer better than their least error says.
    let variance = (found.round.min(found.chamfer) / count).max(noise * noise).max(CLEAN * CLEAN);
    let [sharp, evidence] =
        [found.sharp, found.sharp.min(found.chamfer)].map(|s| (s - found.round) / variance);
    let [radius_sigma, corner_sigma] = [found.radius_sigma, found.corner_sigma].map(|s| s * variance.sqrt());
    let holds = RADIUS.contains(&radius)
        && TURN_DEG.contains(&profile.turn().to_degrees())
        && radius_sigma <= KNOWN * radius
        && sharp >= ROUND
        && found.round <= MEAN * sigma * sigma * count
        && profile.faces(radius, &points).iter().all(|&f| f >= FACE);
    let [along, ..] = section.axes;
    let edgelet = Edgelet {
        place: add_scaled(section.origin, section.in_space(profile.corner), section.unit),
        point: section.seed,
        along,
        arms: profile.arms.map(|a| section.in_space(a)),
        spacing: section.unit,
        deviation: corner_sigma * section.unit,
        evidence,
        reach: section.stations as f64 * section.unit,
        radius: radius * section.unit,
    };
    holds.then(|| Weighted { edgelet, weight: 1.0 / (corner_sigma.powi(2) + LEAST * LEAST) })
}

#[cfg(test)]
mod tests;
