//! Curves in the plane and in space, one a file.

mod bspline;
pub(crate) mod circle;
mod fit;
pub(crate) mod line;
pub(crate) mod polygon;
pub(crate) mod polyline;

pub use bspline::BSpline;
pub use fit::{FitOptions, fit};
