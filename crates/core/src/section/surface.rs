//! The local surface: tangent planes of tiles and of single points, and points carried along them to a slicing plane.

pub(crate) mod carry;
pub(crate) mod mixed;
pub(crate) mod plane;
pub(crate) mod quad;
pub(crate) mod sample;
pub(crate) mod spread;
pub(crate) mod tangents;
pub(crate) mod texture;
pub(crate) mod tile;
pub(crate) mod tiles;
