//! Encoders that several writers share.

pub(super) mod dxf;
pub(super) mod gpkg;
pub(super) mod json;
pub(super) mod ply;
pub(super) mod polyline;
pub(super) mod sqlite;
pub(super) mod step;
pub(super) mod view;
pub(super) mod zip;
