//! The local surface at the points of the slabs: a tangent plane each, its residual, the spacing there, the noise.
//!
//! The points of a flat tile share its plane; the others have one each. A point beside a crease adopts the plane of a
//! neighbour on its own face, so that a wall stays straight up to its edge.

use super::plane::{Around, FIRST_NEIGHBORS, MOST_NEIGHBORS, TangentPlane};
use super::sample::with_neighbors;
use super::tile::{Tile, good};
use super::tiles::Tiles;
use crate::math::vec3;
use crate::neighbors::{Index, WIDTH, nearest_leaves};
use crate::parallel;

/// No planes.
const NO_PLANES: u32 = u32::MAX;

/// The planes of the points of some leaves.
pub(crate) struct TangentPlanes<'a> {
    tiles: &'a Tiles,
    /// For each leaf beside a crease, or that is not flat and was asked for, where its planes begin among those of the
    /// tiles and then those here; else `NO_PLANES`.
    starts: Vec<u32>,
    /// Place by place, [`WIDTH`] for each of the leaves that were asked for.
    planes: Vec<TangentPlane>,
}

impl TangentPlanes<'_> {
    /// The plane at a point, if its leaf is flat or was asked for.
    pub(crate) fn at(&self, point: u32) -> Option<&TangentPlane> {
        let (leaf, place) = self.tiles.place(point);
        let tile = &self.tiles.tiles[leaf];
        if tile.flat { Some(&tile.plane) } else { Some(&self.fine(leaf)?[place]) }
    }

    /// A leaf's own tile.
    pub(crate) fn tile(&self, leaf: u32) -> &Tile {
        &self.tiles.tiles[leaf as usize]
    }

    /// The planes of a leaf that is not flat, place by place.
    pub(crate) fn fine(&self, leaf: usize) -> Option<&[TangentPlane]> {
        let (start, shared) = (self.starts[leaf] as usize, &self.tiles.planes);
        match start.checked_sub(shared.len()) {
            None => shared.get(start..start + WIDTH),
            Some(own) => self.planes.get(own..)?.get(..WIDTH),
        }
    }
}

/// Fits the surface at the points of the `wanted` leaves, ascending, that are not flat.
pub(crate) fn tangent_planes<'a>(
    points: &[[f64; 3]],
    index: &Index,
    tiles: &'a Tiles,
    wanted: &[u32],
    noise: f64,
) -> TangentPlanes<'a> {
    let mut starts = vec![NO_PLANES; tiles.tiles.len()];
    tiles.mixed.iter().zip((0..).step_by(WIDTH)).for_each(|(&leaf, start)| starts[leaf as usize] = start);
    let unknown = |&l: &u32| !tiles.tiles[l as usize].flat && starts[l as usize] == NO_PLANES;
    let leaves: Vec<u32> = wanted.iter().copied().filter(unknown).collect();
    let first = tiles.planes.len() as u32;
    leaves.iter().zip((first..).step_by(WIDTH)).for_each(|(&leaf, start)| starts[leaf as usize] = start);
    let count = ((12.0 + 50.0 * noise) as usize).clamp(FIRST_NEIGHBORS, MOST_NEIGHBORS) - 1;
    let width = count.min(points.len().saturating_sub(1));
    let fits: Vec<Fits> = nearest_leaves(index, points, count, &leaves, |first, lists| {
        let mut fits = Fits::default();
        for leaf in with_neighbors(index, &leaves[first..], lists, width) {
            leaf.for_each(|(i, near)| fits.push(points, i, near, noise));
            fits.planes.resize(fits.planes.len().next_multiple_of(WIDTH), TangentPlane::NONE);
        }
        fits
    });
    adopt_all(points, TangentPlanes { tiles, starts, planes: Vec::new() }, fits, noise)
}

/// Patches of the points of some leaves, and the neighbours of those that fit badly: (point, how many), flat.
#[derive(Default)]
struct Fits {
    planes: Vec<TangentPlane>,
    bad: Vec<(u32, u32)>,
    near: Vec<u32>,
}

impl Fits {
    fn push(&mut self, points: &[[f64; 3]], i: u32, ids: &[u32], noise: f64) {
        let mut around = Around::gather(points, i, ids);
        let first = around.plain();
        let plane = around.anchored(&first, noise);
        if plane.residual > good(noise) * plane.spacing {
            self.bad.push((i, ids.len() as u32));
            self.near.extend_from_slice(ids);
        }
        self.planes.push(plane);
    }
}

/// Lets badly fitting points adopt, all from the planes as they were fitted.
fn adopt_all<'a>(
    points: &[[f64; 3]],
    mut own: TangentPlanes<'a>,
    fits: Vec<Fits>,
    noise: f64,
) -> TangentPlanes<'a> {
    own.planes.reserve_exact(fits.iter().map(|f| f.planes.len()).sum());
    fits.iter().for_each(|f| own.planes.extend_from_slice(&f.planes));
    let better = parallel::map(fits.len(), parallel::TASK, |f| {
        let mut start = 0;
        let visit = |&(i, count): &(u32, u32)| {
            let ids = &fits[f].near[start..start + count as usize];
            start += count as usize;
            adopt(points, &own, i, ids, noise).map(|plane| (i, plane))
        };
        fits[f].bad.iter().filter_map(visit).collect::<Vec<(u32, TangentPlane)>>()
    });
    for &(i, plane) in better.iter().flatten() {
        let (leaf, place) = own.tiles.place(i);
        own.planes[own.starts[leaf] as usize - own.tiles.planes.len() + place] = plane;
    }
    own
}

/// The neighbour's plane that holds the point and fits its own neighbours best, if it fits much better.
fn adopt(
    points: &[[f64; 3]],
    surface: &TangentPlanes,
    i: u32,
    ids: &[u32],
    noise: f64,
) -> Option<TangentPlane> {
    let own = surface.at(i)?;
    let point = points[i as usize];
    let tolerance = (2.5 * noise + 0.06) * own.spacing;
    let mut best = (0.6 * own.residual, None);
    for candidate in ids.iter().filter_map(|&j| surface.at(j)) {
        let off = vec3::dot(vec3::sub(point, candidate.centre), candidate.normal).abs();
        if off <= tolerance && candidate.residual < best.0 {
            best = (candidate.residual, Some(TangentPlane { spacing: own.spacing, ..*candidate }));
        }
    }
    best.1
}
