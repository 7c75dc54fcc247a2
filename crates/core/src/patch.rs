//! Patches: the smooth regions of the surface between the strips of a network, and the curve network that bounds them.
//!
//! Demarsin et al. 2007 leave this step to the future (section 4: "a set of loops, where each loop defines the boundary of an
//! area where a patch can be fitted"). Here a patch is a connected part of the neighbour graph that no strip crosses:
//!
//! 1. `stations`: places along each strip, with frames;
//! 2. `beside`: the points beside each strip, and the directions in which the surface leaves it on both sides;
//! 3. `flood`: components of the graph over the edges that cross no strip;
//! 4. `orient`: outward normals, from patch to patch over the strips;
//! 5. `area`, `fit`: the area of each patch and its surface;
//! 6. `sides`: the patches left and right of each strip, and the fold between them;
//! 7. `loops`: the strips in order round each patch.
//!
//! [`brep`] makes faces of them, trimmed by edges that they share.
//!
//! The network of any method will do. Whether a patch is a whole face depends on the strips: a gap in them joins two faces.

mod area;
mod beside;
mod brep;
mod cross;
mod find;
mod fit;
mod flood;
mod ground;
mod loops;
mod near;
mod orient;
mod patches;
mod sides;
mod stations;

pub use brep::{Brep, Edge, Face, Omission, Shell, brep};
pub(crate) use cross::Crossing;
pub(crate) use find::patches;
pub use fit::{Fit, Surface};
pub(crate) use ground::Ground;
pub use ground::NO_PATCH;
pub use loops::{Coedge, Loop};
pub use patches::{Patch, Patches};
pub use sides::Sides;

#[cfg(test)]
mod tests;
