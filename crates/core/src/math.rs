//! Small numerical tools, independent of clouds.

pub(crate) mod convex_hull;
pub(crate) mod counting_sort;
pub(crate) mod eigen2;
pub(crate) mod eigen3;
pub(crate) mod least_axis;
pub(crate) mod otsu;
pub(crate) mod points;
pub(crate) mod quantile;
pub(crate) mod ruler;
mod systems;
pub(crate) mod tensor;
pub(crate) mod tournament;
pub(crate) mod trees;
#[cfg(test)]
pub(crate) mod uniform;
pub(crate) mod union_find;
pub(crate) mod vec2;
pub mod vec3;

pub(crate) use systems::{banded, degree, dense, least_squares, skyline, sparse, tridiagonal};
