//! Algorithm 2, the pruning of short branches: from `G_pruned_mst` to `G_pruned_branches` (Demarsin et al. 2007, section 2.6).

use crate::link::spanning::{Metric, Walker, remove_branch};
use crate::pattern::LineGraph;

/// Algorithm 2 as printed, `depth` being `d_max` in edges.
///
/// At each vertex with more than two edges: if at least two branches have depth `d_max` or more, all shorter ones go; if
/// exactly one has, the shorter ones go except the deepest; if none has, nothing goes.
pub fn prune_branches(lines: &mut LineGraph, depth: usize) {
    let mut walker = Walker::new(lines.edges.len(), Metric::Edges);
    for v in 0..lines.edges.len() as u32 {
        if lines.edges[v as usize].len() <= 2 {
            continue;
        }
        let mut depths: Vec<(f64, u32)> =
            lines.edges[v as usize].iter().map(|&w| (walker.depth(lines, v, w, depth as f64), w)).collect();
        depths.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        // Branches of depth `d_max` and more are infinitely deep to the walker.
        let long = depths.iter().filter(|d| d.0.is_infinite()).count();
        if long >= 1 {
            for &(_, first) in &depths[long.max(2).min(depths.len())..] {
                remove_branch(lines, v, first);
            }
        }
    }
}
