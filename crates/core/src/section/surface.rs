//! The local surface at the points of the slabs: a tangent plane each, its residual, the spacing there, the noise.
//!
//! The points of a flat tile share its plane; the others have one each. A point beside a crease adopts the plane of a
//! neighbour on its own face, so that a wall stays straight up to its edge.

use rayon::prelude::*;

pub(crate) use super::plane::Patch;
use super::plane::{Around, FIRST, MOST};
use super::tile::{Tile, Tiles, good};
use crate::math::vec3;
use crate::neighbors::{Index, WIDTH, nearest_leaves};

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

/// The patches of the points of some leaves.
pub(crate) struct Surface<'a> {
    tiles: &'a Tiles,
    /// For each leaf beside a crease, or that is not flat and was asked for, where its patches begin among those of the
    /// tiles and then those here; else `NONE`.
    starts: Vec<u32>,
    /// Place by place, [`WIDTH`] for each of the leaves that were asked for.
    patches: Vec<Patch>,
}

/// No patches.
const NONE: u32 = u32::MAX;

impl Surface<'_> {
    /// The patch at a point, if its leaf is flat or was asked for.
    pub(crate) fn at(&self, point: u32) -> Option<&Patch> {
        let (leaf, place) = self.tiles.place(point);
        let tile = &self.tiles.tiles[leaf];
        if tile.flat { Some(&tile.patch) } else { Some(&self.fine(leaf)?[place]) }
    }

    /// A leaf's own tile.
    pub(crate) fn tile(&self, leaf: u32) -> &Tile {
        &self.tiles.tiles[leaf as usize]
    }

    /// The patches of a leaf that is not flat, place by place.
    pub(crate) fn fine(&self, leaf: usize) -> Option<&[Patch]> {
        let (start, shared) = (self.starts[leaf] as usize, &self.tiles.patches);
        match start.checked_sub(shared.len()) {
            None => shared.get(start..start + WIDTH),
            Some(own) => self.patches.get(own..)?.get(..WIDTH),
        }
    }
}

/// Reads noise and spacing from evenly spread leaves.
pub(crate) fn texture(points: &[[f64; 3]], index: &Index) -> Texture {
    let step = index.leaves.len().div_ceil(SAMPLE / WIDTH).max(1);
    let leaves: Vec<u32> = (0..index.leaves.len() as u32).step_by(step).collect();
    let width = (FIRST - 1).min(points.len().saturating_sub(1));
    let patches = nearest_leaves(index, points, FIRST - 1, &leaves, |first, lists| {
        let lists = lists.chunks(WIDTH * width).zip(&leaves[first..]);
        let patches = lists.flat_map(|(lists, &leaf)| {
            let ids = index.leaves[leaf as usize].ids().zip(lists.chunks(width));
            ids.map(|(i, near)| Around::gather(points, i, near).plain())
        });
        patches.collect::<Vec<Patch>>()
    })
    .concat();
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

/// A quantile; 0 for none.
pub(super) fn quantile(values: &mut [f64], share: f64) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let at = ((values.len() - 1) as f64 * share) as usize;
    *values.select_nth_unstable_by(at, f64::total_cmp).1
}

/// Fits the surface at the points of the `wanted` leaves, ascending, that are not flat.
pub(crate) fn fit<'a>(
    points: &[[f64; 3]],
    index: &Index,
    tiles: &'a Tiles,
    wanted: &[u32],
    noise: f64,
) -> Surface<'a> {
    let mut starts = vec![NONE; tiles.tiles.len()];
    tiles.mixed.iter().zip((0..).step_by(WIDTH)).for_each(|(&leaf, start)| starts[leaf as usize] = start);
    let unknown = |&l: &u32| !tiles.tiles[l as usize].flat && starts[l as usize] == NONE;
    let leaves: Vec<u32> = wanted.iter().copied().filter(unknown).collect();
    let first = tiles.patches.len() as u32;
    leaves.iter().zip((first..).step_by(WIDTH)).for_each(|(&leaf, start)| starts[leaf as usize] = start);
    let count = ((12.0 + 50.0 * noise) as usize).clamp(FIRST, MOST) - 1;
    let width = count.min(points.len().saturating_sub(1));
    let fits: Vec<Fits> = nearest_leaves(index, points, count, &leaves, |first, lists| {
        let mut fits = Fits::default();
        for (lists, &leaf) in lists.chunks(WIDTH * width).zip(&leaves[first..]) {
            for (i, ids) in index.leaves[leaf as usize].ids().zip(lists.chunks(width)) {
                fits.push(points, i, ids, noise);
            }
            fits.patches.resize(fits.patches.len().next_multiple_of(WIDTH), Patch::NONE);
        }
        fits
    });
    adopt_all(points, Surface { tiles, starts, patches: Vec::new() }, fits, noise)
}

/// Patches of the points of some leaves, and the neighbours of those that fit badly: (point, how many), flat.
#[derive(Default)]
struct Fits {
    patches: Vec<Patch>,
    bad: Vec<(u32, u32)>,
    near: Vec<u32>,
}

impl Fits {
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

/// Lets badly fitting points adopt, all from the planes as they were fitted.
fn adopt_all<'a>(points: &[[f64; 3]], mut own: Surface<'a>, fits: Vec<Fits>, noise: f64) -> Surface<'a> {
    own.patches.reserve_exact(fits.iter().map(|f| f.patches.len()).sum());
    fits.iter().for_each(|f| own.patches.extend_from_slice(&f.patches));
    let better = |fits: &Fits| {
        let mut start = 0;
        let visit = |&(i, count): &(u32, u32)| {
            let ids = &fits.near[start..start + count as usize];
            start += count as usize;
            adopt(points, &own, i, ids, noise).map(|patch| (i, patch))
        };
        fits.bad.iter().filter_map(visit).collect::<Vec<(u32, Patch)>>()
    };
    let better: Vec<Vec<(u32, Patch)>> = fits.par_iter().map(better).collect();
    for &(i, patch) in better.iter().flatten() {
        let (leaf, place) = own.tiles.place(i);
        own.patches[own.starts[leaf] as usize - own.tiles.patches.len() + place] = patch;
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
