//! Contours of neighbouring slices matched into tracks.

use super::profile::Profile;
use crate::math::vec2::distance;

/// Fewest slices of each kind where solid turns into a hole for good.
const SIDE_SLICES: usize = 3;

/// A contour followed through neighbouring slices, ascending, with the heights of the slices just outside of it.
#[derive(Clone, Debug)]
pub(super) struct Track<'a> {
    /// One profile a slice; a slice in between may lack it.
    pub profiles: Vec<&'a Profile>,
    /// The slice below the first profile, if there is one.
    pub below: Option<f64>,
    /// The slice above the last profile, if there is one.
    pub above: Option<f64>,
}

/// A track that may go on.
struct Open<'a> {
    /// Index of its last profile in its level.
    last: usize,
    /// Slices since then.
    missed: usize,
    track: Track<'a>,
}

/// Follows contours from slice to slice: solid to solid and hole to hole, or the same outline, nearest first by centroid
/// and size. A slice that does not show a contour closed is passed over where `shown` says that it lies there nevertheless, at most so many `missed` in a row.
pub(super) fn tracks<'a>(
    levels: &'a [Vec<Profile>],
    heights: &[f64],
    tolerance: f64,
    missed: usize,
    shown: impl Fn(usize, &Profile) -> bool,
) -> Vec<Track<'a>> {
    let mut open: Vec<Open> = Vec::new();
    let mut done = Vec::new();
    for (k, level) in levels.iter().enumerate() {
        let pairs = matched(&open, level, tolerance);
        let mut next = Vec::new();
        let mut taken = vec![false; level.len()];
        for (i, mut one) in open.into_iter().enumerate() {
            let found = pairs.iter().find(|p| p.0 == i).map(|p| p.1);
            let passes = || one.missed < missed && one.track.profiles.last().is_some_and(|p| shown(k, p));
            if let Some(j) = found {
                taken[j] = true;
                one.track.profiles.push(&level[j]);
                next.push(Open { last: j, missed: 0, ..one });
            } else if passes() {
                next.push(Open { missed: one.missed + 1, ..one });
            } else {
                done.push(Track { above: Some(heights[k]), ..one.track });
            }
        }
        for (j, profile) in level.iter().enumerate().filter(|(j, _)| !taken[*j]) {
            let lowest = (k.saturating_sub(missed)..k).rev().take_while(|&l| shown(l, profile)).last();
            let below = lowest.unwrap_or(k).checked_sub(1).map(|k| heights[k]);
            let track = Track { profiles: vec![profile], below, above: None };
            next.push(Open { last: j, missed: 0, track });
        }
        next.sort_by_key(|n| (n.missed, n.last));
        open = next;
    }
    done.extend(open.into_iter().map(|o| o.track));
    done.into_iter().flat_map(sides).collect()
}

/// A track in two where a hole goes on as a solid of the same outline, or the other way round.
fn sides(track: Track) -> Vec<Track> {
    let all = &track.profiles;
    let turns = |k: &usize| all[*k].hole != all[k - 1].hole;
    let mut turn = (1..all.len()).filter(turns);
    match (turn.next(), turn.next()) {
        (Some(k), None) if k >= SIDE_SLICES && all.len() - k >= SIDE_SLICES => {
            let (low, high) = all.split_at(k);
            let (above, below) = (Some(high[0].height), Some(low[k - 1].height));
            let low = Track { profiles: low.to_vec(), below: track.below, above };
            vec![low, Track { profiles: high.to_vec(), below, above: track.above }]
        }
        _ => vec![track],
    }
}

/// Pairs of (open track, contour), each at most once.
fn matched(open: &[Open], level: &[Profile], tolerance: f64) -> Vec<(usize, usize)> {
    let mut costs = Vec::new();
    for (i, one) in open.iter().enumerate() {
        let Some(last) = one.track.profiles.last() else { continue };
        for (j, profile) in level.iter().enumerate() {
            let (a, b) = (last.area.sqrt(), profile.area.sqrt());
            let cost = distance(last.centroid, profile.centroid) + (a - b).abs();
            // Where the outline around a hole is not closed, the hole looks solid.
            let one = || cost <= 8.0 * tolerance && last.apart(profile, [0.0; 2]).mean <= 2.0 * tolerance;
            if cost <= 0.5 * a.max(b) && (profile.hole == last.hole || one()) {
                costs.push((cost, i, j));
            }
        }
    }
    costs.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let (mut left, mut right) = (vec![false; open.len()], vec![false; level.len()]);
    let mut pairs = Vec::new();
    for (_, i, j) in costs {
        if !left[i] && !right[j] {
            (left[i], right[j]) = (true, true);
            pairs.push((i, j));
        }
    }
    pairs
}
