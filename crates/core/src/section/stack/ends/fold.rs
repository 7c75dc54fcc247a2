//! A fold into a slanted wall: the planes beside the outline meet the upright wall at one height.

use super::super::super::vec2::{dot, sub, unit};
use super::near::{Search, Spot, to_foot};
use super::{By, End};
use crate::math::vec3;

/// Least angle of a slanted wall to the axis, degrees: without noise, and what noise (in spacings) adds.
const SLANTED_DEG: (f64, f64) = (10.0, 40.0);
/// Fewest points that show a fold, and their share of those on slanted walls.
const FEWEST: usize = 8;
const SHARE: f64 = 0.35;
/// How far from an edge, in spacings, planes show one face: without noise, and what noise (in spacings) adds.
const CLEAR: (f64, f64) = (1.6, 2.0);
/// Cosine of the angle between axis and normal above which a plane is level: 4 degrees.
const LEVEL: f64 = 0.9976;
/// Cosine of the angle by which a slanted plane may fall aside.
const ACROSS: f64 = 0.7;
/// How far beside an outline planes tell where they meet it, in spacings.
const BESIDE: f64 = 4.0;

/// The height at which most slanted planes beside an outline meet it.
pub(super) fn fold(search: &Search, spots: &[Spot], h: f64, noise: f64) -> Option<End> {
    let least = (SLANTED_DEG.0 + SLANTED_DEG.1 * noise).to_radians().sin();
    let slanted = |s: &&Spot| {
        let lean = s.normal[2].abs();
        s.fits && (least..LEVEL).contains(&lean) && s.off <= BESIDE * h && faces_outline(s)
    };
    let meets = |s: &Spot| {
        let [dx, dy] = to_foot(s);
        let height = s.centre[2] - vec3::dot([dx, dy, 0.0], s.normal) / s.normal[2];
        // Planes right at an edge mix both of its faces.
        let clear = s.off.hypot(s.height - height) >= (CLEAR.0 + CLEAR.1 * noise) * h;
        clear.then(|| (search.ahead(height), search.ahead(s.height)))
    };
    let mut all: Vec<(f64, f64)> = spots.iter().filter(slanted).filter_map(meets).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let width = (0.4 + 2.5 * noise) * h;
    let window = |i: usize| i..all.partition_point(|a| a.0 <= all[i].0 + width);
    let fullest = (0..all.len()).map(window).max_by_key(|w| (w.len(), std::cmp::Reverse(w.start)))?;
    let found = &all[fullest];
    if found.len() < FEWEST || (found.len() as f64) < SHARE * all.len() as f64 {
        return None;
    }
    let at = |share: f64| found[((found.len() - 1) as f64 * share) as usize].0;
    let ahead = at(0.5);
    let beyond = found.iter().filter(|a| a.1 >= ahead - 0.5 * h).count();
    let error = 1.3 * (at(0.84) - at(0.16)) / (found.len() as f64).sqrt() + 1e-2 * h;
    let height = search.inner + ahead * (search.outer - search.inner).signum();
    let there = search.holds(height) && 4 * beyond >= 3 * found.len();
    there.then_some(End { height, error, by: By::Fold })
}

/// Whether a plane falls towards the outline or away from it, and not along it as the flanks of a bore that opens there.
fn faces_outline(s: &Spot) -> bool {
    let (normal, away) = (unit([s.normal[0], s.normal[1]]), unit(sub(s.at, s.foot)));
    dot(normal, away).abs() >= ACROSS
}
