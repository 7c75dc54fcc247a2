//! The local surface at the points of the slabs: a tangent plane each, its residual, the spacing there, the noise.
//!
//! Planes come from a robust fit anchored at the point (so that two sheets of a thin plate keep apart), and a point
//! beside a crease adopts the plane of a neighbour on its own face (so that a wall stays straight up to its edge).

use rayon::prelude::*;

use super::spread::{self, Spread};
use crate::math::vec3;
use crate::neighbors::{self, Found, Index};

/// Neighbours a plane is fitted to at first, itself included.
const FIRST: usize = 12;
/// Most neighbours of a plane under noise, itself included.
const MOST: usize = 24;
/// Points the noise and the spacing of a cloud are read from.
const SAMPLE: usize = 20_000;

/// A tangent plane with what its fit says.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Patch {
    /// Weighted mean of the neighbours.
    pub centre: [f64; 3],
    /// Unit normal of either sign; zero where the neighbours lie on a line and show no plane.
    pub normal: [f64; 3],
    /// Root mean square distance of the neighbours from the plane.
    pub residual: f64,
    /// Mean distance to the six nearest points.
    pub spacing: f64,
}

/// What a sample of the cloud says of all of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Texture {
    /// Standard deviation of the points from the surface, in local spacings.
    pub noise: f64,
    /// Median spacing.
    pub spacing: f64,
    /// Spacing that all but one point in two hundred stay under.
    pub widest: f64,
}

/// The patches of some points of a cloud.
pub(crate) struct Surface {
    patches: Vec<Patch>,
    slots: Vec<u32>,
}

impl Surface {
    /// The patch at a point that was asked for.
    pub(crate) fn at(&self, point: u32) -> Option<&Patch> {
        self.patches.get(self.slots[point as usize] as usize)
    }
}

/// Reads noise and spacing from evenly spread points of a cloud in canonical order.
pub(crate) fn texture(points: &[[f64; 3]], index: &Index) -> Texture {
    let step = points.len().div_ceil(SAMPLE).max(1);
    let sampled: Vec<u32> = (0..points.len() as u32).step_by(step).collect();
    let patches: Vec<Patch> = sampled
        .par_iter()
        .map_init(Vec::new, |found, &i| plain(points, i, &nearest(points, index, i, FIRST, found)))
        .collect();
    let mut spacings: Vec<f64> = patches.iter().map(|p| p.spacing).filter(|&s| s > 0.0).collect();
    let ratio = |p: &Patch| p.residual / p.spacing;
    // The residual that a quiet third of the points shows: creases and curvature sit in the upper part.
    let mut ratios: Vec<f64> = patches.iter().filter(|p| p.spacing > 0.0).map(ratio).collect();
    Texture {
        noise: quantile(&mut ratios, 0.3),
        spacing: quantile(&mut spacings, 0.5),
        widest: quantile(&mut spacings, 0.995),
    }
}

fn quantile(values: &mut [f64], share: f64) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let at = ((values.len() - 1) as f64 * share) as usize;
    *values.select_nth_unstable_by(at, f64::total_cmp).1
}

/// The nearest points of one, itself left out, nearest first.
fn nearest(points: &[[f64; 3]], index: &Index, i: u32, count: usize, found: &mut Vec<Found>) -> Vec<u32> {
    index.nearest(points[i as usize], count, found);
    found.iter().map(|f| f.index).filter(|&j| j != i).collect()
}

/// Patches of a run of points, and the neighbours of those that fit badly: (point, how many), flat.
#[derive(Default)]
struct Block {
    patches: Vec<Patch>,
    bad: Vec<(u32, u32)>,
    near: Vec<u32>,
}

/// Fits the surface at the `wanted` points (ascending) of a cloud.
pub(crate) fn fit(points: &[[f64; 3]], index: &Index, wanted: &[u32], noise: f64) -> Surface {
    let count = ((12.0 + 50.0 * noise) as usize).clamp(FIRST, MOST);
    let mut slots = vec![u32::MAX; points.len()];
    let blocks: Vec<Block> = if wanted.len() * 2 > points.len() {
        (0..points.len() as u32).for_each(|i| slots[i as usize] = i);
        let width = (count - 1).min(points.len().saturating_sub(1)).max(1);
        neighbors::nearest_blocks(points, count - 1, |first, lists| {
            let mut block = Block::default();
            for (i, ids) in (first as u32..).zip(lists.chunks(width)) {
                block.push(points, i, ids, noise);
            }
            block
        })
    } else {
        wanted.iter().enumerate().for_each(|(slot, &i)| slots[i as usize] = slot as u32);
        let visit = |chunk: &[u32]| {
            let (mut block, mut found) = (Block::default(), Vec::new());
            for &i in chunk {
                block.push(points, i, &nearest(points, index, i, count, &mut found), noise);
            }
            block
        };
        wanted.par_chunks(256).map(visit).collect()
    };
    adopt_all(points, blocks, slots, noise)
}

impl Block {
    fn push(&mut self, points: &[[f64; 3]], i: u32, ids: &[u32], noise: f64) {
        let first = plain(points, i, ids);
        let patch = anchored(points, i, ids, &first, noise);
        if patch.residual > good(noise) * patch.spacing {
            self.bad.push((i, ids.len() as u32));
            self.near.extend_from_slice(ids);
        }
        self.patches.push(patch);
    }
}

/// Residual in spacings that noise explains.
fn good(noise: f64) -> f64 {
    1.4 * noise + 0.03
}

fn plain(points: &[[f64; 3]], i: u32, ids: &[u32]) -> Patch {
    let own = points[i as usize];
    let used = &ids[..(FIRST - 1).min(ids.len())];
    let spread = Spread::of(std::iter::once(&i).chain(used).map(|&j| (points[j as usize], 1.0)), own);
    let six = &ids[..6.min(ids.len())];
    let sum: f64 = six.iter().map(|&j| vec3::distance(points[j as usize], own)).sum();
    patch(&spread, sum / six.len().max(1) as f64)
}

fn patch(spread: &Spread, spacing: f64) -> Patch {
    let (least, normal) = spread::normal(&spread.tensor);
    // Three parameters of a plane are taken from the points.
    let freedom = (spread.weight - 3.0).max(1.0) / spread.weight.max(1.0);
    Patch { centre: spread.centre, normal, residual: (least.max(0.0) / freedom).sqrt(), spacing }
}

/// Two rounds of a fit in which a neighbour counts the less, the farther it is from the plane through the point.
fn anchored(points: &[[f64; 3]], i: u32, ids: &[u32], first: &Patch, noise: f64) -> Patch {
    let own = points[i as usize];
    let reach = (3.0 * noise + 0.3) * first.spacing;
    if reach <= 0.0 {
        return *first;
    }
    let mut best = *first;
    for round in 0..2 {
        let all_used = round > 0 || ids.len() < FIRST;
        if all_used && best.residual <= (0.8 * noise + 0.02) * first.spacing {
            // No neighbour lies off the plane: weights change nothing but the time it takes.
            break;
        }
        let weighted = std::iter::once(&i).chain(ids).map(|&j| {
            let p = points[j as usize];
            let off = vec3::dot(vec3::sub(p, own), best.normal) / reach;
            (p, (-off * off).exp())
        });
        let spread = Spread::of(weighted, own);
        if spread.weight < 5.0 {
            return best;
        }
        best = patch(&spread, first.spacing);
    }
    best
}

fn adopt_all(points: &[[f64; 3]], blocks: Vec<Block>, slots: Vec<u32>, noise: f64) -> Surface {
    let patches: Vec<Patch> = blocks.iter().flat_map(|b| b.patches.iter().copied()).collect();
    let own = Surface { patches, slots };
    let better: Vec<Vec<(u32, Patch)>> = blocks
        .par_iter()
        .map(|block| {
            let mut start = 0;
            let visit = |&(i, count): &(u32, u32)| {
                let ids = &block.near[start..start + count as usize];
                start += count as usize;
                adopt(points, &own, i, ids, noise).map(|patch| (i, patch))
            };
            block.bad.iter().filter_map(visit).collect()
        })
        .collect();
    let Surface { mut patches, slots } = own;
    for (i, patch) in better.concat() {
        patches[slots[i as usize] as usize] = patch;
    }
    Surface { patches, slots }
}

/// The neighbour's plane that holds the point and fits its own neighbours best, if it fits much better.
fn adopt(points: &[[f64; 3]], surface: &Surface, i: u32, ids: &[u32], noise: f64) -> Option<Patch> {
    let own = surface.at(i)?;
    let point = points[i as usize];
    let tolerance = (2.5 * noise + 0.06) * own.spacing;
    let mut best = (0.6 * own.residual, None);
    for candidate in ids.iter().filter_map(|&j| surface.at(j)) {
        let off = vec3::dot(vec3::sub(point, candidate.centre), candidate.normal).abs();
        if off <= tolerance && candidate.residual < best.0 {
            best = (candidate.residual, Some(Patch { spacing: own.spacing, ..*candidate }));
        }
    }
    best.1
}
