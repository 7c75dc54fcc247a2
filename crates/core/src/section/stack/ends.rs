//! Where a run begins and ends: at a flat face across the axis beside its outline, or else at the last points of its
//! wall. Both lie between two slices, and are found in the points there.

use super::super::result::Sections;
use super::super::surface::{self, Patch};
use super::super::tree::Tree;
use super::super::vec2::onto;
use super::profile::Profile;
use super::runs::Found;
use crate::cloud::Cloud;
use crate::error::Error;
use crate::frame::Frame;
use crate::neighbors::Index;

/// Cosine of the angle between a flat face's normal and the axis: 15 degrees.
const FLAT: f64 = 0.966;
/// Fewest points that show a flat face.
const FACE: usize = 8;
/// How far beside an outline its end face is looked for, in spacings.
const BESIDE: f64 = 4.0;

/// A point of the cloud in the slice frame, world units.
#[derive(Clone, Copy)]
struct Spot {
    at: [f64; 2],
    height: f64,
    flat: bool,
}

/// Sets `from`, `to` and `range_error` of every run from the points between its slices and those just outside.
pub(super) fn refine(cloud: &Cloud, sections: &Sections, runs: &mut [Found]) -> Result<(), Error> {
    if runs.is_empty() {
        return Ok(());
    }
    let spots = spots(cloud, sections)?;
    // A slice within a spacing of a face may not show the outline whole: the face then lies past that slice.
    let past = sections.spacing;
    for Found { run, profiles } in runs.iter_mut() {
        let [low, _, high] = *profiles;
        let (first, last) = (low.height, high.height);
        // Beyond the outermost slice the cloud may go on for any length: its end bounds the search.
        let below =
            if run.range_error[0].is_finite() { 2.0 * run.from - first - past } else { f64::NEG_INFINITY };
        let above = if run.range_error[1].is_finite() { 2.0 * run.to - last + past } else { f64::INFINITY };
        let down = end(&spots, low, sections, first, below);
        let up = end(&spots, high, sections, last, above);
        (run.from, run.range_error[0]) = down.unwrap_or((run.from, run.range_error[0]));
        (run.to, run.range_error[1]) = up.unwrap_or((run.to, run.range_error[1]));
    }
    Ok(())
}

/// All points, ascending by height.
fn spots(cloud: &Cloud, sections: &Sections) -> Result<Vec<Spot>, Error> {
    let local = Frame::localise(cloud)?;
    let index = Index::build(&local.positions);
    let all: Vec<u32> = (0..local.positions.len() as u32).collect();
    let surface = surface::fit(&local.positions, &index, &all, sections.noise);
    let axis = sections.frame.axes[2];
    let flat = |p: &Patch| {
        let along: f64 = (0..3).map(|k| p.normal[k] * axis[k]).sum();
        along.abs() >= FLAT && p.residual <= (2.0 * sections.noise + 0.15) * p.spacing
    };
    let spot = |i: u32| {
        let [x, y, height] = sections.frame.coordinates(local.frame.to_world(local.positions[i as usize]));
        Spot { at: [x, y], height, flat: surface.at(i).is_some_and(flat) }
    };
    let mut spots: Vec<Spot> = all.into_iter().map(spot).collect();
    spots.sort_by(|a, b| {
        let key = |s: &Spot| [s.height, s.at[0], s.at[1]];
        let (p, q) = (key(a), key(b));
        p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1])).then(p[2].total_cmp(&q[2]))
    });
    Ok(spots)
}

/// Where the wall of an outline ends between the slice at `inner` and the height `outer`, and how surely.
fn end(spots: &[Spot], outline: &Profile, sections: &Sections, inner: f64, outer: f64) -> Option<(f64, f64)> {
    let up = outer > inner;
    let (low, high) = if up { (inner, outer) } else { (outer, inner) };
    let from = spots.partition_point(|s| s.height < low);
    let to = spots.partition_point(|s| s.height <= high);
    let tree = Tree::new(&outline.points);
    let h = sections.spacing;
    let mut best = Vec::new();
    let mut beside: Vec<(f64, f64, bool)> = Vec::new();
    for s in &spots[from..to] {
        let off = distance(&tree, outline, s.at, &mut best);
        if off <= BESIDE * h {
            beside.push((s.height, off, s.flat));
        }
    }
    if up {
        face(beside.iter(), h, sections.noise).or_else(|| wall(beside.iter(), h, sections.noise))
    } else {
        face(beside.iter().rev(), h, sections.noise).or_else(|| wall(beside.iter().rev(), h, sections.noise))
    }
}

fn distance(tree: &Tree<2>, outline: &Profile, p: [f64; 2], best: &mut Vec<(f64, u32)>) -> f64 {
    tree.nearest(p, 1, best);
    let Some(&(_, k)) = best.first() else { return f64::INFINITY };
    let (n, k) = (outline.points.len(), k as usize);
    let at = |k: usize| outline.points[k % n];
    onto(at(k + n - 1), at(k), p).1.min(onto(at(k), at(k + 1), p).1)
}

/// The first flat face met going away from the slice: a cluster of heights without a gap of half a spacing.
fn face<'a>(beside: impl Iterator<Item = &'a (f64, f64, bool)>, h: f64, noise: f64) -> Option<(f64, f64)> {
    let gap = (0.25 + noise) * h;
    let mut cluster: Vec<f64> = Vec::new();
    for &(height, _, _) in beside.filter(|b| b.2) {
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

/// The last point of the wall, a little back for the noise.
fn wall<'a>(beside: impl Iterator<Item = &'a (f64, f64, bool)>, h: f64, noise: f64) -> Option<(f64, f64)> {
    let near: Vec<f64> = beside.filter(|b| b.1 <= (0.5 + 2.0 * noise) * h && !b.2).map(|b| b.0).collect();
    let (first, last) = (near.first()?, near.last()?);
    let back = 2.0 * noise * h * (last - first).signum();
    Some((last - back, (0.3 + noise) * h))
}
