//! `G_pruned_branches` (Demarsin et al. 2007, section 2.6, Algorithm 2).

use crate::link::spanning::{Metric, Walker, remove_branch};
use crate::pattern::LineGraph;

/// Algorithm 2 as printed, with depths in edges: at a vertex with two or more long branches all short ones go; with exactly
/// one, all short ones but the deepest; with none, nothing.
pub fn prune_branches(lines: &mut LineGraph, depth: usize) {
    let mut walker = Walker::new(lines.edges.len(), Metric::Edges);
    for v in 0..lines.edges.len() as u32 {
        if lines.edges[v as usize].len() <= 2 {
            continue;
        }
        let mut depths: Vec<(f64, u32)> =
            lines.edges[v as usize].iter().map(|&w| (walker.depth(lines, v, w, depth as f64), w)).collect();
        depths.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        let long = depths.iter().filter(|d| d.0.is_infinite()).count();
        if long >= 1 {
            for &(_, first) in &depths[long.max(2).min(depths.len())..] {
                remove_branch(lines, v, first);
            }
        }
    }
}
