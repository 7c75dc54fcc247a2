//! Where a run begins and ends: at a face across the axis beside its outline, where its wall folds into a slanted one,
//! where it meets the next run, at the apex of a taper, or else where the points of its wall end. All of these lie between
//! two slices, and are found in the points there.

mod apex;
mod border;
mod crest;
mod end;
mod face;
mod fold;
mod ground;
mod meet;
mod parts;
mod rim;
mod search;
mod size;
mod split;

use super::kinds::outlines::{CLEAR_OF_FOLD, upright_deg};
use super::result::Feature;
use super::runs::Found;
use crate::frame::Localised;
use crate::neighbors::Index;
use crate::parallel;
use crate::section::result::Sections;
use crate::section::surface::tiles::Tiles;
use end::{By, End};
use ground::{Ground, Spot, ahead_of_start};
use search::{Search, searches};
use size::Size;

/// Sets `from`, `to`, `range_error` of every run, and the apex and the radius of a taper, from the points between its slices
/// and those just outside. The runs of a track come one after another. A taper is kept only if it ends at an edge, and
/// an extrusion between two of which only the inner contours tell: any piece of a curved wall may look like one.
pub(super) fn refine(
    local: &Localised,
    index: &Index,
    tiles: &Tiles,
    sections: &Sections,
    tolerance: f64,
    runs: &mut Vec<Found>,
) {
    let sizes =
        parallel::map(runs.len(), parallel::TASK, |r| Size::new(&runs[r], sections.spacing, tolerance));
    let searches: Vec<Search> =
        runs.iter().zip(&sizes).flat_map(|(r, size)| searches(r, size, sections)).collect();
    let near = Ground::new(local, index, tiles, sections).near(&searches);
    let mut ends = parallel::map(searches.len(), parallel::TASK, |k| {
        end(&searches[k], &near[k], &sizes[k / 2], sections)
    });
    let rims: Vec<bool> = ends.iter().map(|e| e.is_some_and(|e| e.by == By::Rim)).collect();
    for k in 1..runs.len() {
        if runs[k - 1].joins_next {
            let between = [runs[k - 1].last().height, runs[k].profiles[0].height];
            let meeting = sizes[k - 1].meets(&sizes[k], between, sections.spacing);
            let (before, after) = ends.split_at_mut(2 * k);
            meet(&mut before[2 * k - 1], &mut after[0], meeting, sections.spacing);
        }
    }
    split::share(&searches, &mut ends);
    for ((found, ends), size) in runs.iter_mut().zip(ends.chunks(2)).zip(&sizes) {
        let run = &mut found.run;
        let set = |end: Option<End>, at: &mut f64, error: &mut f64| {
            if let Some(end) = end {
                (*at, *error) = (end.height, end.error);
            }
        };
        set(ends[0], &mut run.from, &mut run.range_error[0]);
        set(ends[1], &mut run.to, &mut run.range_error[1]);
        if let Feature::Taper { apex, radius, .. } = &mut run.feature {
            *apex = size.apex();
            *radius = size.radius(run.from);
        }
    }
    for k in 1..runs.len() {
        let folds = |end: &Option<End>| end.is_some_and(|e| matches!(e.by, By::Fold | By::Rim | By::Meeting));
        if runs[k - 1].joins_next && folds(&ends[2 * k]) {
            continue_radius(&runs[k - 1].run.feature.clone(), &mut runs[k].run.feature);
        }
    }
    let kept: Vec<bool> = (0..runs.len()).map(|k| holds(k, runs, &ends, &rims, sections)).collect();
    let mut kept = kept.into_iter();
    runs.retain(|_| kept.next().unwrap_or(true));
}

/// Whether the ends of a run bear out its contours.
fn holds(k: usize, runs: &[Found], ends: &[Option<End>], rims: &[bool], sections: &Sections) -> bool {
    let own = [ends[2 * k], ends[2 * k + 1]];
    let by = |of: fn(&End) -> bool| own.iter().flatten().any(of);
    match runs[k].run.feature {
        Feature::Taper { .. } => {
            // Beyond the rim of a curved wall nothing is even.
            let below = k > 0 && runs[k - 1].joins_next && rims[2 * k - 1];
            let above = runs[k].joins_next && rims.get(2 * k + 2) == Some(&true);
            let sure = !runs[k].doubtful
                || own.iter().all(Option::is_some) && by(|e| matches!(e.by, By::Face | By::Fold));
            by(|e| e.by.is_edge()) && sure && !below && !above
        }
        Feature::Extrusion { .. } => {
            let edged = by(|e| matches!(e.by, By::Face | By::Fold));
            !runs[k].doubtful || edged && stands(&runs[k], sections)
        }
        Feature::Revolution { .. } => true,
    }
}

/// Whether the walls of a run stand along the axis, but for one contour in four, clear of where it ends.
fn stands(found: &Found, sections: &Sections) -> bool {
    let (run, clear) = (&found.run, CLEAR_OF_FOLD * sections.spacing);
    let own = found.profiles.iter().filter(|p| (p.height - run.from).min(run.to - p.height) >= clear);
    let (mut count, mut upright) = (0, 0);
    for profile in own {
        count += 1;
        upright += usize::from(profile.steepest_deg <= upright_deg(sections.noise));
    }
    4 * upright >= 3 * count
}

/// Gives a wall that continues across a fold the same radius, which an extrusion shows better than a short taper.
fn continue_radius(below: &Feature, above: &mut Feature) {
    if let (Feature::Extrusion { radius: Some(known) }, Feature::Taper { radius: Some(radius), .. }) =
        (below, above)
    {
        *radius = *known;
    }
}

/// One end of a run, by the first that its points show, going away from its slice.
fn end(search: &Search, spots: &[Spot], size: &Size, sections: &Sections) -> Option<End> {
    let (h, noise) = (sections.spacing, sections.noise);
    let near = ahead_of_start(search, spots);
    let face = face::face(search, near, h, noise);
    let fold = if search.partly_upright() { fold::fold(search, spots, h, noise) } else { None };
    // Beside a face planes lean as well: a fold so near to one is its edge.
    let edge = (fold::CLEAR_OF_EDGE.0 + fold::CLEAR_OF_EDGE.1 * noise) * h;
    let nearer = |a: End, b: End| {
        if search.ahead(a.height) <= search.ahead(b.height) + edge { a } else { b }
    };
    let first = match (face, fold) {
        (Some(a), Some(b)) => Some(nearer(a, b)),
        (a, b) => a.or(b),
    };
    let apex = || apex::apex(search, near, size, h);
    first.or_else(apex).or_else(|| border::border(search, near, h, noise))
}

/// Ends two runs that meet at the same height if only one of them shows it, or neither.
fn meet(a: &mut Option<End>, b: &mut Option<End>, meeting: Option<(f64, f64)>, h: f64) {
    let sure = |e: &Option<End>| e.filter(|e| matches!(e.by, By::Face | By::Fold | By::Rim));
    let fold = |e: &End| matches!(e.by, By::Fold | By::Rim);
    let folds = [&*a, &*b].into_iter().filter_map(sure).find(fold);
    if let (Some(fold), Some((height, error))) = (folds, meeting) {
        // Two long runs tell their meeting better than the points beside it.
        let same = (height - fold.height).abs() <= 3.0 * (fold.error + error) + 0.5 * h;
        let faces = [&*a, &*b].into_iter().flatten().any(|e| e.by == By::Face);
        if error < fold.error && same && !faces {
            let end = Some(End { height, error, by: By::Meeting });
            (*a, *b) = (end, end);
            return;
        }
    }
    match (sure(a), sure(b)) {
        (Some(_), Some(_)) => {}
        (Some(end), None) if fold(&end) => *b = Some(end),
        (None, Some(end)) if fold(&end) => *a = Some(end),
        (one, other) => {
            let Some((height, error)) = meeting else { return };
            let end = Some(End { height, error: error.min(0.3 * h), by: By::Meeting });
            if one.is_none() {
                *a = end;
            }
            if other.is_none() {
                *b = end;
            }
        }
    }
}
