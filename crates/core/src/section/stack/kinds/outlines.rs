//! The contours of a track, compared with each other.

use std::cell::RefCell;
use std::collections::BTreeMap;

use crate::section::stack::profile::{Apart, Profile};
use crate::section::stack::result::Feature;

/// Least jump of an outline at which an extrusion or a taper ends within a track, in tolerances.
pub(crate) const JUMP: f64 = 3.0;
/// Greatest angles between the slope of the run and the median slope of a wall, and the slope of nine tenths of an extrusion's
/// wall, degrees: without noise, and for each spacing of noise.
const SLOPE_DEG: [(f64, f64); 2] = [(1.0, 8.0), (3.0, 12.0)];
/// Distance from a fold up to which slices show a mean of both walls, spacings.
pub(crate) const FOLD: f64 = 1.2;
/// Distance from an edge beyond which it does not affect the slope of walls, spacings.
pub(crate) const CLEAR_OF_FOLD: f64 = 2.0 * FOLD;
/// Noise in spacings above which walls beside a face may seem to lean.
const NOISY_WALLS: f64 = 0.15;
/// Contours in a row that may stray within a run.
pub(crate) const ASTRAY: usize = 2;

/// The angle to the axis, degrees, up to which nine tenths of a wall may seem to stand along it, of a few slices.
pub(crate) fn upright_deg(noise: f64) -> f64 {
    1.5 * (SLOPE_DEG[1].0 + SLOPE_DEG[1].1 * noise)
}

/// Contours `first` to `last` of a track, the feature that they have in common, and how well.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reached {
    pub first: usize,
    pub last: usize,
    pub feature: Feature,
    pub residual: f64,
    /// Whether its contours alone show it too little, so that its ends must.
    pub doubtful: bool,
}

/// The contours of a track, ascending, with the distances of pairs that have been asked for.
pub(crate) struct Outlines<'a> {
    /// Ascending.
    pub all: &'a [&'a Profile],
    /// Greatest distance between outlines that agree.
    pub tolerance: f64,
    /// Of the cloud.
    pub spacing: f64,
    /// Greatest angles between the slope of the run and the median slope of a wall, and the slope of nine tenths of it, degrees.
    pub slopes: [f64; 2],
    /// Whether the planes of single points say little.
    pub noisy: bool,
    pairs: RefCell<BTreeMap<(usize, usize), Apart>>,
}

impl<'a> Outlines<'a> {
    /// For outlines that agree within `tolerance`, in a cloud of this spacing and this noise in spacings.
    pub(crate) fn new(all: &'a [&'a Profile], tolerance: f64, spacing: f64, noise: f64) -> Self {
        let slopes = SLOPE_DEG.map(|(clean, noisy)| clean + noisy * noise);
        Self {
            all,
            tolerance,
            spacing,
            slopes,
            noisy: noise > NOISY_WALLS,
            pairs: RefCell::new(BTreeMap::new()),
        }
    }

    pub(crate) fn apart(&self, i: usize, j: usize) -> Apart {
        let key = (i.min(j), i.max(j));
        if let Some(&known) = self.pairs.borrow().get(&key) {
            return known;
        }
        let found = self.all[key.0].apart(self.all[key.1], [0.0; 2]);
        self.pairs.borrow_mut().insert(key, found);
        found
    }

    /// Whether a contour beyond the end of a run still nearly shows the outline there.
    pub(crate) fn nearly(&self, end: usize, beyond: usize) -> bool {
        self.apart(end, beyond).same(JUMP * self.tolerance)
    }

    /// The median over a run.
    pub(crate) fn median(&self, first: usize, last: usize, of: impl Fn(usize) -> f64) -> f64 {
        let mut all: Vec<f64> = (first..=last).map(of).collect();
        let middle = all.len() / 2;
        *all.select_nth_unstable_by(middle, f64::total_cmp).1
    }

    /// The contours beyond an end of a run, away from it.
    pub(crate) fn outside(&self, end: usize, up: bool) -> Box<dyn Iterator<Item = usize>> {
        if up { Box::new(end + 1..self.all.len()) } else { Box::new((0..end).rev()) }
    }

    /// The number of contours of a run that may stray.
    pub(crate) fn spared(first: usize, last: usize) -> usize {
        (last + 1 - first) / 8
    }
}

/// The last contour, before `end`, up to which a test holds: doubling steps, then halving. A contour at which it fails is
/// stepped over once.
pub(crate) fn reach(
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
