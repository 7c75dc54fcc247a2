//! Runs of circles about one line along the axis.

use super::super::super::vec2::distance;
use super::{Feature, Kinds, Reached, reach};

/// Fewest slices of a revolution: two always agree, and a third may by chance.
const LEAST: usize = 4;

impl Kinds<'_> {
    /// The revolutions among contours `first` to before `end`, ascending.
    pub(super) fn revolutions(&self, mut first: usize, end: usize) -> Vec<Reached> {
        let mut found = Vec::new();
        while first < end {
            let run = self.revolution(first, end);
            first = run.map_or(first + 1, |r| r.last + 1);
            found.extend(run);
        }
        found
    }

    fn revolution(&self, first: usize, end: usize) -> Option<Reached> {
        let (last, residual) = reach(first, end, LEAST, |last| self.concentric(first, last))?;
        let radii = self.all[first..=last].iter().filter_map(|p| p.round.map(|r| r.radius));
        let (least, most) = radii.fold((f64::INFINITY, 0.0f64), |(l, m), r| (l.min(r), m.max(r)));
        Some(Reached { first, last, feature: Feature::Revolution { least, most }, residual })
    }

    /// The greatest distance of a centre from the middle one; the first and the last must be circles, and nearly all.
    fn concentric(&self, first: usize, last: usize) -> Option<f64> {
        let rounds: Vec<_> = self.all[first..=last].iter().filter_map(|p| p.round).collect();
        let (own, ends) = (last + 1 - first, [first, last].map(|k| self.all[k].round.is_some()));
        if rounds.len() + Self::spared(first, last) < own || ends != [true; 2] {
            return None;
        }
        let centre = rounds[rounds.len() / 2].centre;
        let mut offs: Vec<f64> = rounds.iter().map(|r| distance(r.centre, centre)).collect();
        offs.sort_by(f64::total_cmp);
        let worst = offs[offs.len() - 1 - Self::spared(first, last)];
        (worst <= self.tolerance).then_some(worst)
    }
}
