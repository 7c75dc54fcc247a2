//! Edgelets joined to chains: each to the best one ahead and the best one behind, where both agree.

use super::chain::{Chain, extent};
use crate::math::vec3::{cross, dot, norm, sub};
use crate::measure::Edgelet;
use crate::neighbors::Index;
use std::collections::VecDeque;

/// Greatest distance of edgelets that follow each other, in spacings, and the least along the crease.
const STEP: (f64, f64) = (2.4, 0.2);
/// Greatest distance across as a share of that along, and what is added to it in spacings.
const ASIDE: (f64, f64) = (0.35, 0.1);
/// Least cosine between their directions.
const ALIGNED: f64 = 0.8;
/// Greatest ratio of the radii of a round at edgelets that follow each other.
const RADII: f64 = 1.4;
/// Cost of a distance across beside one along.
const ACROSS: f64 = 2.0;
/// Least number of edgelets of a closed chain.
const RING: usize = 4;

/// All edgelets in chains, some of them of one.
pub(super) fn join(edgelets: &[Edgelet]) -> Vec<Chain> {
    let best = best(edgelets);
    let mutual = |i: usize, k: usize| best[i][k].filter(|&j| best[j].contains(&Some(i)));
    let mut used = vec![false; edgelets.len()];
    let mut chains = Vec::new();
    for i in 0..edgelets.len() {
        if used[i] {
            continue;
        }
        used[i] = true;
        let (path, closed) = walk(i, &mutual, &mut used);
        let members: Vec<Edgelet> = path.iter().map(|&j| edgelets[j]).collect();
        let longest = extent(&members) / edgelets[i].spacing;
        chains.push(Chain { members, closed, longest });
    }
    chains
}

/// The path through edgelet `i` in both directions, and whether it is closed.
fn walk(
    i: usize,
    mutual: &impl Fn(usize, usize) -> Option<usize>,
    used: &mut [bool],
) -> (VecDeque<usize>, bool) {
    let mut path = VecDeque::from([i]);
    for k in 0..2 {
        let (mut from, mut at) = (i, mutual(i, k));
        while let Some(j) = at {
            if used[j] {
                if j == i && path.len() >= RING {
                    return (path, true);
                }
                break;
            }
            used[j] = true;
            if k == 0 {
                path.push_front(j)
            } else {
                path.push_back(j)
            }
            let next = [0, 1].into_iter().filter_map(|q| mutual(j, q)).find(|&n| n != from);
            (from, at) = (j, next);
        }
    }
    (path, false)
}

/// The best edgelet behind and ahead of each one, by its direction.
fn best(edgelets: &[Edgelet]) -> Vec<[Option<usize>; 2]> {
    let places: Vec<[f64; 3]> = edgelets.iter().map(|e| e.place).collect();
    let index = Index::build(&places);
    let mut near = Vec::new();
    let of = |(i, e): (usize, &Edgelet)| {
        near.clear();
        index.around(e.place, STEP.0 * e.spacing, |f| near.push(f.index as usize));
        near.sort_unstable();
        let mut best = [None; 2];
        let mut least = [f64::INFINITY; 2];
        for &j in near.iter().filter(|&&j| j != i) {
            let Some((ahead, cost)) = cost(e, &edgelets[j]) else { continue };
            let k = usize::from(ahead);
            if cost < least[k] {
                (least[k], best[k]) = (cost, Some(j));
            }
        }
        best
    };
    edgelets.iter().enumerate().map(of).collect()
}

/// Whether `o` lies ahead of `e`, and what it costs to go there; `None` where it does not follow.
fn cost(e: &Edgelet, o: &Edgelet) -> Option<(bool, f64)> {
    let offset = sub(o.place, e.place);
    let along = dot(offset, e.along);
    let across = norm(cross(offset, e.along));
    let (share, more) = ASIDE;
    let alike = e.radius.max(o.radius) <= RADII * e.radius.min(o.radius);
    let follows = alike
        && dot(e.along, o.along).abs() >= ALIGNED
        && across <= share * along.abs() + more * e.spacing
        && along.abs() >= STEP.1 * e.spacing;
    follows.then_some((along > 0.0, along.abs() + ACROSS * across))
}
