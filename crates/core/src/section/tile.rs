//! The leaves of the index as tiles of the surface: one plane for its sixteen points where they lie on it as well as noise
//! explains. On a large cloud that is nearly all of them, and costs a hundredth of a plane for each point.

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
const NOISY: f64 = 0.15;

/// A leaf of the index.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tile {
    /// The plane of its points, local frame.
    pub patch: Patch,
    /// Whether that plane holds for each of them.
    pub flat: bool,
    /// Whether its points do not show how it lies across.
    narrow: bool,
    /// Least and greatest height of its points across the slices, local frame.
    pub heights: (f64, f64),
}

/// All leaves of an index.
pub(crate) struct Tiles {
    /// In the order of the leaves.
    pub tiles: Vec<Tile>,
    /// For each point where it stands among the places of the leaves of its block.
    places: Vec<u16>,
}

impl Tiles {
    /// Fits every leaf; heights run along `axis`, a unit vector.
    pub(crate) fn new(index: &Index, noise: f64, axis: [f64; 3]) -> Self {
        let mut places = vec![0; index.len()];
        let leaves = index.leaves.par_chunks(BLOCK / WIDTH);
        let block = |(places, leaves): (&mut [u16], &[Leaf])| {
            for (l, leaf) in leaves.iter().enumerate() {
                for (lane, id) in leaf.ids().enumerate() {
                    places[id as usize % BLOCK] = (l * WIDTH + lane) as u16;
                }
            }
            tiles(leaves, noise, axis)
        };
        let tiles = places.par_chunks_mut(BLOCK).zip(leaves).map(block).collect::<Vec<_>>().concat();
        Self { tiles, places }
    }

    /// The leaf that holds a point, and its place there.
    pub(crate) fn place(&self, point: u32) -> (usize, usize) {
        let place = self.places[point as usize] as usize;
        (point as usize / BLOCK * (BLOCK / WIDTH) + place / WIDTH, place % WIDTH)
    }
}

/// The tiles of one block. A tile counts as flat with the three next to it, as a bend that noise hides in one of them
/// shows over all four; or alone, beside a crease, where it continues four flat ones.
fn tiles(leaves: &[Leaf], noise: f64, axis: [f64; 3]) -> Vec<Tile> {
    let (mut tiles, spreads): (Vec<Tile>, Vec<Spread>) =
        leaves.iter().map(|l| Tile::new(l, noise, axis)).unzip();
    let mut planes: Vec<Patch> = Vec::new();
    let mut rest = Vec::new();
    for (q, spreads) in spreads.chunks(QUAD).enumerate() {
        let own = q * QUAD..q * QUAD + spreads.len();
        let quad = quad(&tiles[own.clone()], spreads);
        if quad.residual <= (1.15 * noise + 0.05) * quad.spacing {
            for tile in tiles[own].iter_mut().filter(|t| t.narrow) {
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
    tiles
}

/// Leaves next to each other that show together whether they are flat.
const QUAD: usize = 4;

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
        && leaf.points().all(|(_, p)| off(p) <= farthest(noise))
}

/// How far from the middle of four flat tiles another may continue them, in spacings.
const BESIDE: f64 = 10.0;

/// Distance from its plane in spacings that noise explains for each point of a tile.
fn farthest(noise: f64) -> f64 {
    3.0 * noise + 0.1
}

impl Tile {
    fn new(leaf: &Leaf, noise: f64, axis: [f64; 3]) -> (Self, Spread) {
        let heights = leaf.points().map(|(_, p)| vec3::dot(axis, p));
        let heights = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), z| (l.min(z), h.max(z)));
        let spread = spread(leaf);
        let Spread { weight, centre, tensor } = spread;
        let (least, normal) = spread::normal(&tensor);
        let sides = Sides::new(&tensor, least.max(0.0));
        // Points spread evenly over a rectangle have a twelfth of its squared sides as variances.
        let spacing = (12.0 * sides.product.sqrt() / weight.max(1.0)).sqrt();
        let residual = (least.max(0.0) * weight / (weight - 3.0).max(1.0)).sqrt();
        let off = |p: [f64; 3]| vec3::dot(vec3::sub(p, centre), normal).abs();
        let flat = noise <= NOISY
            && weight >= FEWEST
            && residual <= good(noise) * spacing
            && leaf.points().all(|(_, p)| off(p) <= farthest(noise) * spacing);
        let narrow = sides.shorter < NARROW * spacing * spacing;
        (Self { patch: Patch { centre, normal, residual, spacing }, flat, narrow, heights }, spread)
    }
}

/// The spread of the points of a leaf; of a full one in four sums side by side, which compilers vectorise.
fn spread(leaf: &Leaf) -> Spread {
    let origin = leaf.points().next().map_or([0.0; 3], |(_, p)| p);
    if leaf.ids().count() < WIDTH {
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
