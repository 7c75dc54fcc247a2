//! Systems of linear equations, by the shape of their matrices.

pub(crate) mod banded;
pub(crate) mod degree;
pub(crate) mod dense;
pub(crate) mod least_squares;
pub(crate) mod skyline;
pub(crate) mod sparse;
pub(crate) mod tridiagonal;
