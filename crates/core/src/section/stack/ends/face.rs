//! A face across the axis: flat, or the crest of a curved one, as of a bore that lies along the slices or a dome. A curved
//! face has its height where it is level, which a parabola through its points tells. Several bores side by side have a
//! crest each.

use super::crest::{Shown, crest, ring};
use super::end::{By, End};
use super::ground::Spot;
use super::parts::parts;
use super::search::Search;
use crate::math::quantile::middle;

/// Fewest points that show a face.
const FACE_POINTS: usize = 8;
/// Share of the squared spread that a parabola may leave to be preferred to a level.
const PARABOLA_SHARE: f64 = 0.8;
/// Least that it must explain, in shares of one point of the squared spread.
const PARABOLA_GAIN: f64 = 12.0;
/// A cluster shows a face if the largest one has no more than this many times its points.
const CHANCE: usize = 8;
/// Fewest points of one face among several, which is fitted by itself, in multiples of the fewest.
const PART: usize = 3;
/// Greatest distance between points of one face, spacings.
const FACE_GAP: f64 = 3.0;
/// Greatest deviation of a round face from its parabola, and of a flat one from its level, spacings.
const MISFIT: (f64, f64) = (0.02, 1e-3);

/// A height that points show.
#[derive(Clone, Copy)]
struct Level {
    height: f64,
    /// Width of the middle two thirds about it.
    spread: f64,
    count: usize,
    /// Whether it was found by a parabola, from which a round face deviates a little.
    bent: bool,
}

/// The first face met going away from the slice: a cluster of heights without a gap.
pub(super) fn face(search: &Search, spots: &[Spot], h: f64, noise: f64) -> Option<End> {
    let gap = (0.25 + noise) * h;
    let settled = |cluster: &[Spot]| settled(search, cluster, spots, h, noise);
    let mut clusters: Vec<Vec<Spot>> = Vec::new();
    for spot in spots.iter().filter(|s| s.flat()) {
        match clusters.last_mut() {
            Some(cluster) if cluster.last().is_some_and(|l| (spot.height - l.height).abs() <= gap) => {
                cluster.push(*spot);
            }
            _ => clusters.push(vec![*spot]),
        }
    }
    // Under noise a few planes beside an edge seem level by chance.
    let largest = clusters.iter().map(Vec::len).max()?;
    let shows = |cluster: &&Vec<Spot>| CHANCE * cluster.len() >= largest;
    let found = clusters.iter().filter(shows).find_map(|cluster| settled(cluster));
    found.filter(|e| search.holds(e.height))
}

/// The height of a cluster that is as thin as the noise allows, as a level or as a parabola, or the first of several.
fn settled(search: &Search, cluster: &[Spot], spots: &[Spot], h: f64, noise: f64) -> Option<End> {
    let whole = level(search, cluster, spots, h, noise)?;
    let mut levels: Vec<Level> = parts(cluster, |s| s.at, FACE_GAP * h)
        .iter()
        .filter(|part| part.len() >= PART * FACE_POINTS)
        .filter_map(|part| level(search, part, spots, h, noise))
        .collect();
    let several = levels.len() > 1 && {
        let sum: f64 = levels.iter().map(|l| l.spread * l.spread * l.count as f64).sum();
        let count: usize = levels.iter().map(|l| l.count).sum();
        2 * count > cluster.len() && sum / count as f64 <= whole.spread * whole.spread * PARABOLA_SHARE
    };
    let first = if several {
        levels.sort_by(|a, b| search.ahead(a.height).total_cmp(&search.ahead(b.height)));
        levels[0]
    } else {
        whole
    };
    let thin = first.height.is_finite() && first.spread <= (0.3 + 3.0 * noise) * h;
    let misfit = if first.bent { MISFIT.0 } else { MISFIT.1 };
    let error = 1.3 * first.spread / (first.count as f64).sqrt() + misfit * h;
    thin.then_some(End { height: first.height, error, by: By::Face })
}

/// The level of a cluster, or the level place of the parabola that fits it far better.
fn level(search: &Search, cluster: &[Spot], spots: &[Spot], h: f64, noise: f64) -> Option<Level> {
    if cluster.len() < FACE_POINTS {
        return None;
    }
    let (height, spread) = middle(&cluster.iter().map(|s| s.height).collect::<Vec<_>>());
    let flat = Level { height, spread, count: cluster.len(), bent: false };
    if spread <= MISFIT.0 * h {
        return Some(flat);
    }
    let centre = search.outline.round.map(|r| r.centre).filter(|_| !search.upright);
    let about = centre.and_then(|c| ring(cluster, c));
    let about = about.map(|(height, own)| Shown { height, spread: own, level: spread, count: cluster.len() });
    let share = (1.0 - PARABOLA_GAIN / cluster.len() as f64).min(PARABOLA_SHARE);
    [about, crest(cluster, spots, h, noise)]
        .into_iter()
        .flatten()
        .filter(|m| m.spread * m.spread <= m.level * m.level * share)
        .min_by(|a, b| a.spread.total_cmp(&b.spread))
        .map(|m| Level { height: m.height, spread: m.spread, count: m.count, bent: true })
        .or(Some(flat))
}
