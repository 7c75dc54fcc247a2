//! Small numerical tools that know nothing of clouds.

pub(crate) mod banded;
pub(crate) mod convex_hull;
pub(crate) mod counting_sort;
pub(crate) mod eigen3;
pub(crate) mod least_axis;
pub(crate) mod least_squares;
pub(crate) mod otsu;
pub(crate) mod points;
pub(crate) mod quantile;
pub(crate) mod ruler;
pub(crate) mod skyline;
pub(crate) mod tensor;
pub(crate) mod trees;
pub(crate) mod tridiagonal;
#[cfg(test)]
mod uniform;
pub(crate) mod union_find;
pub(crate) mod vec2;
pub mod vec3;
