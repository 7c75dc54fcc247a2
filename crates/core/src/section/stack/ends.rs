//! Where a run begins and ends: at a flat face across the axis beside its outline, or where its wall folds into a slanted
//! one, or else at the last points of its wall. Faces and last points lie between two slices, and are found in the points there.

use rayon::prelude::*;

use super::super::result::Sections;
use super::super::surface::{self, Surface};
use super::super::tile::Tiles;
use super::profile::Profile;
use super::runs::Found;
use crate::frame::Localised;
use crate::math::vec3;
use crate::neighbors::Index;

/// Cosine of the angle between a flat face's normal and the axis: 15 degrees.
const FLAT: f64 = 0.966;
/// Fewest points that show a flat face.
const FACE: usize = 8;
/// How far beside an outline its end face is looked for, in spacings.
const BESIDE: f64 = 4.0;

/// Points beside an outline that say well enough where it ends.
const ENOUGH: usize = 8_000;

/// A point of the cloud in the slice frame, world units.
#[derive(Clone, Copy)]
struct Spot {
    at: [f64; 2],
    height: f64,
    /// In the local cloud.
    index: u32,
}

/// A point beside an outline: its height, its distance from the outline, whether it lies on a face across the axis.
type Beside = (f64, f64, bool);

/// An end of a run that is looked for beside an outline between two heights, the first at the run's own slice.
struct Search<'a> {
    outline: &'a Profile,
    inner: f64,
    outer: f64,
    fold: Option<f64>,
}

/// Sets `from`, `to` and `range_error` of every run from the points between its slices and those just outside.
pub(super) fn refine(local: &Localised, index: &Index, sections: &Sections, runs: &mut [Found]) {
    let searches: Vec<[Search; 2]> = runs.iter().map(|r| searches(r, sections)).collect();
    let flat: Vec<&Search> = searches.iter().flatten().collect();
    let spots = spots(local, sections, &flat);
    let near: Vec<Vec<(Spot, f64)>> = flat.par_iter().map(|s| beside(&spots, s, sections.spacing)).collect();
    let tiles = Tiles::new(index, sections.noise, sections.frame.axes[2]);
    let faces = Faces::new(local, index, &tiles, sections, &near);
    let ends: Vec<Option<(f64, f64)>> = flat
        .par_iter()
        .zip(&near)
        .map(|(search, near)| {
            let mut beside: Vec<Beside> =
                near.iter().map(|(s, off)| (s.height, *off, faces.hold(s.index))).collect();
            if search.outer < search.inner {
                beside.reverse();
            }
            let (h, noise) = (sections.spacing, sections.noise);
            let fold = search.fold.map(|height| (height, (0.1 + 0.5 * noise) * h));
            face(&beside, h, noise).or(fold).or_else(|| wall(&beside, search.outer, h, noise))
        })
        .collect();
    for (found, ends) in runs.iter_mut().zip(ends.chunks(2)) {
        let run = &mut found.run;
        (run.from, run.range_error[0]) = ends[0].unwrap_or((run.from, run.range_error[0]));
        (run.to, run.range_error[1]) = ends[1].unwrap_or((run.to, run.range_error[1]));
    }
}

fn searches<'a>(Found { run, profiles, folds }: &Found<'a>, sections: &Sections) -> [Search<'a>; 2] {
    // A slice within a spacing of a face may not show the outline whole: the face then lies past that slice, and noise
    // spreads its points.
    let past = (1.0 + 4.0 * sections.noise) * sections.spacing;
    let [low, _, high] = *profiles;
    let (first, last) = (low.height, high.height);
    // Beyond the outermost slice the cloud may go on for any length: its end bounds the search.
    let below =
        if run.range_error[0].is_finite() { 2.0 * run.from - first - past } else { f64::NEG_INFINITY };
    let above = if run.range_error[1].is_finite() { 2.0 * run.to - last + past } else { f64::INFINITY };
    [
        Search { outline: low, inner: first, outer: below, fold: folds[0] },
        Search { outline: high, inner: last, outer: above, fold: folds[1] },
    ]
}

impl Search<'_> {
    fn range(&self) -> (f64, f64) {
        (self.inner.min(self.outer), self.inner.max(self.outer))
    }
}

/// The points at heights that are searched, ascending.
fn spots(local: &Localised, sections: &Sections, searches: &[&Search]) -> Vec<Spot> {
    let mut ranges: Vec<(f64, f64)> = searches.iter().map(|s| s.range()).collect();
    ranges.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    ranges.dedup_by(|next, kept| {
        let joins = next.0 <= kept.1;
        kept.1 = if joins { kept.1.max(next.1) } else { kept.1 };
        joins
    });
    let spot = |(index, p): (usize, &[f64; 3])| {
        let [x, y, height] = sections.frame.coordinates(local.frame.to_world(*p));
        let k = ranges.partition_point(|r| r.1 < height);
        let searched = ranges.get(k).is_some_and(|r| r.0 <= height);
        searched.then_some(Spot { at: [x, y], height, index: index as u32 })
    };
    let mut spots: Vec<Spot> = local.positions.par_iter().enumerate().filter_map(spot).collect();
    spots.par_sort_unstable_by(|a, b| a.height.total_cmp(&b.height).then(a.index.cmp(&b.index)));
    spots
}

/// The points of a search that lie beside its outline, ascending by height, with their distances.
fn beside(spots: &[Spot], search: &Search, h: f64) -> Vec<(Spot, f64)> {
    let (low, high) = search.range();
    let from = spots.partition_point(|s| s.height < low);
    let to = spots.partition_point(|s| s.height <= high);
    // A vertex may lie a spacing farther off than the outline.
    let near = |s: &Spot| {
        let off = search.outline.outline.off_within(s.at, (BESIDE + 1.0) * h)?;
        (off <= BESIDE * h).then_some((*s, off))
    };
    let found: Vec<(Spot, f64)> = spots[from..to].iter().filter_map(near).collect();
    let step = found.len().div_ceil(ENOUGH).max(1);
    found.into_iter().step_by(step).collect()
}

/// Which points lie on faces across the axis.
struct Faces<'a> {
    local: &'a Localised,
    sections: &'a Sections,
    surface: Surface<'a>,
}

impl<'a> Faces<'a> {
    fn new(
        local: &'a Localised,
        index: &Index,
        tiles: &'a Tiles,
        sections: &'a Sections,
        near: &[Vec<(Spot, f64)>],
    ) -> Self {
        let mut wanted: Vec<u32> =
            near.iter().flatten().map(|(s, _)| tiles.place(s.index).0 as u32).collect();
        wanted.sort_unstable();
        wanted.dedup();
        let surface = surface::fit(&local.positions, index, tiles, &wanted, sections.noise);
        Self { local, sections, surface }
    }

    fn hold(&self, point: u32) -> bool {
        let axis = self.sections.frame.axes[2];
        let at = self.local.positions[point as usize];
        self.surface.at(point).is_some_and(|p| {
            let (noise, off) = (self.sections.noise, vec3::dot(vec3::sub(at, p.centre), p.normal).abs());
            let fits = p.residual <= (2.0 * noise + 0.15) * p.spacing;
            // A tile of the face may hold a few points of the wall.
            fits && off <= (1.5 * noise + 0.05) * p.spacing && vec3::dot(p.normal, axis).abs() >= FLAT
        })
    }
}

/// The first flat face met going away from the slice: a cluster of heights without a gap of half a spacing.
fn face(beside: &[Beside], h: f64, noise: f64) -> Option<(f64, f64)> {
    let gap = (0.25 + noise) * h;
    let mut cluster: Vec<f64> = Vec::new();
    for &(height, _, _) in beside.iter().filter(|b| b.2) {
        if cluster.last().is_some_and(|&last| (height - last).abs() > gap) {
            if let Some(found) = settled(&cluster, h, noise) {
                return Some(found);
            }
            cluster.clear();
        }
        cluster.push(height);
    }
    settled(&cluster, h, noise)
}

/// The median height of a cluster that is as thin as the noise allows.
fn settled(cluster: &[f64], h: f64, noise: f64) -> Option<(f64, f64)> {
    if cluster.len() < FACE {
        return None;
    }
    let mut sorted = cluster.to_vec();
    sorted.sort_by(f64::total_cmp);
    let at = |share: f64| sorted[((sorted.len() - 1) as f64 * share) as usize];
    let spread = at(0.84) - at(0.16);
    let thin = spread <= (0.3 + 3.0 * noise) * h;
    thin.then(|| (at(0.5), 1.3 * spread / (cluster.len() as f64).sqrt() + 1e-3 * h))
}

/// The last point of the wall, a little back for the noise; `None` where the wall goes on to the end of the search, as
/// when only a part of it ends.
fn wall(beside: &[Beside], outer: f64, h: f64, noise: f64) -> Option<(f64, f64)> {
    let mut near = beside.iter().filter(|b| b.1 <= (0.5 + 2.0 * noise) * h && !b.2).map(|b| b.0);
    let first = near.next()?;
    let last = near.next_back().unwrap_or(first);
    if (outer - last).abs() <= h {
        return None;
    }
    let back = 2.0 * noise * h * (last - first).signum();
    Some((last - back, (0.3 + noise) * h))
}
