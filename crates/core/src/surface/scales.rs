//! Scales: the spacing at every point, the unit of all lengths there.
//!
//! A scanner samples near surfaces a hundred times as densely as far ones, so that a single spacing for the whole scene is too
//! coarse for the near part and too fine for the far one. Where the sampling is nearly even, the mean spacing of the cloud is
//! used, as an estimate from few neighbours would only add its own error.

use crate::math::vec3::distance;
use crate::neighbors::Neighbors;
use crate::parallel;
use crate::resolution::Resolution;

/// Ratio of the local spacing to the mean: up to the first the mean is used, above the second the local spacing.
const EVEN: (f64, f64) = (1.25, 1.6);
/// The same ratios for denser places where the lesser spacing may be an error: where two sheets lie less than two spacings apart,
/// the nearest neighbours lie in both, and the spacing seems smaller than it is.
const DENSER: (f64, f64) = (1.6, 2.5);
/// Nearest neighbours whose mean distance is the spacing at a point.
const NEAREST: usize = 6;
/// Rounds of medians over the direct neighbours.
pub(super) const ROUNDS: usize = 2;

/// Spacing and noise of the cloud, and the spacing at every point if it differs from place to place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scales<'a> {
    /// Spacing and noise of the whole cloud.
    pub mean: Resolution,
    /// `(N)` spacing at each point, local frame; empty if the mean holds everywhere.
    spacing: &'a [f32],
}

impl From<Resolution> for Scales<'_> {
    fn from(mean: Resolution) -> Self {
        Scales { mean, spacing: &[] }
    }
}

impl<'a> Scales<'a> {
    /// The mean resolution with the spacing of every point, as [`spacings`] gives them.
    pub fn new(mean: Resolution, spacing: &'a [f32]) -> Self {
        Scales { mean, spacing }
    }

    /// Spacing and noise at point `i`.
    #[inline]
    pub fn at(&self, i: usize) -> Resolution {
        match self.spacing.get(i) {
            Some(&spacing) => Resolution { spacing: f64::from(spacing), ..self.mean },
            None => self.mean,
        }
    }

    /// The length below which no detail can be resolved at point `i`: see [`Resolution::unit`].
    #[inline]
    pub fn unit(&self, i: u32) -> f64 {
        self.at(i as usize).unit()
    }

    /// The spacing at point `i` for marks beside lines, which may not miss points for a spacing that only seems smaller: the mean
    /// of the cloud unless the place is clearly denser.
    pub fn cautious(&self, i: u32) -> f64 {
        let (own, mean) = (self.at(i as usize).spacing, self.mean.spacing);
        if own < mean { blended(own, mean, DENSER) } else { own }
    }

    /// The resolution at the densest of some points; the mean of none.
    pub fn finest(&self, points: &[u32]) -> Resolution {
        let finer = |a: Resolution, b: Resolution| if b.spacing < a.spacing { b } else { a };
        points.iter().map(|&i| self.at(i as usize)).reduce(finer).unwrap_or(self.mean)
    }

    /// The greatest cautious spacing at some points; the mean of the cloud for none.
    pub fn widest(&self, points: &[u32]) -> f64 {
        points.iter().map(|&i| self.cautious(i)).reduce(f64::max).unwrap_or(self.mean.spacing)
    }

    /// The mean of the spacings at some points.
    pub fn mean_spacing(&self, points: &[u32]) -> f64 {
        if self.spacing.is_empty() || points.is_empty() {
            return self.mean.spacing;
        }
        points.iter().map(|&i| self.at(i as usize).spacing).sum::<f64>() / points.len() as f64
    }

    /// The mean unit of two points.
    #[inline]
    pub fn between(&self, i: u32, j: u32) -> f64 {
        if self.spacing.is_empty() { self.mean.unit() } else { 0.5 * (self.unit(i) + self.unit(j)) }
    }
}

/// `(N)` mean distance of every point from its six nearest. `nearest` are the lists of nearest neighbours in order of distance.
pub(super) fn raw(points: &[[f64; 3]], nearest: &Neighbors) -> Vec<f32> {
    let own = |i: usize| {
        let six = &nearest.of(i)[..nearest.of(i).len().min(NEAREST)];
        let sum: f64 = six.iter().map(|&j| distance(points[i], points[j as usize])).sum();
        (sum / six.len().max(1) as f64) as f32
    };
    parallel::map(points.len(), parallel::QUICK, own)
}

/// `(N)` spacing at every point: the mean distance from its six nearest, smoothed over the neighbours in the lists.
pub fn spacings(points: &[[f64; 3]], nearest: &Neighbors) -> Vec<f32> {
    smoothed(raw(points, nearest), nearest)
}

/// Takes medians over the neighbours, twice.
pub(super) fn smoothed(mut spacing: Vec<f32>, nearest: &Neighbors) -> Vec<f32> {
    for _ in 0..ROUNDS {
        spacing = parallel::map_with(spacing.len(), parallel::QUICK, |near: &mut Vec<f32>, i| {
            near.clear();
            near.extend(nearest.of(i).iter().map(|&j| spacing[j as usize]).chain([spacing[i]]));
            let middle = near.len() / 2;
            *near.select_nth_unstable_by(middle, f32::total_cmp).1
        });
    }
    spacing
}

/// The spacings, with the mean of the cloud where they differ little from it.
pub fn evened(spacing: &[f32], mean: Resolution) -> Vec<f32> {
    parallel::map(spacing.len(), parallel::QUICK, |i| {
        blended(f64::from(spacing[i]), mean.spacing, EVEN) as f32
    })
}

/// The spacing at a place: the mean up to a ratio of the first of `band` between it and `raw`, `raw` from the second on, and a
/// blend in between.
fn blended(raw: f64, mean: f64, band: (f64, f64)) -> f64 {
    let ratio = (raw / mean).max(mean / raw);
    let share = ((ratio - band.0) / (band.1 - band.0)).clamp(0.0, 1.0);
    let share = if share.is_nan() { 0.0 } else { share };
    (share * raw.max(f64::MIN_POSITIVE).ln() + (1.0 - share) * mean.ln()).exp()
}
