//! Mixed leaves: beside a crease the points of a tile that is not flat may lie on the planes of several flat ones next to it,
//! each on its own.

use super::plane::TangentPlane;
use super::quad::CONTINUES_WITHIN;
use super::tile::{NOISY, Tile, farthest};
use crate::math::vec3;
use crate::neighbors::{Leaf, WIDTH};

/// Points of a leaf that may lie on no plane nearby: they are left out, as one of many that noise or an edge has moved.
const STRAYS: usize = 1;

/// A leaf whose points lie on planes next to it, place by place.
pub(crate) struct Mixed {
    /// Its index.
    pub leaf: u32,
    /// The planes of its points, place by place.
    pub planes: [TangentPlane; WIDTH],
}

/// The mixed leaves of one block, whose first leaf is `first`, by the planes of it and of the blocks beside it in the order of
/// the points: a crease may run along where blocks meet.
pub(crate) fn mixed(
    leaves: &[Leaf],
    first: u32,
    tiles: &[Tile],
    planes: &[Vec<TangentPlane>],
    noise: f64,
) -> Vec<Mixed> {
    if noise > NOISY {
        return Vec::new();
    }
    let creased = |((tile, leaf), index): ((&Tile, &Leaf), u32)| {
        let planes = if tile.flat { None } else { shared(leaf, planes, noise) };
        planes.map(|planes| Mixed { leaf: index, planes })
    };
    tiles.iter().zip(leaves).zip(first..).filter_map(creased).collect()
}

/// The plane nearby that each point of a leaf lies on, if all but [`STRAYS`] have one.
fn shared(leaf: &Leaf, planes: &[Vec<TangentPlane>], noise: f64) -> Option<[TangentPlane; WIDTH]> {
    let mut best = [(farthest(noise), TangentPlane::NONE); WIDTH];
    for plane in planes.iter().flatten() {
        let (base, reach) = (vec3::dot(plane.normal, plane.centre), CONTINUES_WITHIN * plane.spacing);
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
    let planes = best.map(|(_, plane)| plane);
    let strays = planes[..leaf.len()].iter().filter(|plane| plane.spacing <= 0.0).count();
    (strays <= STRAYS).then_some(planes)
}
