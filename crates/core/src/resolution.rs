//! Resolution: the spacing and the noise of the sampling, from which every tolerance follows.

use crate::math::tensor::ellipsoid;
use crate::neighbors::{Neighbors, mean_distance, riemannian::Scratch};
use crate::parallel;

/// Mean spacing and noise of a cloud, local frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Resolution {
    /// Mean distance to the six nearest neighbours, corrected for the part due to noise.
    pub spacing: f64,
    /// Standard deviation of the noise along the surface normal.
    pub noise: f64,
}

/// Number of points from which the estimate is made; more change it by less than a percent.
const SAMPLES: usize = 20_000;
/// Sizes of the local plane fits, own point included, and for each the 30 % quantile of the root of a chi-square variable of
/// `size - 3` degrees of freedom divided by these degrees: the residual of a fit to pure noise of standard deviation 1.
const FITS: [(usize, f64); 2] = [(9, 0.799), (13, 0.852)];
/// The same quantile for the hundred points and more of a neighbourhood by graph distance.
const WIDE_QUANTILE: f64 = 0.96;
/// Greatest graph distance of the neighbourhoods in which noise is estimated.
const WIDEST_HOPS: usize = 5;
/// Multiple of the median above which a distance to neighbours does not count.
const STRAY: f64 = 8.0;
/// The quantile of the residuals over the points: a low one leaves creases and curved places out.
const QUANTILE: f64 = 0.3;
/// Greatest residual of a flat neighbourhood, as a share of its radius. One that is not flat is smaller than the noise, and its
/// residual measures its own size.
const FLAT: f64 = 0.25;

impl Resolution {
    /// Estimates both from `nearest`, the lists of nearest neighbours in order of distance, and the graph made of them.
    ///
    /// Noise is the residual of local plane fits: the least among the flat ones of several sizes, as curvature only adds to it.
    /// If none of these is flat, neighbourhoods of growing graph distance are tried, and the first flat one counts.
    pub fn estimate(points: &[[f64; 3]], nearest: &Neighbors, graph: &Neighbors) -> Resolution {
        let step = points.len().div_ceil(SAMPLES).max(1);
        let chosen: Vec<usize> = (0..points.len()).step_by(step).collect();
        let near = parallel::map(chosen.len(), parallel::SLOW, |k| {
            mean_distance(points, chosen[k], six(nearest.of(chosen[k])))
        });
        let raw = mean_without_strays(&near);
        let small = FITS.iter().filter_map(|&(size, scale)| {
            let fits = chosen.iter().filter(|&&i| nearest.of(i).len() >= size - 1);
            flat_residual(points, fits.map(|&i| (i, nearest.of(i)[..size - 1].to_vec())).collect(), scale)
        });
        let noise =
            small.min_by(f64::total_cmp).or_else(|| wide_noise(points, graph, &chosen)).unwrap_or(0.0);
        // Noise pushes neighbours apart: on planes, the six nearest lie at h (1 + 3/4 (sigma / h)^2), as measured.
        let mut spacing = raw;
        for _ in 0..8 {
            spacing = raw / (1.0 + 0.75 * (noise / spacing).powi(2).min(1.0));
        }
        Resolution { spacing, noise }
    }

    /// The length below which no detail can be resolved: the spacing, or twice the noise if that is more.
    pub fn unit(&self) -> f64 {
        self.spacing.max(2.0 * self.noise)
    }
}

/// The mean of the values up to [`STRAY`] times their median, so that one far point cannot make a cloud coarse.
fn mean_without_strays(values: &[f64]) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let limit = STRAY * quantile(values.to_vec(), 0.5);
    let (sum, count) = values.iter().filter(|&&v| v <= limit).fold((0.0, 0), |(s, n), v| (s + v, n + 1));
    sum / f64::from(count)
}

/// The six nearest neighbours: a ring on a surface.
fn six(nearest: &[u32]) -> &[u32] {
    &nearest[..nearest.len().min(6)]
}

/// The noise in neighbourhoods of graph distance two and more: the first that is flat, else the widest.
fn wide_noise(points: &[[f64; 3]], graph: &Neighbors, chosen: &[usize]) -> Option<f64> {
    let few: Vec<usize> = chosen.iter().copied().step_by(chosen.len().div_ceil(2000).max(1)).collect();
    (2..=WIDEST_HOPS).find_map(|hops| {
        let mut scratch = Scratch::default();
        let sets = few.iter().map(|&i| (i, graph.hops(i, hops, &mut scratch).to_vec())).collect();
        flat_residual(points, sets, WIDE_QUANTILE)
    })
}

/// The [`QUANTILE`] of the plane residuals divided by `scale`, corrected for the three parameters of the plane; `None` if the
/// neighbourhoods are not flat.
fn flat_residual(points: &[[f64; 3]], sets: Vec<(usize, Vec<u32>)>, scale: f64) -> Option<f64> {
    let sets: Vec<(usize, Vec<u32>)> = sets.into_iter().filter(|(_, set)| set.len() > 3).collect();
    let fits = parallel::map(sets.len(), parallel::SLOW, |k| {
        let fit = ellipsoid(points, sets[k].0, &sets[k].1);
        let size = fit.count as f64;
        // The radius of the disc with these variances along its plane.
        let radius = (2.0 * (fit.axes.values[1] + fit.axes.values[2])).sqrt();
        ((fit.axes.values[0].max(0.0) * size / (size - 3.0)).sqrt(), radius)
    });
    if fits.is_empty() {
        return None;
    }
    let residual = quantile(fits.iter().map(|f| f.0).collect(), QUANTILE) / scale;
    let radius = quantile(fits.iter().map(|f| f.1).collect(), QUANTILE);
    (residual <= FLAT * radius).then_some(residual)
}

fn quantile(mut values: Vec<f64>, share: f64) -> f64 {
    let rank = (share * (values.len() - 1) as f64) as usize;
    *values.select_nth_unstable_by(rank, f64::total_cmp).1
}
