//! Surface variation: at one scale, its greatest value over scales, and its persistence (Pauly, Keiser and Gross 2003).
//!
//! Pauly's scales grow from 15 to about 200 neighbours and stop where another sheet comes in; here they are the seven of
//! Tran 2013, up to 32. Persistence counts the scales at which the variation exceeds a threshold. Pauly's user gives the
//! threshold; here it is Otsu's, on the variations of all points at all scales.

use super::SCALE;
use crate::detect::projection::scales::{SCALES, at_every_scale};
use crate::math::otsu::otsu;

/// The greatest possible surface variation: all eigenvalues are equal.
const GREATEST: f32 = 1.0 / 3.0;

/// `(N)` surface variation of the point and its 16 nearest neighbours, 0 to 1/3.
pub(super) fn at_scale(points: &[[f64; 3]]) -> Vec<f32> {
    at_every_scale(points, |_, _, scales| scales[SCALE.1].variation as f32)
}

/// `(N)` greatest surface variation over all scales, 0 to 1/3.
pub(super) fn greatest(points: &[[f64; 3]]) -> Vec<f32> {
    at_every_scale(points, |_, _, scales| scales.iter().map(|s| s.variation as f32).fold(0.0, f32::max))
}

/// `(N)` share of the scales at which the surface variation is above the common threshold, 0 to 1.
pub(super) fn persistence(points: &[[f64; 3]], bins: usize) -> Vec<f32> {
    let rows = at_every_scale(points, |_, _, scales| scales.map(|s| s.variation as f32 / GREATEST));
    let threshold = otsu(rows.as_flattened(), bins).map_or(f64::INFINITY, |cut| cut.threshold);
    let high = |row: &[f32; 7]| row.iter().filter(|&&v| f64::from(v) > threshold).count();
    rows.iter().map(|row| high(row) as f32 / SCALES.len() as f32).collect()
}
