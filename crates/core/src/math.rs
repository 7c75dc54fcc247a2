//! Small numerical tools that know nothing of clouds.

pub(crate) mod banded;
pub(crate) mod convex_hull;
pub(crate) mod counting_sort;
pub mod eigen3;
pub mod least_axis;
pub mod least_squares;
pub mod otsu;
pub(crate) mod points;
pub(crate) mod quantile;
pub(crate) mod ruler;
pub mod skyline;
pub mod tensor;
pub(crate) mod trees;
pub(crate) mod tridiagonal;
pub mod union_find;
pub(crate) mod vec2;
pub mod vec3;
