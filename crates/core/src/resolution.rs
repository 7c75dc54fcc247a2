//! How densely and how noisily the surface was sampled: two numbers that every tolerance follows from.

use crate::detect::tensor::ellipsoid;
use crate::math::vec3::distance;
use crate::neighbors::Neighbors;
use rayon::prelude::*;

/// Mean spacing and noise of a cloud, local frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resolution {
    /// Mean distance to the six nearest neighbours, corrected for what noise adds to it.
    pub spacing: f64,
    /// Standard deviation of the noise along the surface normal.
    pub noise: f64,
}

/// Points looked at for the estimate; more change it by less than a percent.
const SAMPLES: usize = 40_000;
/// Sizes of the local plane fits, own point included, with the 30 % quantile of the root of a chi-square variable of
/// `size - 3` degrees of freedom over those degrees: what a fit to pure noise of standard deviation 1 shows there.
const FITS: [(usize, f64); 2] = [(9, 0.799), (13, 0.852)];
/// A low quantile over the points keeps creases and curved places out.
const QUANTILE: f64 = 0.3;

impl Resolution {
    /// Estimates both from `nearest`, the lists of nearest neighbours in order of distance.
    ///
    /// Noise is the residual of local plane fits: of several sizes the least, as curvature only adds to it.
    pub fn estimate(points: &[[f64; 3]], nearest: &Neighbors) -> Resolution {
        let step = points.len().div_ceil(SAMPLES).max(1);
        let chosen: Vec<usize> = (0..points.len()).step_by(step).collect();
        let near: Vec<f64> = chosen.par_iter().map(|&i| mean_distance(points, i, nearest.of(i))).collect();
        let raw = near.iter().sum::<f64>() / near.len().max(1) as f64;
        let noise = FITS
            .iter()
            .filter_map(|&(size, scale)| residual_quantile(points, nearest, &chosen, size).map(|r| r / scale))
            .min_by(f64::total_cmp)
            .unwrap_or(0.0);
        // Noise pushes neighbours apart: measured on planes, the six nearest lie at h (1 + 3/4 (sigma / h)^2).
        let mut spacing = raw;
        for _ in 0..8 {
            spacing = raw / (1.0 + 0.75 * (noise / spacing).powi(2).min(1.0));
        }
        Resolution { spacing, noise }
    }
}

fn mean_distance(points: &[[f64; 3]], i: usize, nearest: &[u32]) -> f64 {
    let six = &nearest[..nearest.len().min(6)];
    six.iter().map(|&j| distance(points[i], points[j as usize])).sum::<f64>() / six.len().max(1) as f64
}

/// The [`QUANTILE`] over the chosen points of the plane residual, unbiased for the three parameters of the plane.
fn residual_quantile(points: &[[f64; 3]], nearest: &Neighbors, chosen: &[usize], size: usize) -> Option<f64> {
    let mut residuals: Vec<f64> = chosen
        .par_iter()
        .filter(|&&i| nearest.of(i).len() >= size - 1)
        .map(|&i| {
            let fit = ellipsoid(points, i, &nearest.of(i)[..size - 1]);
            (fit.axes.values[0].max(0.0) * size as f64 / (size - 3) as f64).sqrt()
        })
        .collect();
    if residuals.is_empty() {
        return None;
    }
    let rank = (QUANTILE * (residuals.len() - 1) as f64) as usize;
    Some(*residuals.select_nth_unstable_by(rank, f64::total_cmp).1)
}
