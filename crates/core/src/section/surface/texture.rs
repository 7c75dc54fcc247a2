//! The noise and the spacing of a cloud, from a sample of it.

use super::plane::{Around, FIRST_NEIGHBORS, TangentPlane};
use super::sample::sampled;
use crate::math::quantile::quantile;
use crate::neighbors::Index;

/// Noise and spacing of a cloud.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Texture {
    /// Standard deviation of the points from the surface, in local spacings.
    pub noise: f64,
    /// Median spacing.
    pub spacing: f64,
    /// Spacing that all but one point in two hundred stay under.
    pub widest: f64,
}

/// Reads noise and spacing from evenly spread leaves.
pub(crate) fn texture(points: &[[f64; 3]], index: &Index) -> Texture {
    let plane = |i: u32, near: &[u32]| Some(Around::gather(points, i, near).plain());
    let planes = sampled(points, index, FIRST_NEIGHBORS - 1, plane);
    let mut spacings: Vec<f64> = planes.iter().map(|p| p.spacing).filter(|&s| s > 0.0).collect();
    let ratio = |p: &TangentPlane| p.residual / p.spacing;
    // The residual that a quiet third of the points shows: creases and curvature sit in the upper part.
    let mut ratios: Vec<f64> = planes.iter().filter(|p| p.spacing > 0.0).map(ratio).collect();
    Texture {
        noise: quantile(&mut ratios, 0.3),
        spacing: quantile(&mut spacings, 0.5),
        widest: quantile(&mut spacings, 0.995),
    }
}
