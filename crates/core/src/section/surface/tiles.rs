//! All leaves of the index as tiles, fitted block by block. On a large cloud nearly all are flat, which costs a hundredth of
//! a plane for each point.

use super::mixed::{Mixed, mixed};
use super::plane::TangentPlane;
use super::quad::settle;
use super::spread::Spread;
use super::tile::Tile;
use crate::neighbors::{BLOCK, Index, WIDTH};
use crate::parallel;

/// All leaves of an index.
pub(crate) struct Tiles {
    /// In the order of the leaves.
    pub tiles: Vec<Tile>,
    /// The leaves whose points lie on planes next to them, ascending.
    pub mixed: Vec<u32>,
    /// Those planes, [`WIDTH`] for each of the leaves, place by place.
    pub planes: Vec<TangentPlane>,
    /// For each point where it stands among the places of the leaves of its block.
    places: Vec<u16>,
}

impl Tiles {
    /// Fits every leaf; heights run along `axis`, a unit vector.
    pub(crate) fn new(index: &Index, noise: f64, axis: [f64; 3]) -> Self {
        let mut places = vec![0; index.len()];
        let mut tiles = parallel::filled(index.leaves.len(), &Tile::EMPTY);
        let blocks = places.chunks_mut(BLOCK).zip(tiles.chunks_mut(BLOCK / WIDTH));
        let blocks = blocks.zip(index.leaves.chunks(BLOCK / WIDTH));
        let planes = parallel::each(blocks, |_, ((places, tiles), leaves)| {
            for (l, leaf) in leaves.iter().enumerate() {
                for (lane, id) in leaf.ids().enumerate() {
                    places[id as usize % BLOCK] = (l * WIDTH + lane) as u16;
                }
            }
            let mut spreads: Vec<Spread> = Vec::with_capacity(leaves.len());
            for (leaf, tile) in leaves.iter().zip(&mut *tiles) {
                let (own, spread) = Tile::new(leaf, noise, axis);
                *tile = own;
                spreads.push(spread);
            }
            settle(leaves, tiles, &spreads, noise)
        });
        let blocks = tiles.chunks(BLOCK / WIDTH).zip(index.leaves.chunks(BLOCK / WIDTH));
        let found: Vec<Vec<Mixed>> = parallel::each(blocks, |b, (tiles, leaves)| {
            let near = &planes[b.saturating_sub(1)..(b + 2).min(planes.len())];
            mixed(leaves, (b * (BLOCK / WIDTH)) as u32, tiles, near, noise)
        });
        let (mut mixed, mut planes) = (Vec::new(), Vec::new());
        for own in found.into_iter().flatten() {
            mixed.push(own.leaf);
            planes.extend(own.planes);
        }
        Self { tiles, mixed, planes, places }
    }

    /// The leaf that holds a point, and its place there.
    pub(crate) fn place(&self, point: u32) -> (usize, usize) {
        let place = self.places[point as usize] as usize;
        (point as usize / BLOCK * (BLOCK / WIDTH) + place / WIDTH, place % WIDTH)
    }
}
