//! Contours of neighbouring slices matched into tracks.

use super::super::vec2::distance;
use super::profile::Profile;

/// A contour followed through neighbouring slices, ascending, with the heights of the slices just outside of it.
#[derive(Clone, Debug)]
pub(super) struct Track<'a> {
    /// One profile a slice.
    pub profiles: Vec<&'a Profile>,
    /// The slice below the first profile, if there is one.
    pub below: Option<f64>,
    /// The slice above the last profile, if there is one.
    pub above: Option<f64>,
}

/// Follows contours from slice to slice: solid to solid and hole to hole, nearest first by centroid and size.
pub(super) fn tracks(levels: &[Vec<Profile>]) -> Vec<Track<'_>> {
    let mut open: Vec<(usize, Track)> = Vec::new();
    let mut done = Vec::new();
    let height = |level: usize| levels.get(level).and_then(|l| l.first()).map(|p| p.height);
    for (k, level) in levels.iter().enumerate() {
        let pairs = matched(&open, level);
        let mut next = Vec::new();
        let mut taken = vec![false; level.len()];
        for (i, (_, mut track)) in open.into_iter().enumerate() {
            match pairs.iter().find(|p| p.0 == i) {
                Some(&(_, j)) => {
                    taken[j] = true;
                    track.profiles.push(&level[j]);
                    next.push((j, track));
                }
                None => done.push(Track { above: height(k), ..track }),
            }
        }
        let below = k.checked_sub(1).and_then(height);
        for (j, profile) in level.iter().enumerate().filter(|(j, _)| !taken[*j]) {
            next.push((j, Track { profiles: vec![profile], below, above: None }));
        }
        next.sort_by_key(|n| n.0);
        open = next;
    }
    done.extend(open.into_iter().map(|o| o.1));
    done
}

/// Pairs of (open track, contour), each at most once.
fn matched(open: &[(usize, Track)], level: &[Profile]) -> Vec<(usize, usize)> {
    let mut costs = Vec::new();
    for (i, (_, track)) in open.iter().enumerate() {
        let Some(last) = track.profiles.last() else { continue };
        for (j, profile) in level.iter().enumerate().filter(|(_, p)| p.hole == last.hole) {
            let (a, b) = (last.area.sqrt(), profile.area.sqrt());
            let cost = distance(last.centroid, profile.centroid) + (a - b).abs();
            if cost <= 0.5 * a.max(b) {
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
