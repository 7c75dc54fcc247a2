//! Trees over points and boxes.

pub(crate) mod boxes;
pub(crate) mod kd;
pub(crate) mod packed;
