//! Small numerical tools that know nothing of clouds.

pub mod eigen3;
pub mod skyline;
pub mod union_find;
pub mod vec3;
