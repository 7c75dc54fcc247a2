//! Curves that strips are fitted with.

mod bspline;
mod fit;

pub use bspline::BSpline;
pub use fit::{FitOptions, fit};
