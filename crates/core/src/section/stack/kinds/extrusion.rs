//! Runs of the same outline.

use super::outlines::{ASTRAY, CLEAR_OF_FOLD, FOLD, JUMP, Outlines, Reached};
use crate::section::stack::result::Feature;

/// Share of a run's contours that must be circles for it to be round.
const ROUND_SHARE: f64 = 0.6;
/// Fewest slices, and least height in spacings, over which a constant outline shows upright walls.
const UPRIGHT_SLICES: usize = 3;
const UPRIGHT_HEIGHT: f64 = 4.0;
/// Fewer slices show little of how walls stand.
const FEW_SLICES: usize = 5;

impl Outlines<'_> {
    /// All extrusions of the track, ascending.
    pub(crate) fn extrusions(&self) -> Vec<Reached> {
        let mut found = Vec::new();
        let (mut free, mut reference) = (0, 0);
        while reference < self.all.len() {
            let (first, last, middle) = self.alike(reference, free);
            if let Some(run) = self.extrusion(first, last, middle) {
                found.push(run);
                free = last + 1;
                reference = free;
            } else {
                reference += (last.saturating_sub(reference) / 2).max(1);
            }
        }
        found
    }

    /// The contours, from `free` on, that show the outline of `reference` or of one among them that more agree with.
    fn alike(&self, reference: usize, free: usize) -> (usize, usize, usize) {
        let around = |k: usize| (self.stretch(k, free, false), self.stretch(k, free, true), k);
        let mut best = around(reference);
        for share in [2, 4, 3] {
            let (first, last, _) = best;
            let other = around(first + (last - first) * (share - 1) / share);
            if other.1 - other.0 > last - first {
                best = other;
            }
        }
        best
    }

    /// The farthest contour that shows the outline, going one way; some may stray in between.
    fn stretch(&self, reference: usize, free: usize, up: bool) -> usize {
        let (mut last, mut astray) = (reference, 0);
        for k in self.outside(reference, up).take_while(|&k| k >= free) {
            let apart = self.apart(reference, k);
            if apart.same(self.tolerance) {
                (last, astray) = (k, 0);
            } else if astray < ASTRAY && apart.same(JUMP * self.tolerance) {
                astray += 1;
            } else {
                break;
            }
        }
        last
    }

    /// An extrusion whose outline does not drift: where the track goes on, it jumps. On a dome or a cone neighbouring
    /// slices agree within the tolerance too, but go on changing as they did.
    fn extrusion(&self, first: usize, last: usize, middle: usize) -> Option<Reached> {
        let good = |&k: &usize| self.apart(k, middle).same(self.tolerance);
        let own: Vec<usize> = (first..=last).filter(good).collect();
        let few = last == first || own.len() + Self::spared(first, last).max(1) < last + 1 - first;
        let sides = [false, true];
        if few || !sides.iter().all(|&up| self.settled(&own, middle, up)) {
            return None;
        }
        let doubtful = !self.upright(first, last);
        if doubtful && !self.upright_within(first, last) {
            return None;
        }
        let radii: Vec<f64> = own.iter().filter_map(|&k| self.all[k].round.map(|r| r.radius)).collect();
        let round = radii.len() as f64 >= ROUND_SHARE * own.len() as f64;
        let radius = round.then(|| radii.iter().sum::<f64>() / radii.len() as f64);
        let residual = own.iter().map(|&k| self.apart(k, middle).mean).fold(0.0, f64::max);
        Some(Reached { first, last, feature: Feature::Extrusion { radius }, residual, doubtful })
    }

    /// Whether the track jumps where the run ends, or the run has not drifted before: its outer contours, without those
    /// beside a fold, lie no farther off than others, measured by how far those outside do.
    fn settled(&self, own: &[usize], middle: usize, up: bool) -> bool {
        let end = if up { own[own.len() - 1] } else { own[0] };
        let Some(next) = self.outside(end, up).next() else { return true };
        let jump = self.apart(next, middle);
        if !jump.same(JUMP * self.tolerance) {
            return true;
        }
        let inside = |&&k: &&usize| {
            (self.all[k].height - self.all[end].height).abs() >= FOLD * self.spacing && k != middle
        };
        let clear: Vec<usize> = own.iter().filter(inside).copied().collect();
        let others = if clear.len() >= 4 { &clear } else { own };
        let mut offs: Vec<f64> = others.iter().map(|&k| self.apart(k, middle).mean).collect();
        // Nearest to the end come first.
        if up {
            offs.reverse();
        }
        let outer = &offs[..2.min(offs.len())];
        let outer = outer.iter().sum::<f64>() / outer.len() as f64;
        offs.sort_by(f64::total_cmp);
        let usual = if clear.len() >= 4 { offs[offs.len() / 2] } else { 0.0 };
        (outer - usual).max(0.0) <= 0.2 * (jump.mean - usual)
    }

    /// Whether the walls of a run stand along the axis all round: two slices at either side of a bore that lies along
    /// them show the same outline, but walls that lean. Over many slices walls may seem to lean from noise, if they do
    /// so alike throughout; about the widest slice of a sphere they lean the more, the farther from it.
    fn upright(&self, first: usize, last: usize) -> bool {
        let inner = self.clear(first, last);
        let long = inner.len() >= UPRIGHT_SLICES && {
            let (low, high) = (inner[0], inner[inner.len() - 1]);
            let quarter = (high - low) / 4;
            let alike = |of: &dyn Fn(usize) -> f64| {
                let middle = self.median(low + quarter, high - quarter, of);
                let ends = [(low, low + quarter), (high - quarter, high)].map(|(a, b)| self.median(a, b, of));
                ends[0].min(ends[1]) - middle <= 0.5 * self.slopes[0]
            };
            let tall = self.all[high].height - self.all[low].height >= UPRIGHT_HEIGHT * self.spacing;
            tall && alike(&|k| self.draft(k)) && alike(&|k| self.steepest(k))
        };
        // Beside a face the planes of single points stray, and of few slices most may lie there.
        let few = self.noisy && last + 1 - first < FEW_SLICES && self.edged(first, last);
        let (slack, steep_slack) = if long { (2.0, 2.0) } else { (1.0, if few { 1.5 } else { 1.0 }) };
        let steep = if few && last == first + 1 {
            self.steepest(first).min(self.steepest(last))
        } else {
            self.median(first, last, |k| self.steepest(k))
        };
        let draft = self.median(first, last, |k| self.draft(k));
        draft <= slack * self.slopes[0] && steep <= steep_slack * self.slopes[1]
    }

    /// Whether the walls of a run between two edges stand along the axis within it: under noise most of a short one lies
    /// beside them.
    fn upright_within(&self, first: usize, last: usize) -> bool {
        let half = (last - first) / 2;
        let clear = self.clear(first, last);
        let own = if clear.is_empty() { (first + half..=last - half).collect() } else { clear };
        let (low, high) = (own[0], own[own.len() - 1]);
        let slack = if self.noisy { 1.5 } else { 1.0 };
        self.edged(first, last)
            && self.median(low, high, |k| self.draft(k)) <= self.slopes[0]
            && self.median(low, high, |k| self.steepest(k)) <= slack * self.slopes[1]
    }

    /// The contours of a run that lie clear of its ends: beside a face or a fold walls lean anyhow.
    fn clear(&self, first: usize, last: usize) -> Vec<usize> {
        let clear = |k: &usize| {
            let height = self.all[*k].height;
            (height - self.all[first].height).min(self.all[last].height - height)
                >= CLEAR_OF_FOLD * self.spacing
        };
        (first..=last).filter(clear).collect()
    }

    fn draft(&self, k: usize) -> f64 {
        self.all[k].draft_deg.abs()
    }

    fn steepest(&self, k: usize) -> f64 {
        self.all[k].steepest_deg
    }

    /// Whether both ends jump.
    fn edged(&self, first: usize, last: usize) -> bool {
        self.jumps(first, false) && self.jumps(last, true)
    }

    /// Whether the track ends or shows clearly another outline beyond an end.
    fn jumps(&self, end: usize, up: bool) -> bool {
        self.outside(end, up).next().is_none_or(|next| !self.nearly(end, next))
    }
}
