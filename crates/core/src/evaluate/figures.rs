//! Figures of a score: shares within a tolerance, and distances.

/// Precision, recall and their harmonic mean, from 0 to 1; 0 if there is nothing to count.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Hits {
    /// Share of what was found that is right.
    pub precision: f64,
    /// Share of what is known that was found.
    pub recall: f64,
    /// Harmonic mean of both.
    pub f1: f64,
}

impl Hits {
    /// Of the two shares.
    pub(super) fn of(precision: f64, recall: f64) -> Self {
        let sum = precision + recall;
        Self { precision, recall, f1: if sum > 0.0 { 2.0 * precision * recall / sum } else { 0.0 } }
    }

    /// Of `right` things among those found and those known.
    pub(super) fn counted(right: usize, found: usize, known: usize) -> Self {
        Self::of(right as f64 / found.max(1) as f64, right as f64 / known.max(1) as f64)
    }

    /// Shares of distances that are at most the tolerance.
    pub(super) fn at(tolerance: f64, to_truth: &[f64], from_truth: &[f64]) -> Self {
        Self::of(share(to_truth, tolerance), share(from_truth, tolerance))
    }
}

/// The share of distances up to a tolerance; 0 without any.
pub(super) fn share(distances: &[f64], tolerance: f64) -> f64 {
    let near = distances.iter().filter(|&&d| d <= tolerance).count();
    near as f64 / distances.len().max(1) as f64
}

/// Distances in spacings; NaN if there is nothing to measure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distances {
    /// Mean distance along the length.
    pub mean: f64,
    /// The distance that 95 % of the length keeps within.
    pub p95: f64,
    /// Greatest distance.
    pub max: f64,
}

impl Distances {
    /// Of the finite ones.
    pub(super) fn of(all: &[f64]) -> Self {
        let mut finite: Vec<f64> = all.iter().copied().filter(|d| d.is_finite()).collect();
        let mean = finite.iter().sum::<f64>() / finite.len() as f64;
        finite.sort_by(f64::total_cmp);
        Self { mean, p95: quantile(&finite, 0.95), max: finite.last().copied().unwrap_or(f64::NAN) }
    }
}

/// The quantile of sorted numbers, linear between neighbours; NaN without any.
pub(super) fn quantile(sorted: &[f64], share: f64) -> f64 {
    let Some(last) = sorted.len().checked_sub(1) else { return f64::NAN };
    let at = share * last as f64;
    let (low, rest) = (at.floor() as usize, at.fract());
    let high = (low + 1).min(last);
    sorted[low] + (sorted[high] - sorted[low]) * rest
}
