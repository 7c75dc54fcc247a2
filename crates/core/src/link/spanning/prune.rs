//! Pruning of short branches (Gumhold 2001, section 3.3).

use super::rule::CycleRule;
use super::walk::Walker;
use crate::pattern::LineGraph;

/// Removes branches less deep than `branch` (half of `rho` as printed), but leaves each singleton end its longest path.
///
/// The paper's two steps are one rule here: at a vertex with `n` long branches, all short ones go except the `2 - n` deepest.
/// This is repeated until nothing changes, as a removal can turn a junction into a singleton end.
pub(crate) fn prune(lines: &mut LineGraph, rule: CycleRule) {
    let mut walker = Walker::new(lines.edges.len(), rule.metric);
    loop {
        let mut changed = false;
        for v in 0..lines.edges.len() as u32 {
            if lines.edges[v as usize].len() > 2 {
                changed |= prune_at(lines, &mut walker, v, rule.branch);
            }
        }
        if !changed {
            break;
        }
    }
}

fn prune_at(lines: &mut LineGraph, walker: &mut Walker, v: u32, long: f64) -> bool {
    let mut depths: Vec<(f64, u32)> =
        lines.edges[v as usize].clone().into_iter().map(|w| (walker.depth(lines, v, w, long), w)).collect();
    depths.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let long_count = depths.iter().filter(|d| d.0.is_infinite()).count();
    let gone = &depths[long_count.max(2)..];
    for &(_, first) in gone {
        remove_branch(lines, v, first);
    }
    !gone.is_empty()
}

/// Removes the tree attached to `root` through `first`.
pub(crate) fn remove_branch(lines: &mut LineGraph, root: u32, first: u32) {
    lines.remove_edge(root, first);
    let mut open = vec![first];
    while let Some(v) = open.pop() {
        for w in std::mem::take(&mut lines.edges[v as usize]) {
            lines.edges[w as usize].retain(|&x| x != v);
            open.push(w);
        }
    }
}
