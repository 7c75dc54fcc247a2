//! The local surface at the points of the slabs: a tangent plane each, its residual, the spacing there, the noise.
//!
//! A point beside a crease adopts the plane of a neighbour on its own face, so that a wall stays straight up to its
//! edge. Patches stay in the blocks they were made in: a cloud of many points is passed over once.

use rayon::prelude::*;

pub(crate) use super::plane::Patch;
use super::plane::{Around, FIRST, MOST};
use crate::math::vec3;
use crate::neighbors::{self, BLOCK, Found, Index};

/// Points the noise and the spacing of a cloud are read from.
const SAMPLE: usize = 8_000;

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
    /// `BLOCK` patches each, the last fewer.
    blocks: Vec<Vec<Patch>>,
    /// For each point the place of its patch in all blocks; `None`: each point has one, in order.
    slots: Option<Vec<u32>>,
}

impl Surface {
    /// The patch at a point that was asked for.
    pub(crate) fn at(&self, point: u32) -> Option<&Patch> {
        let (block, place) = self.place(point);
        self.blocks.get(block)?.get(place)
    }

    fn place(&self, point: u32) -> (usize, usize) {
        let slot = self.slots.as_ref().map_or(point, |slots| slots[point as usize]) as usize;
        (slot / BLOCK, slot % BLOCK)
    }
}

/// Reads noise and spacing from evenly spread points of a cloud in canonical order.
pub(crate) fn texture(points: &[[f64; 3]], index: &Index) -> Texture {
    let step = points.len().div_ceil(SAMPLE).max(1);
    let sampled: Vec<u32> = (0..points.len() as u32).step_by(step).collect();
    let patches: Vec<Patch> = sampled
        .par_iter()
        .map_init(Vec::new, |found, &i| {
            Around::gather(points, i, &nearest(points, index, i, FIRST, found)).plain()
        })
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

/// A search of all points beats searches of single ones from this share of the points on: one in six.
const MANY: usize = 6;

/// Fits the surface at the `wanted` points (ascending) of a cloud.
pub(crate) fn fit(points: &[[f64; 3]], index: &Index, wanted: &[u32], noise: f64) -> Surface {
    let count = ((12.0 + 50.0 * noise) as usize).clamp(FIRST, MOST);
    let all = wanted.len() * MANY > points.len();
    let blocks: Vec<Block> = if all {
        let width = (count - 1).min(points.len().saturating_sub(1)).max(1);
        let mut inside = vec![false; points.len()];
        wanted.iter().for_each(|&i| inside[i as usize] = true);
        neighbors::nearest_blocks_in(index, points, count - 1, |first, lists| {
            let mut block = Block { patches: Vec::with_capacity(BLOCK), ..Block::default() };
            for (i, ids) in (first as u32..).zip(lists.chunks(width)) {
                if inside[i as usize] {
                    block.push(points, i, ids, noise);
                } else {
                    block.patches.push(Patch::NONE);
                }
            }
            block
        })
    } else {
        let visit = |chunk: &[u32]| {
            let (mut block, mut found) = (Block::default(), Vec::new());
            for &i in chunk {
                block.push(points, i, &nearest(points, index, i, count, &mut found), noise);
            }
            block
        };
        wanted.par_chunks(BLOCK).map(visit).collect()
    };
    let slots = (!all).then(|| {
        let mut slots = vec![u32::MAX; points.len()];
        wanted.iter().enumerate().for_each(|(slot, &i)| slots[i as usize] = slot as u32);
        slots
    });
    adopt_all(points, blocks, slots, noise)
}

impl Block {
    fn push(&mut self, points: &[[f64; 3]], i: u32, ids: &[u32], noise: f64) {
        let mut around = Around::gather(points, i, ids);
        let first = around.plain();
        let patch = around.anchored(&first, noise);
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

/// Lets badly fitting points adopt, all from the planes as they were fitted.
fn adopt_all(points: &[[f64; 3]], blocks: Vec<Block>, slots: Option<Vec<u32>>, noise: f64) -> Surface {
    let mut own = Surface { blocks: Vec::with_capacity(blocks.len()), slots };
    let mut bad = Vec::with_capacity(blocks.len());
    for block in blocks {
        own.blocks.push(block.patches);
        bad.push((block.bad, block.near));
    }
    let better: Vec<Vec<(u32, Patch)>> = bad
        .par_iter()
        .map(|(bad, near)| {
            let mut start = 0;
            let visit = |&(i, count): &(u32, u32)| {
                let ids = &near[start..start + count as usize];
                start += count as usize;
                adopt(points, &own, i, ids, noise).map(|patch| (i, patch))
            };
            bad.iter().filter_map(visit).collect()
        })
        .collect();
    for &(i, patch) in better.iter().flatten() {
        let (block, place) = own.place(i);
        own.blocks[block][place] = patch;
    }
    own
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
