//! Detectors: what every point says of the lines it may lie on.

pub mod baselines;
pub mod consensus;
pub mod fold;
pub mod marks;
pub mod normals;
pub mod open_angle;
pub mod penalty;
pub mod points;
pub mod projection;
pub mod segments;
