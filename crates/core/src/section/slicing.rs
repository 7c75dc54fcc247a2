//! Slicing the point cloud (Kyriazis et al., section 2): direction, planes and slabs, and the way from a slab to its section.

pub(crate) mod adaptive;
pub(crate) mod axis;
pub(crate) mod direction;
mod level;
pub(crate) mod planes;
mod reach;
pub(crate) mod slabs;
pub(crate) mod slicer;
