//! Patches: the smooth regions of the surface that the strips of a network bound, and the curve network they form.
//!
//! Demarsin et al. 2007 leave this step to the future (section 4: "a set of loops, where each loop defines the boundary of an
//! area where a patch can be fitted"). Here a patch is a connected part of the neighbour graph that no strip crosses:
//!
//! 1. `stations`: along each strip the directions in which the surface leaves it on both sides;
//! 2. `beside`: which points lie beside which strip, and on which side;
//! 3. `flood`: components of the graph over the edges that cross no strip;
//! 4. `orient`: normals that point outwards, from patch to patch over the strips;
//! 5. `area`, `fit`: a first surface of each patch;
//! 6. `sides`: the patches left and right of each strip, the fold between them;
//! 7. `loops`: strips in order round each patch.
//!
//! It takes the network of any method. Whether a patch is a whole face depends on the strips: a gap joins two faces.

mod area;
mod beside;
mod find;
mod fit;
mod flood;
mod ground;
mod loops;
mod orient;
mod patches;
mod sides;
mod stations;

pub(crate) use find::patches;
pub use fit::{Fit, Surface};
pub(crate) use ground::Ground;
pub use ground::NO_PATCH;
pub use loops::{Coedge, Loop};
pub use patches::{Patch, Patches};
pub use sides::Sides;

#[cfg(test)]
mod tests;
