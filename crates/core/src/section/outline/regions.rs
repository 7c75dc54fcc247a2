//! Regions of a contour between neighbouring feature points, split until their points lie near the curve (Kyriazis et al.,
//! sections 3 and 4, step 4).
//!
//! The region of a point is decided by its neighbours (figure 5): points are ordered along the band, and a region is the run of
//! points between two feature points, however near another part of the curve may pass. The order comes from the region
//! assignment in `contour/assign.rs`.

use crate::math::convex_hull::convex_hull;
use crate::math::vec2::onto;
use crate::section::contour::band::Band;

/// A feature point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct FeatureMark {
    /// Its index in the marks of the band.
    pub mark: usize,
    /// The round that found it, 0 for the first feature points: the depth of the regions that were split for it.
    pub round: u32,
}

/// Starts from the hull (closed) or the ends (open) and splits regions by `pick` until they are near their chords; feature points
/// ascending by mark. `pick` is given a region's marks, first and last feature included, and the round, and returns some of them.
pub(crate) fn refine(
    band: &Band,
    threshold: f64,
    mut pick: impl FnMut(&[usize], u32) -> Vec<usize>,
) -> Vec<FeatureMark> {
    let n = band.marks.len();
    let first_of = |mark| FeatureMark { mark, round: 0 };
    if n < 3 {
        return (0..n).map(first_of).collect();
    }
    let all: Vec<usize> = (0..n).collect();
    let mut found = if band.chain.closed { convex_hull(&all, |m| band.marks[m].raw) } else { vec![0, n - 1] };
    found.sort_unstable();
    let seam = if band.chain.closed { found.len() } else { found.len() - 1 };
    let mut open: Vec<(usize, usize, u32)> =
        (0..seam).map(|k| (found[k], found[(k + 1) % found.len()], 1)).collect();
    let mut found: Vec<FeatureMark> = found.into_iter().map(first_of).collect();
    while let Some((first, last, round)) = open.pop() {
        let region = between(first, last, n);
        if region.len() < 4 || mean_distance(band, &region) <= threshold {
            continue;
        }
        let mut inner = positions(&region, &pick(&region, round));
        if inner.is_empty() {
            inner.push(farthest(band, &region));
        }
        found.extend(inner.iter().map(|&k| FeatureMark { mark: region[k], round }));
        inner.insert(0, 0);
        inner.push(region.len() - 1);
        open.extend(inner.windows(2).map(|w| (region[w[0]], region[w[1]], round + 1)));
    }
    found.sort_unstable();
    found.dedup_by_key(|feature| feature.mark);
    found
}

/// The marks from one feature to the next, both included, over the seam if need be.
fn between(first: usize, last: usize, n: usize) -> Vec<usize> {
    if first < last { (first..=last).collect() } else { (first..n).chain(0..=last).collect() }
}

/// The positions of the picked marks in a region, ascending, without its two ends.
pub(crate) fn positions(region: &[usize], picked: &[usize]) -> Vec<usize> {
    let n = region.len();
    // A region is a run of consecutive marks, cut at most once by the seam.
    let wrap = region.iter().position(|&m| m == 0).unwrap_or(0);
    let place = |mark: usize| if mark >= region[0] { mark - region[0] } else { wrap + mark };
    let mut inner: Vec<usize> = picked.iter().map(|&m| place(m)).filter(|&k| k > 0 && k < n - 1).collect();
    inner.sort_unstable();
    inner.dedup();
    inner
}

/// Mean distance of the points of a region from its chord: the paper's `avg_dist`, which is compared with its `e`.
fn mean_distance(band: &Band, region: &[usize]) -> f64 {
    let (a, b) = chord(band, region);
    let sum: f64 = region.iter().map(|&m| onto(a, b, band.marks[m].raw).1).sum();
    sum / region.len() as f64
}

/// The position in the region of the point farthest from its chord, never one of the two ends.
pub(crate) fn farthest(band: &Band, region: &[usize]) -> usize {
    let (a, b) = chord(band, region);
    let mut best = (-1.0, 1);
    for (k, &m) in region.iter().enumerate().take(region.len() - 1).skip(1) {
        let off = onto(a, b, band.marks[m].raw).1;
        if off > best.0 {
            best = (off, k);
        }
    }
    best.1
}

/// The two feature points of a region.
pub(crate) fn chord(band: &Band, region: &[usize]) -> ([f64; 2], [f64; 2]) {
    let at = |m: usize| band.marks[m].raw;
    (at(region[0]), at(region[region.len() - 1]))
}
