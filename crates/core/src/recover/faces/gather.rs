//! The points beside a strip.

use crate::neighbors::{Neighbors, riemannian::Scratch};
use crate::network::Strip;

/// Distance in the neighbour graph up to which points are taken.
pub(crate) const HOPS: usize = 4;

/// The points up to [`HOPS`] from the sources of a strip, ascending.
pub(in crate::recover) fn near(strip: &Strip, graph: &Neighbors, scratch: &mut Scratch) -> Vec<u32> {
    let mut near: Vec<u32> = Vec::new();
    for &source in &strip.sources {
        near.push(source);
        near.extend_from_slice(graph.hops(source as usize, HOPS, scratch));
    }
    near.sort_unstable();
    near.dedup();
    near
}
