//! Evidence of creases and borders that holds under noise: ours, shared by the robust penalties and the projected distance.
//!
//! `normals` keep to their side of a crease (by `consensus`, then bilateral averaging); `sides` is the correlation tensor of
//! the normals around a point, of two sides alone where a face is narrower than the neighbourhood (`pair`); `crease` and
//! `border` make candidates, a crease with the evidence of its cross-section (`sharpness`, `fold`); `align` aligns the feet of
//! a line's candidates.

pub(crate) mod align;
pub(crate) mod border;
pub(crate) mod consensus;
pub(crate) mod crease;
pub(crate) mod fold;
pub(crate) mod hops;
pub(crate) mod normals;
pub(crate) mod open_angle;
pub(crate) mod pair;
pub(crate) mod sharpness;
pub(crate) mod sides;
pub(crate) mod surroundings;
