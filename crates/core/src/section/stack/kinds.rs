//! What a run of contours has in common: the same outline, one that moves evenly, circles about one line.
//!
//! Any smooth object looks like an extrusion or a taper over a few close slices. What tells is how the run ends and how
//! its wall stands: a wall that is one begins and ends at once, and its slices have the slope that their outlines show.

use std::cell::RefCell;
use std::collections::BTreeMap;

use super::super::vec2::{along, distance, sub};
use super::Feature;
use super::profile::{Apart, Profile};

/// Fewest slices of a taper or revolution: two always agree, and a third may by chance.
pub(super) const LEAST: usize = 4;
/// How far an outline jumps, in tolerances, where an extrusion or a taper ends within a track.
const JUMP: f64 = 3.0;
/// How far the middle of a wall, and nine tenths of an extrusion's, may stand from the slope of the run, degrees: without
/// noise, and what noise (in spacings) adds.
const SLOPE_DEG: [(f64, f64); 2] = [(1.0, 8.0), (3.0, 12.0)];

/// Slopes to the axis, degrees, at which a wall clearly folds away and its contours are sure.
const SLANTED_DEG: (f64, f64) = (10.0, 75.0);

/// A kind with the last contour it reaches and its residual.
pub(super) type Reached = (usize, Feature, f64);

/// The contours of a track, ascending, with what is asked of pairs of them more than once.
pub(super) struct Kinds<'a> {
    all: &'a [&'a Profile],
    tolerance: f64,
    slopes: [f64; 2],
    pairs: RefCell<BTreeMap<(usize, usize), Apart>>,
}

impl<'a> Kinds<'a> {
    /// For outlines that agree within `tolerance`, in a cloud of this noise in spacings.
    pub(super) fn new(all: &'a [&'a Profile], tolerance: f64, noise: f64) -> Self {
        let slopes = SLOPE_DEG.map(|(clean, noisy)| clean + noisy * noise);
        Self { all, tolerance, slopes, pairs: RefCell::new(BTreeMap::new()) }
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

    /// An extrusion from `first` whose outline does not drift: where the track goes on, it jumps. On a dome or a cone
    /// neighbouring slices agree within the tolerance too, but go on changing as they did.
    pub(super) fn extrusion(&self, first: usize) -> Option<Reached> {
        let (last, residual) = reach(first, self.all.len(), 2, |last| self.same(first, last))?;
        let middle = (first + last) / 2;
        let settled = |end: usize, next: Option<usize>| {
            let Some(next) = next.filter(|&k| k < self.all.len()) else { return true };
            let (drift, jump) = (self.apart(end, middle), self.apart(next, middle));
            !jump.same(JUMP * self.tolerance) || drift.mean <= 0.2 * jump.mean
        };
        if !(self.upright(first, last)
            && settled(first, first.checked_sub(1))
            && settled(last, Some(last + 1)))
        {
            return None;
        }
        let own = &self.all[first..=last];
        let radii: Option<Vec<f64>> = own.iter().map(|p| p.round.map(|r| r.radius)).collect();
        let radius = radii.map(|r| r.iter().sum::<f64>() / r.len() as f64);
        Some((last, Feature::Extrusion { radius }, residual))
    }

    /// The greatest mean distance from the middle outline, if all are the same.
    fn same(&self, first: usize, last: usize) -> Option<f64> {
        let middle = (first + last) / 2;
        let mut worst = 0.0f64;
        for k in first..=last {
            let apart = self.apart(k, middle);
            if !apart.same(self.tolerance) {
                return None;
            }
            worst = worst.max(apart.mean);
        }
        Some(worst)
    }

    /// Whether the walls of a run stand at this angle to the axis, as their own slopes have it.
    fn stands(&self, first: usize, last: usize, angle_deg: f64) -> bool {
        self.median(first, last, |p| (p.draft_deg - angle_deg).abs()) <= self.slopes[0]
    }

    /// Whether the walls of a run stand along the axis all round: two slices at either side of a bore that lies along
    /// them show the same outline, but walls that lean.
    fn upright(&self, first: usize, last: usize) -> bool {
        self.stands(first, last, 0.0) && self.median(first, last, |p| p.steepest_deg) <= self.slopes[1]
    }

    /// The median over a run; slices beside a face across the axis may stray.
    fn median(&self, first: usize, last: usize, of: impl Fn(&Profile) -> f64) -> f64 {
        let mut all: Vec<f64> = self.all[first..=last].iter().map(|p| of(p)).collect();
        let middle = all.len() / 2;
        *all.select_nth_unstable_by(middle, f64::total_cmp).1
    }

    /// Where the wall of a run folds into a slanted one, at its `end` towards the two contours `beyond`: at what height the
    /// slanted wall meets the run's. The line of the slanted wall goes through both contours where they stand alike, else
    /// through the more slanted one by its own slope, as a slice at the very fold shows a mean of both walls.
    pub(super) fn fold(&self, end: usize, beyond: [Option<usize>; 2]) -> Option<f64> {
        let even = |p: &&&Profile| {
            let slope = p.draft_deg.abs();
            (SLANTED_DEG.0..SLANTED_DEG.1).contains(&slope) && p.steepest_deg - slope <= self.slopes[1]
        };
        let near = beyond.into_iter().flatten().filter_map(|k| self.all.get(k)).filter(even);
        let mut walls: Vec<&&Profile> = near.collect();
        walls.sort_by(|p, q| q.draft_deg.abs().total_cmp(&p.draft_deg.abs()));
        let own = self.all[end];
        let p = walls.first()?;
        let other = walls.get(1).filter(|q| (p.draft_deg - q.draft_deg).abs() <= self.slopes[1]);
        let slope = other.map_or(p.draft_deg.to_radians().tan(), |q| {
            (p.beyond(own) - q.beyond(own)) / (p.height - q.height)
        });
        let height = p.height - p.beyond(own) / slope;
        let share = (height - own.height) / (p.height - own.height);
        (0.0..1.0).contains(&share).then_some(height)
    }

    /// A taper from `first` that reaches farthest and ends at once, before `end`.
    pub(super) fn taper(&self, first: usize, end: usize) -> Option<Reached> {
        let (last, worst) = reach(first, end, LEAST, |last| self.blended(first, last))?;
        let (low, high) = (self.all[first], self.all[last]);
        let (span, moved) = (high.height - low.height, high.beyond(low));
        let angle_deg = (moved / span).atan().to_degrees();
        // Less than the extrusion's own tolerance to both sides is none.
        let tapers = moved.abs() >= 3.0 * self.tolerance && self.stands(first, last, angle_deg);
        if !tapers || !self.ends_at_once(first, last) {
            return None;
        }
        let own = &self.all[first..=last];
        let shrink = (high.area.sqrt() - low.area.sqrt()) / span;
        let apex = low.height - low.area.sqrt() / shrink;
        let radius = own.iter().all(|p| p.round.is_some()).then(|| low.round.map(|r| r.radius)).flatten();
        Some((last, Feature::Taper { angle_deg, apex, radius }, worst))
    }

    /// The greatest mean distance of an outline from where the first and the last, blended by height, would put it, if
    /// it is within the tolerance; the mean wall must not bend by more than half of that.
    fn blended(&self, first: usize, last: usize) -> Option<f64> {
        let (low, high) = (self.all[first], self.all[last]);
        let share = |p: &Profile| (p.height - low.height) / (high.height - low.height);
        let own = &self.all[first + 1..last];
        let bends =
            |p: &&&Profile| (p.beyond(low) - share(p) * high.beyond(low)).abs() > 0.5 * self.tolerance;
        if own.iter().any(|p| bends(&p)) {
            return None;
        }
        let pairs: Vec<([f64; 2], [f64; 2])> = low.sample().map(|p| (p, high.outline.nearest(p).0)).collect();
        let mut worst = 0.0f64;
        for p in own {
            let blend = pairs.iter().map(|&(a, b)| along(a, sub(b, a), share(p)));
            worst = worst.max(p.outline.mean_off(blend));
            if worst > self.tolerance {
                return None;
            }
        }
        Some(worst)
    }

    /// Whether the wall leaves the line of a taper at once at both of its ends: within two slices, as one may lie at
    /// the very edge. A curved wall leaves it slowly.
    fn ends_at_once(&self, first: usize, last: usize) -> bool {
        let (low, high) = (self.all[first], self.all[last]);
        let slope = high.beyond(low) / (high.height - low.height);
        let leaves = |k: usize| {
            let p = self.all[k];
            (p.beyond(low) - slope * (p.height - low.height)).abs() >= JUMP * self.tolerance
        };
        let outside = |next: &[usize]| next.is_empty() || next.iter().any(|&k| leaves(k));
        let below: Vec<usize> = (first.saturating_sub(2)..first).collect();
        let above: Vec<usize> = (last + 1..(last + 3).min(self.all.len())).collect();
        outside(&below) && outside(&above)
    }

    /// Circles about one line along the axis from `first`, before `end`.
    pub(super) fn revolution(&self, first: usize, end: usize) -> Option<Reached> {
        let (last, worst) = reach(first, end, LEAST, |last| self.concentric(first, last))?;
        let radii = self.all[first..=last].iter().filter_map(|p| p.round.map(|r| r.radius));
        let (least, most) = radii.fold((f64::INFINITY, 0.0f64), |(l, m), r| (l.min(r), m.max(r)));
        Some((last, Feature::Revolution { least, most }, worst))
    }

    fn concentric(&self, first: usize, last: usize) -> Option<f64> {
        let rounds: Option<Vec<_>> = self.all[first..=last].iter().map(|p| p.round).collect();
        let rounds = rounds?;
        let centre = rounds[rounds.len() / 2].centre;
        let worst = rounds.iter().map(|r| distance(r.centre, centre)).fold(0.0, f64::max);
        (worst <= self.tolerance).then_some(worst)
    }
}

/// The last contour, before `end`, up to which a test holds: doubling steps, then halving.
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
        match test(next) {
            Some(found) => (last, residual, step) = (next, found, 2 * step),
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
}
