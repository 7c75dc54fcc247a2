//! What a result is put to use for.

pub mod render;
