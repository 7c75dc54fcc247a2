//! Tracks cut into runs.

use super::kinds;
use super::kinds::outlines::{Outlines, Reached};
use super::profile::Profile;
use super::result::Run;
use super::track::Track;
use crate::section::result::Sections;

/// One contour in so many that lies within another makes a run a hole: around the rest that other one is not closed.
const HOLE: usize = 5;
/// Most contours between two runs that meet: slices at the very edge may belong to neither.
const BETWEEN: usize = 2;

/// A run with its contours, ascending.
pub(super) struct Found<'a> {
    pub run: Run,
    pub profiles: Vec<&'a Profile>,
    /// Whether the next run of the track begins where this one ends.
    pub joins_next: bool,
    /// Whether its contours alone show it too little, so that its ends must.
    pub doubtful: bool,
}

impl<'a> Found<'a> {
    /// The middle contour.
    pub(super) fn middle(&self) -> &'a Profile {
        self.profiles[self.profiles.len() / 2]
    }

    /// The highest contour.
    pub(super) fn last(&self) -> &'a Profile {
        self.profiles[self.profiles.len() - 1]
    }
}

/// The runs of a track, ascending.
pub(super) fn runs<'a>(track: &Track<'a>, sections: &Sections, tolerance: f64) -> Vec<Found<'a>> {
    let all = &track.profiles;
    let outlines = Outlines::new(all, tolerance, sections.spacing, sections.noise);
    let reached = kinds::runs(&outlines);
    let meets = |a: &Reached, b: &Reached| b.first - a.last <= BETWEEN + 1;
    let found = |(i, r): (usize, &Reached)| {
        let before = i.checked_sub(1).map(|i| &reached[i]).filter(|b| meets(b, r));
        let after = reached.get(i + 1).filter(|a| meets(r, a));
        // A run ends before the next begins, or before the first contour that clearly shows another outline.
        let other = |k: &usize| !outlines.nearly(if *k < r.first { r.first } else { r.last }, *k);
        let third = |k: usize| (k < all.len()).then_some(k);
        let below = match before {
            Some(b) => Some(b.last),
            None => (0..r.first).rev().take(BETWEEN).find(other).or(r.first.checked_sub(BETWEEN + 1)),
        };
        let above = match after {
            Some(a) => Some(a.first),
            None => {
                let near = (r.last + 1..all.len()).take(BETWEEN).find(other);
                near.or(third(r.last + BETWEEN + 1))
            }
        };
        let height = |k: usize| all[k].height;
        let beside = [below.map(height).or(track.below), above.map(height).or(track.above)];
        let own = all[r.first..=r.last].to_vec();
        Found {
            run: run(&own, beside, r, sections),
            profiles: own,
            joins_next: after.is_some(),
            doubtful: r.doubtful,
        }
    };
    reached.iter().enumerate().map(found).collect()
}

fn run(own: &[&Profile], beside: [Option<f64>; 2], reached: &Reached, sections: &Sections) -> Run {
    let (first, last) = (own[0], own[own.len() - 1]);
    let middle = own[own.len() / 2];
    let [x, y] = middle.round.map_or(middle.centroid, |r| r.centre);
    let ends = [(first.height, beside[0]), (last.height, beside[1])];
    let [from, to] = ends.map(|(own, next)| next.map_or(own, |n| 0.5 * (own + n)));
    let range_error = ends.map(|(own, next)| next.map_or(f64::INFINITY, |n| 0.5 * (n - own).abs()));
    Run {
        feature: reached.feature,
        hole: HOLE * own.iter().filter(|p| p.hole).count() >= own.len(),
        from,
        to,
        range_error,
        residual: reached.residual,
        centre: sections.frame.vector([x, y, middle.height]),
        contours: own.iter().map(|p| p.id).collect(),
    }
}
