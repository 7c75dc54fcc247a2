//! Curves in the plane and in space, one a file.

mod bspline;
pub(crate) mod circle;
mod fit;
mod fit_within;
pub(crate) mod line;
pub(crate) mod moments;
pub mod pieces;
pub(crate) mod planar;
pub(crate) mod polygon;
pub(crate) mod polyline;
pub(crate) mod round;
mod rows;

pub use bspline::BSpline;
pub(crate) use fit::{FitOptions, fit};
pub(crate) use fit_within::fit_within;
pub use round::Round;
