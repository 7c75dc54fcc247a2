//! Tiles judged four by four: a tile counts as flat with the three next to it, or alone beside a crease, where it continues
//! four flat ones.

use super::plane::TangentPlane;
use super::spread::{self, Spread};
use super::tile::{NARROW, Sides, Tile, farthest, most_off};
use crate::math::vec3;
use crate::neighbors::Leaf;

/// Greatest distance from the middle of four flat tiles at which another may continue them, spacings.
pub(crate) const CONTINUES_WITHIN: f64 = 10.0;
/// Greatest width of a tile, as a multiple of the median of its block.
const WIDEST_TILE: f64 = 3.0;
/// Leaves next to each other that show together whether they are flat.
pub(crate) const QUAD: usize = 4;
/// Greatest distance of the middles of joined tiles from the middle of all four, spacings: four tiles in a row are too long.
const JOINED_WITHIN: f64 = 4.0;

/// Settles which tiles of one block are flat, and gives their planes. A tile counts as flat with the three next to it, as
/// a bend that noise hides in one of them shows over all four; or alone, beside a crease, where it continues four flat ones.
pub(crate) fn settle(
    leaves: &[Leaf],
    tiles: &mut [Tile],
    spreads: &[Spread],
    noise: f64,
) -> Vec<TangentPlane> {
    let widest = even(tiles);
    let mut planes: Vec<TangentPlane> = Vec::new();
    let mut rest = Vec::new();
    for (q, spreads) in spreads.chunks(QUAD).enumerate() {
        let own = q * QUAD..q * QUAD + spreads.len();
        let quad = quad(&tiles[own.clone()], spreads);
        if quad.spacing <= widest && quad.residual <= (1.15 * noise + 0.05) * quad.spacing {
            let tiles = &mut tiles[own];
            if joins(tiles, &quad) {
                tiles.iter_mut().for_each(|tile| (tile.plane, tile.joined) = (quad, true));
            }
            for tile in tiles.iter_mut().filter(|t| t.narrow) {
                tile.plane.normal = quad.normal;
            }
            planes.push(quad);
        } else {
            rest.extend(own);
        }
    }
    for k in rest {
        let tile = &mut tiles[k];
        let plane = planes.iter().find(|plane| tile.flat && continues(&leaves[k], &tile.plane, plane, noise));
        tile.flat = plane.is_some();
        if let Some(plane) = plane.filter(|_| tile.narrow) {
            tile.plane.normal = plane.normal;
        }
    }
    planes
}

/// Tiles much wider than most of a block are not flat: theirs are points of two places, with nothing known between.
/// Returns the spacing up to which they are taken.
fn even(tiles: &mut [Tile]) -> f64 {
    let mut spacings: Vec<f64> = tiles.iter().map(|t| t.plane.spacing).collect();
    let middle = spacings.len() / 2;
    let widest = WIDEST_TILE * *spacings.select_nth_unstable_by(middle, f64::total_cmp).1;
    tiles.iter_mut().filter(|t| t.plane.spacing > widest).for_each(|t| t.flat = false);
    widest
}

/// Whether neighbouring tiles lie together on one plane as well as each on its own: no bend shows.
fn joins(tiles: &[Tile], quad: &TangentPlane) -> bool {
    let own = tiles.iter().map(|t| t.plane.residual * t.plane.residual).sum::<f64>() / tiles.len() as f64;
    let beside =
        |t: &Tile| t.flat && vec3::distance(t.plane.centre, quad.centre) <= JOINED_WITHIN * quad.spacing;
    tiles.len() == QUAD && quad.residual <= 1.1 * own.sqrt() + 0.01 * quad.spacing && tiles.iter().all(beside)
}

/// The plane of neighbouring tiles; its residual is infinite where they do not show one.
fn quad(tiles: &[Tile], spreads: &[Spread]) -> TangentPlane {
    let all = Spread::merged(spreads);
    let (least, normal) = spread::normal(&all.tensor);
    let spacing = tiles.iter().map(|t| t.plane.spacing).sum::<f64>() / tiles.len() as f64;
    let wide = Sides::new(&all.tensor, least.max(0.0)).shorter >= NARROW * spacing * spacing;
    let residual = if wide { least.max(0.0).sqrt() } else { f64::INFINITY };
    TangentPlane { centre: all.centre, normal, residual, spacing }
}

/// Whether the points of a tile lie on a plane nearby.
fn continues(leaf: &Leaf, tile: &TangentPlane, plane: &TangentPlane, noise: f64) -> bool {
    let off = |p: [f64; 3]| vec3::dot(vec3::sub(p, plane.centre), plane.normal).abs() / plane.spacing;
    vec3::distance(tile.centre, plane.centre) <= CONTINUES_WITHIN * plane.spacing
        && off(tile.centre) <= 0.5 * noise + 0.05
        && most_off(leaf, plane) <= farthest(noise) * plane.spacing
}
