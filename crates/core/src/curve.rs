//! Curves in the plane and in space, one a file.

mod bspline;
pub(crate) mod circle;
pub(crate) mod ellipse;
mod fit;
mod fit_within;
pub(crate) mod flat_ellipse;
pub(crate) mod line;
pub(crate) mod moments;
pub mod pieces;
pub(crate) mod planar;
pub(crate) mod polygon;
pub(crate) mod polyline;
pub(crate) mod round;
mod rows;

pub use bspline::BSpline;
pub use ellipse::Ellipse;
pub(crate) use fit::{FitOptions, fit};
pub(crate) use fit_within::fit_within;
pub use round::Round;
