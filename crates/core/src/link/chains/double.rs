//! Chains beside a longer one between the same faces show the same crease twice: they go.

use super::chain::Chain;
use crate::math::vec3::{add_scaled, dot, norm, sub};
use crate::measure::Edgelet;
use crate::neighbors::Index;

/// Greatest distance along and across the longer chain of an edgelet of the same crease, in spacings.
const BESIDE: (f64, f64) = (1.0, 0.8);
/// Least cosine between the faces of one crease: under noise a section may show a narrow chamfer that is none.
const FACES: f64 = 0.6;

/// What longer chains leave of each chain.
pub(super) fn remove(chains: &[Chain]) -> Vec<Chain> {
    let lengths: Vec<f64> = chains.iter().map(Chain::extent).collect();
    let all: Vec<(usize, &Edgelet)> =
        chains.iter().enumerate().flat_map(|(c, chain)| chain.members.iter().map(move |e| (c, e))).collect();
    let places: Vec<[f64; 3]> = all.iter().map(|(_, e)| e.place).collect();
    let index = Index::build(&places);
    let longer = |a: usize, b: usize| lengths[a] > lengths[b] || (lengths[a] == lengths[b] && a < b);
    let doubled = |c: usize, e: &Edgelet| {
        let mut doubled = false;
        index.around(e.place, BESIDE.0.hypot(BESIDE.1) * e.spacing, |f| {
            let (other, o) = all[f.index as usize];
            doubled |= other != c && longer(other, c) && same(e, o);
        });
        doubled
    };
    let stretches = |(c, chain): (usize, &Chain)| chain.stretches(|e| !doubled(c, e));
    chains.iter().enumerate().flat_map(stretches).collect()
}

/// Whether two edgelets show one place of one crease.
fn same(e: &Edgelet, o: &Edgelet) -> bool {
    let offset = sub(e.place, o.place);
    let along = dot(offset, o.along);
    let across = norm(add_scaled(offset, o.along, -along));
    let faces = |x: usize, y: usize| dot(e.arms[0], o.arms[x]).min(dot(e.arms[1], o.arms[y]));
    let beside = along.abs() <= BESIDE.0 * o.spacing && across <= BESIDE.1 * o.spacing;
    beside && faces(0, 1).max(faces(1, 0)) >= FACES
}
