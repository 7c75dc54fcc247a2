//! Runs of circles about one line along the axis. Where their radii lie on a line they are a cylinder or a cone, which noise
//! or few slices have hidden.

use super::outlines::{Outlines, Reached, reach};
use crate::math::least_squares::least_squares;
use crate::math::vec2::distance;
use crate::section::stack::result::Feature;

/// Fewest slices of a revolution: two always agree, and a third may by chance.
const FEWEST_SLICES: usize = 4;

impl Outlines<'_> {
    /// The revolutions among contours `first` to before `end`, ascending.
    pub(crate) fn revolutions(&self, mut first: usize, end: usize) -> Vec<Reached> {
        let mut found = Vec::new();
        while first < end {
            let run = self.revolution(first, end);
            first = run.map_or(first + 1, |r| r.last + 1);
            found.extend(run);
        }
        found
    }

    fn revolution(&self, first: usize, end: usize) -> Option<Reached> {
        let (last, residual) = reach(first, end, FEWEST_SLICES, |last| self.concentric(first, last))?;
        let radii = self.all[first..=last].iter().filter_map(|p| p.round.map(|r| r.radius));
        let (least, most) = radii.fold((f64::INFINITY, 0.0f64), |(l, m), r| (l.min(r), m.max(r)));
        let feature = self.straight(first, last).unwrap_or(Feature::Revolution { least, most });
        Some(Reached { first, last, feature, residual, doubtful: false })
    }

    /// The cylinder or the cone that circles show if their radii, but for a few, lie on one line.
    fn straight(&self, first: usize, last: usize) -> Option<Feature> {
        let middle = 0.5 * (self.all[first].height + self.all[last].height);
        let place = |k: usize| Some([self.all[k].height - middle, self.all[k].round?.radius]);
        let all: Vec<[f64; 2]> = (first..=last).filter_map(place).collect();
        let [radius, slope] = least_squares(all.iter().map(|&[z, r]| ([1.0, z], r)))?;
        let mut offs: Vec<f64> = all.iter().map(|&[z, r]| (r - radius - slope * z).abs()).collect();
        offs.sort_by(f64::total_cmp);
        let worst = offs[offs.len() - 1 - Self::spared(first, last)];
        let span = self.all[last].height - self.all[first].height;
        if worst > self.tolerance {
            return None;
        }
        let angle_deg = slope.atan().to_degrees();
        if (slope * span).abs() <= self.tolerance && angle_deg.abs() <= self.slopes[0] {
            return Some(Feature::Extrusion { radius: Some(radius) });
        }
        // A cone leans enough for its wall to be told from a cylinder's.
        let leans = angle_deg.abs() > self.slopes[1];
        leans.then_some(Feature::Taper { angle_deg, apex: f64::NAN, radius: None })
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
