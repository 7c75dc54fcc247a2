//! Shells: faces that hang together by their edges.

use super::{Face, Shell};
use crate::math::union_find::UnionFind;
use std::collections::BTreeMap;

pub(super) fn shells(faces: &[Face]) -> Vec<Shell> {
    let mut uses: BTreeMap<u32, Vec<(u32, bool)>> = BTreeMap::new();
    for (f, face) in (0..).zip(faces) {
        face.loops
            .iter()
            .flatten()
            .for_each(|&(edge, forward)| uses.entry(edge).or_default().push((f, forward)));
    }
    let mut sets = UnionFind::new(faces.len());
    for own in uses.values() {
        own.windows(2).for_each(|w| {
            sets.union(w[0].0, w[1].0);
        });
    }
    let mut found: BTreeMap<u32, Shell> = BTreeMap::new();
    for f in 0..faces.len() as u32 {
        let shell = found.entry(sets.find(f)).or_insert(Shell { faces: Vec::new(), closed: true });
        shell.faces.push(f);
    }
    for own in uses.values() {
        let both = own.len() == 2 && own[0].1 != own[1].1;
        if let Some(shell) = found.get_mut(&sets.find(own[0].0)).filter(|_| !both) {
            shell.closed = false;
        }
    }
    let mut shells: Vec<Shell> = found.into_values().collect();
    shells.sort_by_key(|s| s.faces[0]);
    shells
}
