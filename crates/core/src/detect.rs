//! Detectors: what every point says of the lines it may lie on.

pub mod consensus;
pub mod fold;
pub mod normals;
pub mod open_angle;
pub mod penalty;
pub mod segments;
pub mod tensor;
