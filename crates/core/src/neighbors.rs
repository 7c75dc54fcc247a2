//! Nearest neighbours of every point, as flat lists.

pub(crate) mod delaunay_ring;
mod density;
mod engine;
mod found;
mod index;
mod kernel;
mod leaf;
mod lists;
mod nearest;
pub mod riemannian;
mod rows;
#[cfg(target_arch = "x86_64")]
mod simd;
mod split;
mod subset;

pub use density::mean_distance;
pub use engine::Instructions;
pub use found::Found;
pub use index::Index;
pub use leaf::BLOCK;
pub(crate) use leaf::{Leaf, WIDTH};
pub(crate) use nearest::nearest_leaves;
pub use nearest::{all_nearest, all_nearest_with, nearest_blocks};
pub use rows::Neighbors;
pub use subset::among;

#[cfg(test)]
mod tests;
