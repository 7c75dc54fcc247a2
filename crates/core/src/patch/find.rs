//! Finds the patches of a network, step by step.

use super::ground::{Ground, NO_PATCH};
use super::patches::{Patch, Patches};
use super::sides::Sides;
use super::{area, beside, fit, flood, loops, orient, sides, stations};
use crate::network::Network;

/// The patches bounded by the strips of `network`, all in the local frame.
pub(crate) fn patches(ground: &Ground, network: &Network) -> Patches {
    let stations = stations::stations(network, ground.scales, ground.points.len());
    let (stations, beside) = beside::beside(ground, stations);
    let label = flood::flood(ground, &beside);
    let count = label.iter().filter(|&&l| l != NO_PATCH).max().map_or(0, |&l| l as usize + 1);
    let area = area::areas(ground, &label, &stations, &beside);
    let normals = orient::outward(ground, &label, count, &stations, &beside, &area);
    let members = members(&label, count);
    let fits = fit::fits(ground, &normals, &members, &beside);
    let sides = sides::sides(network, &label, &normals, &stations, &beside, &fits);
    let loops = loops::loops(network, &sides, &members, &normals);
    let patches = loops.into_iter().zip(fits).enumerate().map(|(p, (loops, fit))| Patch {
        neighbors: across(&sides, p as u32),
        points: members[p].len(),
        area: members[p].iter().map(|&i| area[i as usize]).sum(),
        loops,
        fit,
    });
    Patches { patches: patches.collect(), label, sides }
}

/// The points of each patch, ascending.
fn members(label: &[u32], count: usize) -> Vec<Vec<u32>> {
    let mut members = vec![Vec::new(); count];
    for (i, &l) in label.iter().enumerate().filter(|(_, l)| **l != NO_PATCH) {
        members[l as usize].push(i as u32);
    }
    members
}

/// The patches across the strips of patch `p`.
fn across(sides: &[Sides], p: u32) -> Vec<u32> {
    let other = |s: &Sides| match (s.left, s.right) {
        (Some(a), Some(b)) if a == p && b != p => Some(b),
        (Some(a), Some(b)) if b == p && a != p => Some(a),
        _ => None,
    };
    let mut all: Vec<u32> = sides.iter().filter_map(other).collect();
    all.sort_unstable();
    all.dedup();
    all
}
