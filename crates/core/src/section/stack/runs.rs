//! Tracks cut into runs.

use super::super::result::Sections;
use super::kinds::{Kinds, Reached};
use super::profile::Profile;
use super::track::Track;
use super::{Feature, Run};

/// A run with its lowest, middle and highest contour.
pub(super) struct Found<'a> {
    pub run: Run,
    pub profiles: [&'a Profile; 3],
    /// Heights at which the wall of an extrusion folds into a slanted one, below and above.
    pub folds: [Option<f64>; 2],
}

/// The runs of a track. Extrusions come first, as they are the strictest: where the outline stays and then jumps. What
/// lies between them is the taper or revolution that reaches farthest; a run of one slice is none.
pub(super) fn runs<'a>(track: &Track<'a>, sections: &Sections, tolerance: f64) -> Vec<Found<'a>> {
    let all = &track.profiles;
    let kinds = Kinds::new(all, tolerance, sections.noise);
    let mut found = Vec::new();
    let mut next = Next::default();
    let mut first = 0;
    while first + 1 < all.len() {
        let (start, extrusion) = next.extrusion(&kinds, first, all.len());
        let best = if start == first { extrusion } else { farthest(&kinds, first, start) };
        let Some((last, feature, residual)) = best else {
            first += 1;
            continue;
        };
        let own = &all[first..=last];
        let below = if first == 0 { track.below } else { Some(all[first - 1].height) };
        let above = if last + 1 == all.len() { track.above } else { Some(all[last + 1].height) };
        let run = run(own, [below, above], feature, residual, sections);
        let folds = match feature {
            Feature::Extrusion { .. } => [
                kinds.fold(first, [first.checked_sub(1), first.checked_sub(2)]),
                kinds.fold(last, [Some(last + 1), Some(last + 2)]),
            ],
            _ => [None; 2],
        };
        found.push(Found { run, profiles: [own[0], own[own.len() / 2], own[own.len() - 1]], folds });
        first = last + 1;
    }
    found
}

/// The taper or revolution that reaches farthest; the taper says more of the two.
fn farthest(kinds: &Kinds, first: usize, end: usize) -> Option<Reached> {
    let both = [kinds.taper(first, end), kinds.revolution(first, end)];
    both.into_iter().flatten().reduce(|a, b| if b.0 > a.0 { b } else { a })
}

/// The next extrusion ahead, kept until it is passed.
#[derive(Default)]
struct Next(Option<(usize, Option<Reached>)>);

impl Next {
    /// Where the next extrusion at or after `first` begins, with it; `end` if there is none.
    fn extrusion(&mut self, kinds: &Kinds, first: usize, end: usize) -> (usize, Option<Reached>) {
        if let Some(known) = self.0.filter(|known| known.0 >= first) {
            return known;
        }
        let start = (first..end).find_map(|k| kinds.extrusion(k).map(|e| (k, Some(e))));
        *self.0.insert(start.unwrap_or((end, None)))
    }
}

fn run(
    own: &[&Profile],
    beside: [Option<f64>; 2],
    feature: Feature,
    residual: f64,
    sections: &Sections,
) -> Run {
    let (first, last) = (own[0], own[own.len() - 1]);
    let middle = own[own.len() / 2];
    let [x, y] = middle.round.map_or(middle.centroid, |r| r.centre);
    let ends = [(first.height, beside[0]), (last.height, beside[1])];
    let [from, to] = ends.map(|(own, next)| next.map_or(own, |n| 0.5 * (own + n)));
    let range_error = ends.map(|(own, next)| next.map_or(f64::INFINITY, |n| 0.5 * (n - own).abs()));
    Run {
        feature,
        hole: first.hole,
        from,
        to,
        range_error,
        residual,
        centre: sections.frame.vector([x, y, middle.height]),
        contours: own.iter().map(|p| p.id).collect(),
    }
}
