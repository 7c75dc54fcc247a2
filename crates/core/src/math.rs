//! Small numerical tools that know nothing of clouds.

pub mod eigen3;
pub mod least_axis;
pub mod least_squares;
pub mod otsu;
pub mod skyline;
pub mod tensor;
pub mod union_find;
pub mod vec3;
