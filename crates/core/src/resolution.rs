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
/// The same for neighbourhoods by graph distance.
const WIDE_SAMPLES: usize = 2000;
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

/// What one of the sampled points tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sampled {
    /// Mean distance to the six nearest.
    near: f64,
    /// For each of [`FITS`] the residual and the radius of the plane fit; `None` for too few neighbours.
    fits: [Option<PlaneFit>; FITS.len()],
}

/// The residual of a plane fit, corrected for the three parameters of the plane, and the radius of its points.
pub(crate) type PlaneFit = [f64; 2];

impl Sampled {
    /// Point `i` with its list of nearest neighbours in order of distance.
    pub(crate) fn of(points: &[[f64; 3]], nearest: &Neighbors, i: usize) -> Sampled {
        let list = nearest.of(i);
        let fit = |(size, _)| list.get(..size - 1).map(|near| plane_fit(points, i, near));
        Sampled { near: mean_distance(points, i, six(list)), fits: FITS.map(fit) }
    }
}

/// The plane fit to what lies up to `hops` around point `i`; `None` for too few points.
pub(crate) fn wide_fit(
    points: &[[f64; 3]],
    graph: &Neighbors,
    i: usize,
    hops: usize,
    scratch: &mut Scratch,
) -> Option<PlaneFit> {
    let near = graph.hops(i, hops, scratch);
    (near.len() > 3).then(|| plane_fit(points, i, near))
}

/// The steps in which points are taken in canonical order, of `count` points: to sample them, and to fit wide neighbourhoods.
pub(crate) fn steps(count: usize) -> [usize; 2] {
    let step = count.div_ceil(SAMPLES).max(1);
    [step, step * count.div_ceil(step).div_ceil(WIDE_SAMPLES).max(1)]
}

impl Resolution {
    /// Estimates both from `nearest`, the lists of nearest neighbours in order of distance, and the graph made of them.
    ///
    /// Noise is the residual of local plane fits: the least among the flat ones of several sizes, as curvature only adds to it.
    /// If none of these is flat, neighbourhoods of growing graph distance are tried, and the first flat one counts.
    pub fn estimate(points: &[[f64; 3]], nearest: &Neighbors, graph: &Neighbors) -> Resolution {
        let [step, wide] = steps(points.len());
        let chosen = points.len().div_ceil(step);
        let samples = parallel::map(chosen, parallel::SLOW, |k| Sampled::of(points, nearest, k * step));
        let asked: Result<_, std::convert::Infallible> = Resolution::of_samples(&samples, |hops| {
            let few = points.len().div_ceil(wide);
            let fits = parallel::map_with(few, parallel::SLOW, |scratch: &mut Scratch, k| {
                wide_fit(points, graph, k * wide, hops, scratch)
            });
            Ok(fits.into_iter().flatten().collect())
        });
        asked.unwrap_or_else(|never| match never {})
    }

    /// As [`estimate`](Self::estimate), from every [`steps`]`[0]`-th point in canonical order; `wide` fits planes up to a graph distance
    /// around every [`steps`]`[1]`-th point and is asked only where no smaller neighbourhood is flat.
    ///
    /// # Errors
    /// Those of `wide`.
    pub(crate) fn of_samples<E>(
        samples: &[Sampled],
        mut wide: impl FnMut(usize) -> Result<Vec<PlaneFit>, E>,
    ) -> Result<Resolution, E> {
        let near: Vec<f64> = samples.iter().map(|s| s.near).collect();
        let raw = mean_without_strays(&near);
        let fits = |f: usize| samples.iter().filter_map(move |s| s.fits[f]);
        let small = (0..FITS.len()).filter_map(|f| flat_residual(fits(f).collect(), FITS[f].1));
        let mut noise = small.min_by(f64::total_cmp);
        for hops in 2..=WIDEST_HOPS {
            if noise.is_none() {
                noise = flat_residual(wide(hops)?, WIDE_QUANTILE);
            }
        }
        let noise = noise.unwrap_or(0.0);
        // Noise pushes neighbours apart: on planes, the six nearest lie at h (1 + 3/4 (sigma / h)^2), as measured.
        let mut spacing = raw;
        for _ in 0..8 {
            spacing = raw / (1.0 + 0.75 * (noise / spacing).powi(2).min(1.0));
        }
        Ok(Resolution { spacing, noise })
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

fn plane_fit(points: &[[f64; 3]], i: usize, near: &[u32]) -> PlaneFit {
    let fit = ellipsoid(points, i, near);
    let size = fit.count as f64;
    // The radius of the disc with these variances along its plane.
    let radius = (2.0 * (fit.axes.values[1] + fit.axes.values[2])).sqrt();
    [(fit.axes.values[0].max(0.0) * size / (size - 3.0)).sqrt(), radius]
}

/// The [`QUANTILE`] of the plane residuals divided by `scale`; `None` if the neighbourhoods are not flat.
fn flat_residual(fits: Vec<PlaneFit>, scale: f64) -> Option<f64> {
    if fits.is_empty() {
        return None;
    }
    let [residual, radius] = [0, 1].map(|k| quantile(fits.iter().map(|f| f[k]).collect(), QUANTILE));
    let residual = residual / scale;
    (residual <= FLAT * radius).then_some(residual)
}

fn quantile(mut values: Vec<f64>, share: f64) -> f64 {
    let rank = (share * (values.len() - 1) as f64) as usize;
    *values.select_nth_unstable_by(rank, f64::total_cmp).1
}
