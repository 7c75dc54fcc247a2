//! What a run of contours has in common: the same outline, one that moves evenly, circles about one line.
//!
//! Any smooth object looks like an extrusion or a taper over a few close slices. What tells is how the run ends and how
//! its wall stands: a wall that is one begins and ends at once, and its slices have the slope that their outlines show.
//! A slice may stray where it cuts a face, and does so beside a fold; a few that stray little break no run.

mod extrusion;
mod revolution;
mod taper;

use std::cell::RefCell;
use std::collections::BTreeMap;

use super::Feature;
use super::profile::{Apart, Profile};

/// How far an outline jumps, in tolerances, where an extrusion or a taper ends within a track.
const JUMP: f64 = 3.0;
/// How far the middle of a wall, and nine tenths of an extrusion's, may stand from the slope of the run, degrees: without
/// noise, and what noise (in spacings) adds.
const SLOPE_DEG: [(f64, f64); 2] = [(1.0, 8.0), (3.0, 12.0)];
/// How far beside a fold, in spacings, slices show a mean of both walls.
const FOLD: f64 = 1.2;
/// How far from an edge, in spacings, walls do not lean from it.
pub(super) const CLEAR: f64 = 2.0 * FOLD;
/// Noise in spacings above which walls beside a face may seem to lean.
const NOISY: f64 = 0.15;
/// Contours in a row that may stray within a run.
const ASTRAY: usize = 2;

/// The angle to the axis, degrees, up to which nine tenths of a wall may seem to stand along it, of a few slices.
pub(super) fn upright_deg(noise: f64) -> f64 {
    1.5 * (SLOPE_DEG[1].0 + SLOPE_DEG[1].1 * noise)
}

/// Contours `first` to `last` of a track, what they have in common, and how well.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reached {
    pub first: usize,
    pub last: usize,
    pub feature: Feature,
    pub residual: f64,
    /// Whether too little of it shows what it is, so that its ends must.
    pub doubtful: bool,
}

/// The contours of a track, ascending, with what is asked of pairs of them more than once.
pub(super) struct Kinds<'a> {
    all: &'a [&'a Profile],
    tolerance: f64,
    spacing: f64,
    slopes: [f64; 2],
    /// Whether the planes of single points say little.
    noisy: bool,
    pairs: RefCell<BTreeMap<(usize, usize), Apart>>,
}

impl<'a> Kinds<'a> {
    /// For outlines that agree within `tolerance`, in a cloud of this spacing and this noise in spacings.
    pub(super) fn new(all: &'a [&'a Profile], tolerance: f64, spacing: f64, noise: f64) -> Self {
        let slopes = SLOPE_DEG.map(|(clean, noisy)| clean + noisy * noise);
        Self { all, tolerance, spacing, slopes, noisy: noise > NOISY, pairs: RefCell::new(BTreeMap::new()) }
    }

    /// The runs of the track, ascending. Extrusions come first, as they are the strictest, then tapers between them, then
    /// revolutions in what is left.
    pub(super) fn runs(&self) -> Vec<Reached> {
        let mut found = self.extrusions();
        for kind in [Self::tapers, Self::revolutions] {
            let more: Vec<Reached> =
                self.gaps(&found).into_iter().flat_map(|(first, end)| kind(self, first, end)).collect();
            found.extend(more);
            found.sort_by_key(|r| r.first);
        }
        found
    }

    /// The stretches (first, end) that runs leave.
    fn gaps(&self, runs: &[Reached]) -> Vec<(usize, usize)> {
        let firsts = std::iter::once(0).chain(runs.iter().map(|r| r.last + 1));
        let ends = runs.iter().map(|r| r.first).chain([self.all.len()]);
        firsts.zip(ends).filter(|(first, end)| first < end).collect()
    }

    fn apart(&self, i: usize, j: usize) -> Apart {
        let key = (i.min(j), i.max(j));
        if let Some(&known) = self.pairs.borrow().get(&key) {
            return known;
        }
        let found = self.all[key.0].apart(self.all[key.1], [0.0; 2]);
        self.pairs.borrow_mut().insert(key, found);
        found
    }

    /// Whether a contour beyond the end of a run still nearly shows the outline there.
    pub(super) fn nearly(&self, end: usize, beyond: usize) -> bool {
        self.apart(end, beyond).same(JUMP * self.tolerance)
    }

    /// The median over a run.
    fn median(&self, first: usize, last: usize, of: impl Fn(usize) -> f64) -> f64 {
        let mut all: Vec<f64> = (first..=last).map(of).collect();
        let middle = all.len() / 2;
        *all.select_nth_unstable_by(middle, f64::total_cmp).1
    }

    /// The contours beyond an end of a run, away from it.
    fn outside(&self, end: usize, up: bool) -> Box<dyn Iterator<Item = usize>> {
        if up { Box::new(end + 1..self.all.len()) } else { Box::new((0..end).rev()) }
    }

    /// How many contours of a run may stray.
    fn spared(first: usize, last: usize) -> usize {
        (last + 1 - first) / 8
    }
}

/// The last contour, before `end`, up to which a test holds: doubling steps, then halving. A contour at which it fails is
/// stepped over once.
fn reach(
    first: usize,
    end: usize,
    least: usize,
    test: impl Fn(usize) -> Option<f64>,
) -> Option<(usize, f64)> {
    let mut last = first + least - 1;
    if last >= end {
        return None;
    }
    let mut residual = test(last)?;
    let (mut step, mut bad) = (least, end);
    while last + 1 < bad {
        let next = (last + step).min(bad - 1);
        let beside = [Some(next), (next + 1 < bad).then_some(next + 1)];
        match beside.into_iter().flatten().find_map(|k| Some((k, test(k)?))) {
            Some((next, found)) => (last, residual, step) = (next, found, 2 * step),
            None => (bad, step) = (next, (step / 2).max(1)),
        }
    }
    Some((last, residual))
}

#[cfg(test)]
mod tests {
    use super::reach;

    #[test]
    fn the_farthest_contour_is_reached() {
        for limit in 4..40 {
            let found = reach(3, 30, 2, |last| (last < limit).then_some(last as f64));
            let wanted = (limit.min(30) > 4).then(|| limit.min(30) - 1);
            assert_eq!(found.map(|f| f.0), wanted, "{limit}");
        }
    }

    #[test]
    fn a_contour_that_strays_is_stepped_over() {
        for astray in 5..29 {
            let found = reach(3, 30, 2, |last| (last != astray).then_some(0.0));
            assert_eq!(found.map(|f| f.0), Some(29), "{astray}");
        }
    }
}
