//! The leaves of the index as tiles of the surface: one plane for its sixteen points where they lie on it as well as noise
//! explains. On a large cloud that is nearly all of them, and costs a hundredth of a plane for each point. Beside a crease
//! the points of a tile may lie on the planes of several flat ones next to it, each on its own.

use rayon::prelude::*;

use super::plane::Patch;
use super::spread::{self, Spread};
use crate::math::vec3;
use crate::neighbors::{BLOCK, Index, Leaf, WIDTH};

/// Fewest points of a tile that may stand for all of them.
const FEWEST: f64 = 12.0;
/// Least variance along the shorter side of a tile that shows a plane by itself, in squared spacings: two rows of points do not show how the
/// surface lies across them.
const NARROW: f64 = 0.4;
/// Noise in spacings above which sixteen points do not show a plane well enough.
pub(super) const NOISY: f64 = 0.15;

/// A leaf of the index.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tile {
    /// The plane of its points, local frame.
    pub patch: Patch,
    /// Whether that plane holds for each of them.
    pub flat: bool,
    /// Whether the [`QUAD`] tiles it is one of share one plane, which is then the patch of each.
    pub joined: bool,
    /// Whether its points do not show how it lies across.
    narrow: bool,
    /// Least and greatest height of its points across the slices, local frame.
    pub heights: (f64, f64),
}

/// A leaf whose points lie on planes next to it, place by place.
struct Mixed {
    leaf: u32,
    patches: [Patch; WIDTH],
}

/// The places of the points of a block, its tiles and its leaves.
type Block<'a> = ((&'a mut [u16], &'a mut [Tile]), &'a [Leaf]);

/// All leaves of an index.
pub(crate) struct Tiles {
    /// In the order of the leaves.
    pub tiles: Vec<Tile>,
    /// The leaves whose points lie on planes next to them, ascending.
    pub mixed: Vec<u32>,
    /// Those planes, [`WIDTH`] for each of the leaves, place by place.
    pub patches: Vec<Patch>,
    /// For each point where it stands among the places of the leaves of its block.
    places: Vec<u16>,
}

impl Tiles {
    /// Fits every leaf; heights run along `axis`, a unit vector.
    pub(crate) fn new(index: &Index, noise: f64, axis: [f64; 3]) -> Self {
        let mut places = vec![0; index.len()];
        // Filled by all threads, since the first touch of new memory is what costs.
        let mut tiles: Vec<Tile> = index.leaves.par_iter().map(|_| Tile::EMPTY).collect();
        let block = |scratch: &mut Vec<Spread>, ((places, tiles), leaves): Block| {
            for (l, leaf) in leaves.iter().enumerate() {
                for (lane, id) in leaf.ids().enumerate() {
                    places[id as usize % BLOCK] = (l * WIDTH + lane) as u16;
                }
            }
            scratch.clear();
            for (leaf, tile) in leaves.iter().zip(&mut *tiles) {
                let (own, spread) = Tile::new(leaf, noise, axis);
                *tile = own;
                scratch.push(spread);
            }
            settle(leaves, tiles, scratch, noise)
        };
        let blocks = places.par_chunks_mut(BLOCK).zip(tiles.par_chunks_mut(BLOCK / WIDTH));
        let blocks = blocks.zip(index.leaves.par_chunks(BLOCK / WIDTH));
        let planes: Vec<Vec<Patch>> = blocks.map_init(Vec::new, block).collect();
        let blocks = tiles.par_chunks(BLOCK / WIDTH).zip(index.leaves.par_chunks(BLOCK / WIDTH)).enumerate();
        let beside = |(b, (tiles, leaves)): (usize, (&[Tile], &[Leaf]))| {
            let near = &planes[b.saturating_sub(1)..(b + 2).min(planes.len())];
            mixed(leaves, (b * (BLOCK / WIDTH)) as u32, tiles, near, noise)
        };
        let found: Vec<Vec<Mixed>> = blocks.map(beside).collect();
        let (mut mixed, mut patches) = (Vec::new(), Vec::new());
        for own in found.into_iter().flatten() {
            mixed.push(own.leaf);
            patches.extend(own.patches);
        }
        Self { tiles, mixed, patches, places }
    }

    /// The leaf that holds a point, and its place there.
    pub(crate) fn place(&self, point: u32) -> (usize, usize) {
        let place = self.places[point as usize] as usize;
        (point as usize / BLOCK * (BLOCK / WIDTH) + place / WIDTH, place % WIDTH)
    }
}

/// Settles which tiles of one block are flat, and gives their planes. A tile counts as flat with the three next to it, as
/// a bend that noise hides in one of them shows over all four; or alone, beside a crease, where it continues four flat ones.
fn settle(leaves: &[Leaf], tiles: &mut [Tile], spreads: &[Spread], noise: f64) -> Vec<Patch> {
    let widest = even(tiles);
    let mut planes: Vec<Patch> = Vec::new();
    let mut rest = Vec::new();
    for (q, spreads) in spreads.chunks(QUAD).enumerate() {
        let own = q * QUAD..q * QUAD + spreads.len();
        let quad = quad(&tiles[own.clone()], spreads);
        if quad.spacing <= widest && quad.residual <= (1.15 * noise + 0.05) * quad.spacing {
            let tiles = &mut tiles[own];
            if joins(tiles, &quad) {
                tiles.iter_mut().for_each(|tile| (tile.patch, tile.joined) = (quad, true));
            }
            for tile in tiles.iter_mut().filter(|t| t.narrow) {
                tile.patch.normal = quad.normal;
            }
            planes.push(quad);
        } else {
            rest.extend(own);
        }
    }
    for k in rest {
        let tile = &mut tiles[k];
        let plane = planes.iter().find(|plane| tile.flat && continues(&leaves[k], &tile.patch, plane, noise));
        tile.flat = plane.is_some();
        if let Some(plane) = plane.filter(|_| tile.narrow) {
            tile.patch.normal = plane.normal;
        }
    }
    planes
}

/// The mixed leaves of one block, whose first leaf is `first`, by the planes of it and of the blocks beside it in the order of
/// the points: a crease may run along where blocks meet.
fn mixed(leaves: &[Leaf], first: u32, tiles: &[Tile], planes: &[Vec<Patch>], noise: f64) -> Vec<Mixed> {
    if noise > NOISY {
        return Vec::new();
    }
    let creased = |((tile, leaf), index): ((&Tile, &Leaf), u32)| {
        let patches = if tile.flat { None } else { shared(leaf, planes, noise) };
        patches.map(|patches| Mixed { leaf: index, patches })
    };
    tiles.iter().zip(leaves).zip(first..).filter_map(creased).collect()
}

/// The plane nearby that each point of a leaf lies on, if all but [`STRAYS`] have one.
fn shared(leaf: &Leaf, planes: &[Vec<Patch>], noise: f64) -> Option<[Patch; WIDTH]> {
    let mut best = [(farthest(noise), Patch::NONE); WIDTH];
    for plane in planes.iter().flatten() {
        let (base, reach) = (vec3::dot(plane.normal, plane.centre), BESIDE * plane.spacing);
        let apart = leaf.distances2(plane.centre);
        if apart.iter().all(|&apart| apart > reach * reach) {
            continue;
        }
        let offs = leaf.along(plane.normal).map(|x| (x - base).abs() / plane.spacing);
        for (best, (off, apart)) in best.iter_mut().zip(offs.into_iter().zip(apart)) {
            if off <= best.0 && apart <= reach * reach {
                *best = (off, *plane);
            }
        }
    }
    let patches = best.map(|(_, patch)| patch);
    let strays = patches[..leaf.len()].iter().filter(|patch| patch.spacing <= 0.0).count();
    (strays <= STRAYS).then_some(patches)
}

/// Points of a leaf that may lie on no plane nearby: they are left out, as one of many that noise or an edge has moved.
const STRAYS: usize = 1;

/// Tiles much wider than most of a block are not flat: theirs are points of two places, with nothing known between.
/// Returns the spacing up to which they are taken.
fn even(tiles: &mut [Tile]) -> f64 {
    let mut spacings: Vec<f64> = tiles.iter().map(|t| t.patch.spacing).collect();
    let middle = spacings.len() / 2;
    let widest = WIDE * *spacings.select_nth_unstable_by(middle, f64::total_cmp).1;
    tiles.iter_mut().filter(|t| t.patch.spacing > widest).for_each(|t| t.flat = false);
    widest
}

/// How much wider than the median of its block a tile may be.
const WIDE: f64 = 3.0;

/// Leaves next to each other that show together whether they are flat.
pub(super) const QUAD: usize = 4;

/// Whether neighbouring tiles lie together on one plane as well as each on its own: no bend shows.
fn joins(tiles: &[Tile], quad: &Patch) -> bool {
    let own = tiles.iter().map(|t| t.patch.residual * t.patch.residual).sum::<f64>() / tiles.len() as f64;
    let beside = |t: &Tile| t.flat && vec3::distance(t.patch.centre, quad.centre) <= TOGETHER * quad.spacing;
    tiles.len() == QUAD && quad.residual <= 1.1 * own.sqrt() + 0.01 * quad.spacing && tiles.iter().all(beside)
}

/// How far from the middle of all four the middles of tiles that join may lie, in spacings: those in a row are too long.
const TOGETHER: f64 = 4.0;

/// The plane of neighbouring tiles; its residual is infinite where they do not show one.
fn quad(tiles: &[Tile], spreads: &[Spread]) -> Patch {
    let all = Spread::merged(spreads);
    let (least, normal) = spread::normal(&all.tensor);
    let spacing = tiles.iter().map(|t| t.patch.spacing).sum::<f64>() / tiles.len() as f64;
    let wide = Sides::new(&all.tensor, least.max(0.0)).shorter >= NARROW * spacing * spacing;
    let residual = if wide { least.max(0.0).sqrt() } else { f64::INFINITY };
    Patch { centre: all.centre, normal, residual, spacing }
}

/// Whether the points of a tile lie on a plane nearby.
fn continues(leaf: &Leaf, tile: &Patch, plane: &Patch, noise: f64) -> bool {
    let off = |p: [f64; 3]| vec3::dot(vec3::sub(p, plane.centre), plane.normal).abs() / plane.spacing;
    vec3::distance(tile.centre, plane.centre) <= BESIDE * plane.spacing
        && off(tile.centre) <= 0.5 * noise + 0.05
        && most_off(leaf, plane) <= farthest(noise) * plane.spacing
}

/// The greatest distance of the points of a leaf from a plane.
fn most_off(leaf: &Leaf, plane: &Patch) -> f64 {
    let base = vec3::dot(plane.normal, plane.centre);
    leaf.along(plane.normal)[..leaf.len()].iter().fold(0.0, |most: f64, x| most.max((x - base).abs()))
}

/// How far from the middle of four flat tiles another may continue them, in spacings.
const BESIDE: f64 = 10.0;

/// Distance from its plane in spacings that noise explains for each point of a tile.
fn farthest(noise: f64) -> f64 {
    3.0 * noise + 0.1
}

impl Tile {
    const EMPTY: Tile =
        Tile { patch: Patch::NONE, flat: false, joined: false, narrow: false, heights: (0.0, 0.0) };

    fn new(leaf: &Leaf, noise: f64, axis: [f64; 3]) -> (Self, Spread) {
        let heights = leaf.along(axis)[..leaf.len()]
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), &z| (l.min(z), h.max(z)));
        let spread = spread(leaf);
        let Spread { weight, centre, tensor } = spread;
        let (least, normal) = spread::normal(&tensor);
        let sides = Sides::new(&tensor, least.max(0.0));
        // Points spread evenly over a rectangle have a twelfth of its squared sides as variances.
        let spacing = (12.0 * sides.product.sqrt() / weight.max(1.0)).sqrt();
        let residual = (least.max(0.0) * weight / (weight - 3.0).max(1.0)).sqrt();
        let patch = Patch { centre, normal, residual, spacing };
        let flat = noise <= NOISY
            && weight >= FEWEST
            && residual <= good(noise) * spacing
            && most_off(leaf, &patch) <= farthest(noise) * spacing;
        let narrow = sides.shorter < NARROW * spacing * spacing;
        (Self { patch, flat, joined: false, narrow, heights }, spread)
    }
}

/// The spread of the points of a leaf; of a full one in four sums side by side, which compilers vectorise.
fn spread(leaf: &Leaf) -> Spread {
    let origin = leaf.points().next().map_or([0.0; 3], |(_, p)| p);
    if leaf.len() < WIDTH {
        return Spread::of(leaf.points().map(|(_, p)| (p, 1.0)), origin);
    }
    let mut sums = [[0.0; 4]; 9];
    for i in (0..WIDTH).step_by(4) {
        for l in 0..4 {
            let [x, y, z] = [0, 1, 2].map(|a| leaf.at[a][i + l] - origin[a]);
            for (sum, value) in sums.iter_mut().zip([x, y, z, x * x, x * y, x * z, y * y, y * z, z * z]) {
                sum[l] += value;
            }
        }
    }
    let [x, y, z, xx, xy, xz, yy, yz, zz] = sums.map(|s| (s[0] + s[1] + s[2] + s[3]) / WIDTH as f64);
    let tensor = [xx - x * x, xy - x * y, xz - x * z, yy - y * y, yz - y * z, zz - z * z];
    Spread { weight: WIDTH as f64, centre: vec3::add(origin, [x, y, z]), tensor }
}

/// The variances along a tile.
struct Sides {
    product: f64,
    shorter: f64,
}

impl Sides {
    fn new(&[xx, xy, xz, yy, yz, zz]: &[f64; 6], least: f64) -> Self {
        let sum = xx + yy + zz - least;
        let minors = xx * yy - xy * xy + xx * zz - xz * xz + yy * zz - yz * yz;
        let product = (minors - least * sum).max(0.0);
        let shorter = 0.5 * (sum - (sum * sum - 4.0 * product).max(0.0).sqrt());
        Self { product, shorter }
    }
}

/// Residual in spacings that noise explains.
pub(super) fn good(noise: f64) -> f64 {
    1.4 * noise + 0.03
}
