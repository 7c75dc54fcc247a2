//! Trees over points.

pub(crate) mod kd;
pub(crate) mod packed;
