//! Verifies closing lines by the patches beside them and removes the false ones (method `segments`, robust form).
//!
//! Demarsin et al. 2007 close every line, by the shortest way if there is no other (section 2.7). Such a link may run over a
//! smooth face. The patches show it: a short strip with hardly any fold, or with the same patch on both sides, is not a
//! boundary. It is removed if the other lines at its ends stay closed without it. Without patches (`patches.find=false`) nothing
//! is removed.

use crate::math::vec3::distance;
use crate::network::{Network, Strip, StripKind};
use crate::patch::Patches;
use crate::pattern::{LineGraph, paths};
use crate::resolution::Resolution;
use std::collections::BTreeSet;

/// Length above which a strip stays in any case, spacings.
const CLEARLY_SEEN: f64 = 20.0;

/// Removes strips that are not boundaries, with a fold of less than `fold_deg`, from the crease pattern; returns whether there
/// were any.
pub fn take_back(
    crease: &mut LineGraph,
    network: &Network,
    patches: &Patches,
    resolution: Resolution,
    fold_deg: f64,
) -> bool {
    let mut degree: Vec<u32> = network.nodes.iter().map(|n| n.degree).collect();
    let mut flat: Vec<(f64, usize)> = (0..network.strips.len())
        .filter(|&s| length(&network.strips[s]) <= CLEARLY_SEEN * resolution.unit())
        .filter_map(|s| Some((flatness(&network.strips[s], patches, s)?, s)).filter(|f| f.0 < fold_deg))
        .collect();
    flat.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let mut gone: BTreeSet<&[u32]> = BTreeSet::new();
    for (_, s) in flat {
        let strip = &network.strips[s];
        if stays_closed(strip, &mut degree) {
            gone.insert(&strip.sources);
        }
    }
    for path in paths(crease) {
        let mut sources: Vec<u32> = path.vertices.iter().map(|&v| crease.points[v as usize]).collect();
        sources.dedup();
        if gone.contains(&sources[..]) {
            let closing =
                path.ends.is_none().then(|| (path.vertices[path.vertices.len() - 1], path.vertices[0]));
            path.vertices
                .windows(2)
                .map(|w| (w[0], w[1]))
                .chain(closing)
                .for_each(|(a, b)| crease.remove_edge(a, b));
        }
    }
    !gone.is_empty()
}

/// The fold of a crease that may not be a boundary, degrees; `None` for others.
fn flatness(strip: &Strip, patches: &Patches, s: usize) -> Option<f64> {
    let sides = patches.sides[s];
    let (StripKind::Crease, Some(left), Some(right)) = (strip.kind, sides.left, sides.right) else {
        return None;
    };
    let known = !patches.patches[left as usize].fit.free;
    let fold = match left == right {
        true if known => 0.0,
        true => strip.fold_deg.unwrap_or(0.0),
        false => sides.fold_deg?,
    };
    Some(fold)
}

/// Subtracts the strip from the degrees of its nodes, unless that leaves a loose end.
fn stays_closed(strip: &Strip, degree: &mut [u32]) -> bool {
    let (Some(a), Some(b)) = (strip.start, strip.end) else { return true };
    let [a, b] = [a as usize, b as usize];
    let taken = if a == b { 2 } else { 1 };
    let stays = |n: usize| degree[n].checked_sub(taken).is_some_and(|left| left != 1);
    if !stays(a) || !stays(b) {
        return false;
    }
    degree[a] -= 1;
    degree[b] -= 1;
    true
}

fn length(strip: &Strip) -> f64 {
    strip.points.windows(2).map(|w| distance(w[0], w[1])).sum()
}
