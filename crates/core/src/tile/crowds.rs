//! Crowds of points without support, gathered from all tiles: a crowd is judged as a whole, wherever it ends.

use super::set::Set;
use crate::math::union_find::UnionFind;
use crate::surface::reach::LocalKnown;
use crate::surface::{Crowd, Local, links};

/// A point of a crowd with what it is linked to; points are known by their indices in the input.
pub(super) struct Member {
    point: u32,
    deep: bool,
    touches: bool,
    links: Vec<u32>,
}

/// The tile's own points in crowds, and whether all of them are known.
pub(super) fn members(set: &Set, local: &Local, known: &LocalKnown) -> (Vec<Member>, bool) {
    let member = |i: usize| {
        let (others, touches) = links(&set.positions, &set.nearest, &local.marks, i);
        let links = others.into_iter().map(|j| set.source[j as usize]).collect();
        Member { point: set.source[i], deep: local.marks.deep[i], touches, links }
    };
    let own = set.own().filter(|&i| local.marks.crowd[i]);
    (own.map(member).collect(), set.is_known(&known.crowd))
}

/// The members of crowds that are clutter, ascending.
pub(super) fn clutter(mut members: Vec<Member>) -> Vec<u32> {
    members.sort_unstable_by_key(|m| m.point);
    let place = |point: u32| members.binary_search_by_key(&point, |m| m.point).ok();
    let mut sets = UnionFind::new(members.len());
    for (m, member) in members.iter().enumerate() {
        for other in member.links.iter().filter_map(|&j| place(j)) {
            sets.union(m as u32, other as u32);
        }
    }
    let mut crowds = vec![Crowd::default(); members.len()];
    for (m, member) in members.iter().enumerate() {
        crowds[sets.find(m as u32) as usize].add(member.deep, member.touches);
    }
    let mut is_clutter = |m: usize| crowds[sets.find(m as u32) as usize].is_clutter();
    (0..members.len()).filter(|&m| is_clutter(m)).map(|m| members[m].point).collect()
}
