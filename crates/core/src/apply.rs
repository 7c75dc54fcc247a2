//! Applications of a result: pictures.

pub mod render;
