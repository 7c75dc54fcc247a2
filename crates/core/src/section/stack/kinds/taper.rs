//! Runs of an outline that moves evenly with height.

use super::outlines::{FOLD, JUMP, Outlines, Reached, reach};
use crate::math::vec2::{cross, sub, unit};
use crate::section::stack::pairs::{Pair, blend, pairs};
use crate::section::stack::profile::Profile;
use crate::section::stack::result::Feature;

/// Fewest slices of a taper that may end as its outline leaves it; fewer must end where the wall folds.
const FEWEST_SLICES: usize = 4;
/// Least fold at the ends of a taper, as a multiple of its own bend continued to there, or of the slope taken for straight.
const SHARP: f64 = 4.0;
/// Greatest difference between the slopes of the two halves of a taper, as a multiple of the slope that counts as straight.
const BEND: f64 = 1.5;
/// Radius in spacings below which a contour says little.
const SMALL_RADIUS: f64 = 3.0;

impl Outlines<'_> {
    /// The tapers among contours `first` to before `end`, ascending.
    pub(crate) fn tapers(&self, mut first: usize, end: usize) -> Vec<Reached> {
        let mut found = Vec::new();
        let mut here = self.taper(first, end);
        while first + 1 < end {
            // The first contour may lie beside a fold.
            let next = self.taper(first + 1, end);
            let best = match (here, next) {
                (Some(h), Some(n)) if n.last > h.last + 1 => Some(n),
                (h, _) => h,
            };
            first = best.map_or(first + 1, |b| b.last + 1);
            here = if best.is_some() { self.taper(first, end) } else { next };
            found.extend(best);
        }
        found
    }

    /// A taper from `first` that reaches farthest and ends at once, before `end`.
    fn taper(&self, first: usize, end: usize) -> Option<Reached> {
        if first + 1 >= end {
            return None;
        }
        let (last, residual) = reach(first, end, 2, |last| self.blended(first, last))?;
        let (low, high) = (self.all[first], self.all[last]);
        let (span, moved) = (high.height - low.height, high.beyond(low));
        let angle_deg = (moved / span).atan().to_degrees();
        let sides = [(first, false), (last, true)];
        let short = last + 1 - first < FEWEST_SLICES;
        let folds = sides.map(|(end, up)| self.folds(first, last, end, up));
        let ends = if short {
            !folds.contains(&Some(false))
        } else {
            sides.iter().all(|&(end, up)| self.leaves(first, last, end, up))
        };
        // A smaller move is within an extrusion's own tolerance to both sides.
        let moves = self.apart(first, last).mean >= 3.0 * self.tolerance;
        if !moves || !ends || !self.leans(first, last, short) {
            return None;
        }
        let feature = Feature::Taper { angle_deg, apex: f64::NAN, radius: None };
        // Nothing else of the track tells of its ends.
        let doubtful = short && folds == [None; 2];
        Some(Reached { first, last, feature, residual, doubtful })
    }

    /// The greatest mean distance of an outline from where the first and the last, blended by height, would put it, if
    /// it is within the tolerance; with its sign it must be within half of that, as a wall that bends does so to one side.
    fn blended(&self, first: usize, last: usize) -> Option<f64> {
        let pairs = pairs(self.all[first], self.all[last], self.tolerance);
        let mut astray = Self::spared(first, last);
        let mut worst = 0.0f64;
        for k in first + 1..last {
            let (off, bend) = self.off_blend(&pairs, first, last, k);
            if bend.abs() <= 0.5 * self.tolerance && off <= self.tolerance {
                worst = worst.max(off);
            } else if astray > 0 && off <= JUMP * self.tolerance {
                astray -= 1;
            } else {
                return None;
            }
        }
        Some(worst)
    }

    /// Distance of a contour from the blend of two others by height: its mean, and its signed mean, positive for the outside.
    fn off_blend(&self, pairs: &[Pair], first: usize, last: usize, k: usize) -> (f64, f64) {
        let (low, high, p) = (self.all[first], self.all[last], self.all[k]);
        let share = (p.height - low.height) / (high.height - low.height);
        let blend = blend(pairs, share);
        let turn = low.signed_area.signum();
        let (mut sum, mut signed) = (0.0, 0.0);
        for (j, &at) in blend.iter().enumerate() {
            let (foot, off) = p.outline.nearest(at);
            // Right of a counter-clockwise contour is outside.
            let side = -turn * cross(sub(blend[(j + 1) % blend.len()], at), sub(foot, at));
            sum += off;
            signed += off * side.signum();
        }
        let n = blend.len().max(1) as f64;
        (sum / n, signed / n)
    }

    /// Whether the walls of the slices lean as the outlines move: of a short run those of all slices, but for one at a fold.
    fn leans(&self, first: usize, last: usize, short: bool) -> bool {
        let slopes = self.slopes_between(first, last);
        if !short {
            return self.lean_as(first, last, slopes, false);
        }
        let above_fold = (first + usize::from(self.mixed(first, false, slopes)), last);
        let below_fold = (first, last - usize::from(self.mixed(last, true, slopes)));
        [above_fold, below_fold].into_iter().any(|(first, last)| self.lean_as(first, last, slopes, true))
    }

    /// Whether an end of a run lies so near to a fold that it shows a mean of its wall and of the straight one beyond.
    fn mixed(&self, end: usize, up: bool, (middle, _): (f64, f64)) -> bool {
        let mut outside = self.outside(end, up);
        let (Some(beyond), Some(next)) = (outside.next(), outside.next()) else { return false };
        let straight = (self.all[beyond].draft_deg - self.all[next].draft_deg).abs() <= self.slopes[0];
        let [own, other] = [end, beyond].map(|k| self.all[k].draft_deg - middle);
        let (near, far) = (self.all[end], self.all[beyond]);
        let rise = far.height - near.height;
        let [here, there] = [middle, far.draft_deg].map(|lean| lean.to_radians().tan());
        // Where the walls meet, if both are straight, in heights of the end.
        let fold = (far.beyond(near) - there * rise) / (here - there) * rise.signum();
        straight && (0.0..=0.5).contains(&(own / other)) && (0.0..=FOLD * self.spacing).contains(&fold)
    }

    /// Whether walls lean by the angles given, [`Outlines::slopes_between`]: where they lean most, and in the middle too unless
    /// only a part of the outline moves.
    fn lean_as(&self, first: usize, last: usize, (middle, most): (f64, f64), all: bool) -> bool {
        let whole = most - middle.abs() <= self.slopes[1];
        let steep = |k: usize| self.all[k].steepest_deg;
        let lean = |k: usize| if whole { self.all[k].draft_deg } else { middle };
        let off = |k: usize| {
            ((steep(k) - most).abs() / self.slopes[1]).max((lean(k) - middle).abs() / self.slopes[0])
        };
        // A curved wall leans ever more.
        let half = (first + last) / 2;
        let bends = |of: &dyn Fn(usize) -> f64| {
            (self.median(first, half, of) - self.median((half + 1).min(last), last, of)).abs()
        };
        if bends(&steep) > BEND * self.slopes[0] || bends(&lean) > BEND * self.slopes[0] {
            return false;
        }
        if all { (first..=last).all(|k| off(k) <= 1.5) } else { self.median(first, last, off) <= 1.0 }
    }

    /// The median angle by which the outline moves between two contours, and the one, of either sign, that nine tenths
    /// of it stay under; degrees.
    fn slopes_between(&self, first: usize, last: usize) -> (f64, f64) {
        let (low, high) = (self.all[first], self.all[last]);
        let pairs = pairs(self.all[first], self.all[last], self.tolerance);
        let points: Vec<[f64; 2]> =
            pairs.iter().map(|p| if low.area >= high.area { p.0 } else { p.1 }).collect();
        let rise = high.height - low.height;
        let turn = low.signed_area.signum();
        let slope = |k: usize| {
            let tangent = unit(sub(points[(k + 1) % points.len()], points[k]));
            // Right of a counter-clockwise contour is outside.
            let out = -turn * cross(tangent, sub(pairs[k].1, pairs[k].0));
            (out / rise).atan().to_degrees()
        };
        let mut slopes: Vec<f64> = (0..points.len()).map(slope).collect();
        let at = |slopes: &mut Vec<f64>, share: f64| {
            let k = ((slopes.len() - 1) as f64 * share) as usize;
            *slopes.select_nth_unstable_by(k, f64::total_cmp).1
        };
        let middle = at(&mut slopes, 0.5);
        slopes.iter_mut().for_each(|s| *s = s.abs());
        (middle, at(&mut slopes, 0.9))
    }

    /// Contours beyond an end that show how a taper ends: clear of the fold, and not too small.
    fn beyond(&self, end: usize, up: bool) -> Vec<usize> {
        let own = self.all[end].height;
        let tells = |&k: &usize| {
            let p = self.all[k];
            let small = (p.area / std::f64::consts::PI).sqrt() < SMALL_RADIUS * self.spacing;
            (p.height - own).abs() >= FOLD * self.spacing && !small
        };
        self.outside(end, up).filter(tells).take(2).collect()
    }

    /// Whether the wall leaves the line of a taper at once at an end of it: within two slices, as one may lie at the
    /// very edge. A curved wall leaves it slowly.
    fn leaves(&self, first: usize, last: usize, end: usize, up: bool) -> bool {
        let outside = self.beyond(end, up);
        if outside.is_empty() {
            return true;
        }
        let pairs = pairs(self.all[first], self.all[last], self.tolerance);
        let leaves = |&k: &usize| self.off_blend(&pairs, first, last, k).0 >= JUMP * self.tolerance;
        outside.iter().any(leaves) || self.folds(first, last, end, up) == Some(true)
    }

    /// Whether the wall beyond an end leans otherwise, by far more than it would if it went on bending as it does within
    /// the run; `None` where nothing lies beyond it.
    fn folds(&self, first: usize, last: usize, end: usize, up: bool) -> Option<bool> {
        let (low, high) = (self.all[first], self.all[last]);
        let lean: [fn(&Profile) -> f64; 2] = [|p| p.draft_deg, |p| p.steepest_deg];
        let middle = 0.5 * (low.height + high.height);
        let other = |&k: &usize| {
            let p = self.all[k];
            let far = (p.height - middle).abs() / (high.height - low.height);
            lean.iter().any(|lean| {
                let own = self.median(first, last, |k| lean(self.all[k]));
                let bend = (lean(high) - lean(low)).abs().max(self.slopes[0]);
                (lean(p) - own).abs() >= SHARP * bend * far.max(1.0)
            })
        };
        let outside = self.beyond(end, up);
        (!outside.is_empty()).then(|| outside.iter().any(other))
    }
}
