//! Small numerical tools that know nothing of clouds.

pub mod vec3;
